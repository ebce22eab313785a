// SPDX-License-Identifier: MIT
// The picture's planes: colour, and the layers asked for.
#pragma once

#include <cstdint>
#include <vector>

#include "penumbra/scene/image.h"
#include "penumbra/trace/ray_tree.h"

namespace penumbra {

/// Makes R, G, B and the channels of each layer (one a light for class and visibility), all 0.
Image make_layers(std::uint32_t width, std::uint32_t height, const std::vector<Aov>& aovs,
                  std::size_t lights);

/// What is known of a pixel when its samples are done.
struct PixelResult {
  Color color;
  std::uint64_t shadow_rays = 0;
  std::vector<RayNode>
      primary;  ///< camera-ray node of each sample; may be empty when no layer needs it
};

/// class, depth (distance from the camera along its axis, infinite where nothing is hit), and
/// normal are of the pixel's first sample; visibility is the mean over the samples that hit
/// something. Pixels that hit nothing have class 0 and visibility 1.
void store(const PixelResult& result, const std::vector<Aov>& aovs, const Scene& scene,
           std::size_t pixel, Image& image);

}  // namespace penumbra
