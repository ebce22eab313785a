// SPDX-License-Identifier: MIT
// A square of texels: what one thread bakes at a time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "penumbra/geometry/sample_pattern.h"
#include "penumbra/trace/bake.h"

namespace penumbra {

/// What all blocks of a texture share.
struct BakeContext {
  const Scene& scene;
  const ShadowScene& shadows;
  const UvAtlas& atlas;
  const BakeOptions& options;
  SamplePattern pattern;  ///< of the points of a texel
};

/// Where results go: a value a texel and light.
struct BakePlanes {
  std::vector<Channel*> visibility;   ///< of each light
  std::vector<Channel*> light_class;  ///< the same, or none at all
  std::vector<std::uint8_t> covered;  ///< not 0: has values
};

/// Bakes the texels of a block of the atlas. The occluder cache starts empty; `visibility` is the
/// thread's memory.
BakeCounters bake_block(const BakeContext& context, std::size_t block,
                        VisibilityScratch& visibility, BakePlanes& planes);

}  // namespace penumbra
