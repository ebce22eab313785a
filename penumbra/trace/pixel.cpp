// SPDX-License-Identifier: MIT
#include "penumbra/trace/pixel.h"

namespace penumbra {
namespace {

std::uint64_t pixel_key(std::uint64_t seed, std::uint32_t x, std::uint32_t y) {
  return hash(seed, std::uint64_t(y) << 32 | x);
}

}  // namespace

std::uint64_t point_key(std::uint64_t seed, const PixelSample& sample, std::uint64_t path) {
  return hash(hash(pixel_key(seed, sample.x, sample.y), sample.sample), path);
}

CameraRays::CameraRays(const Camera& camera, const RenderOptions& options)
    : frame_(frame(camera, double(options.width) / options.height)),
      near_(camera.near),
      width_(options.width),
      height_(options.height),
      seed_(options.seed),
      offset_(options.pixel_point == PixelPoint::center ? 0.5f : 0),
      pattern_(options.samples_per_pixel) {}

void CameraRays::of_pixel(std::uint32_t x, std::uint32_t y, std::vector<CameraRay>& rays) const {
  const std::uint64_t pixel = pixel_key(seed_, x, y);
  const std::uint32_t count = pattern_.size();
  rays.clear();
  std::vector<float> u(count, offset_), v(count, offset_);
  if (count > 1) pattern_.scramble(pixel, u, v);
  for (std::uint32_t s = 0; s < count; ++s) {
    const double right = 2 * (x + double(u[s])) / width_ - 1,
                 down = 2 * (y + double(v[s])) / height_ - 1;
    const CameraLine line = line_at(frame_, right, down);
    rays.push_back({line.origin + line.direction * near_, line.direction, hash(pixel, s)});
  }
}

std::optional<PixelSample> find_sample(const RenderOptions& options, std::uint64_t path,
                                       std::uint32_t light, std::uint64_t key) {
  for (std::uint32_t y = 0; y < options.height; ++y)
    for (std::uint32_t x = 0; x < options.width; ++x)
      for (std::uint32_t s = 0; s < options.samples_per_pixel; ++s)
        if (light_key(point_key(options.seed, {x, y, s}, path), light) == key)
          return PixelSample{x, y, s};
  return {};
}

}  // namespace penumbra
