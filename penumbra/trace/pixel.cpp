// SPDX-License-Identifier: MIT
#include "penumbra/trace/pixel.h"

namespace penumbra {

CameraRays::CameraRays(const Camera& camera, const RenderOptions& options)
    : frame_(frame(camera, double(options.width) / options.height)),
      near_(camera.near),
      width_(options.width),
      height_(options.height),
      seed_(options.seed),
      pattern_(options.samples_per_pixel) {}

void CameraRays::of_pixel(std::uint32_t x, std::uint32_t y, std::vector<CameraRay>& rays) const {
  const std::uint64_t pixel = hash(seed_, std::uint64_t(y) << 32 | x);
  const std::uint32_t count = pattern_.size();
  rays.clear();
  std::vector<float> u(count, 0.5f), v(count, 0.5f);
  if (count > 1) pattern_.scramble(pixel, u, v);
  for (std::uint32_t s = 0; s < count; ++s) {
    const double right = 2 * (x + double(u[s])) / width_ - 1,
                 down = 2 * (y + double(v[s])) / height_ - 1;
    const Vec3d direction = frame_.forward + frame_.right * right - frame_.up * down;
    rays.push_back({frame_.origin + direction * near_, direction, hash(pixel, s)});
  }
}

}  // namespace penumbra
