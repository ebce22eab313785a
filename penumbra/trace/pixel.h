// SPDX-License-Identifier: MIT
// Samples of a pixel: where their camera rays go, and their keys.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "penumbra/geometry/sample_pattern.h"
#include "penumbra/scene/camera.h"
#include "penumbra/trace/render.h"

namespace penumbra {

/// One camera ray.
struct CameraRay {
  Vec3d origin, direction;
  std::uint64_t key;  ///< of the pixel and sample: what all random numbers behind it hang on
};

/// Camera rays of a picture. One sample goes through the pixel's `PixelPoint`, more follow a
/// scrambled Sobol pattern.
class CameraRays {
 public:
  CameraRays(const Camera& camera, const RenderOptions& options);
  /// The rays of pixel (x, y), (0, 0) in the upper left corner; the vector is reused.
  void of_pixel(std::uint32_t x, std::uint32_t y, std::vector<CameraRay>& rays) const;

 private:
  CameraFrame frame_;
  double near_;
  std::uint32_t width_, height_;
  std::uint64_t seed_;
  float offset_;  // of the one sample, in pixels
  SamplePattern pattern_;
};

/// Whose question has this key (`ShadowQuery::key`) at this path about this light; nothing when it
/// is none of the picture's. Cost: a hash for each sample of the picture.
std::optional<PixelSample> find_sample(const RenderOptions& options, std::uint64_t path,
                                       std::uint32_t light, std::uint64_t key);

}  // namespace penumbra
