// SPDX-License-Identifier: MIT
// Surface points that stand for texels, and footprints of a block of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "penumbra/geometry/sample_pattern.h"
#include "penumbra/scene/scene.h"
#include "penumbra/shadow/shadow_query.h"
#include "penumbra/trace/footprint.h"
#include "penumbra/trace/uv_atlas.h"
#include "penumbra/trace/z_order.h"

namespace penumbra {

/// A triangle as texels see it.
struct BakedTriangle {
  TexelTriangle place;
  Vec3d normal;       ///< unit, on the side that is baked
  double offset = 0;  ///< of p' from the surface: more than the error of float there, of any point
  double slack = 0;   ///< how far rounding may move p' along any axis, at most
  std::size_t pieces_begin = 0, pieces_end = 0;
};

/// A triangle's share of one texel.
struct TexelPiece {
  std::uint32_t triangle = 0;  ///< of the block's
  std::uint32_t texel = 0;     ///< of the block's, in Z-order
  float area = 0;              ///< in texels, above 0
  std::uint32_t samples = 0;   ///< that lie on it
};

/// A point of a texel.
struct TexelSample {
  std::uint32_t piece = 0;
  ShadowQuery query;  ///< its key is that of the point; a light's is made of it
};

/// All that a block is asked about.
struct TexelPoints {
  std::vector<Pixel> texels;  ///< of the block, in Z-order
  std::vector<BakedTriangle> triangles;
  std::vector<TexelPiece> pieces;  ///< triangle by triangle
  /// As many of each texel that has pieces, texel by texel.
  std::vector<TexelSample> samples;
  std::vector<std::uint32_t> covered;  ///< texels that have samples, in order
  std::uint64_t overlapping = 0;       ///< texels whose middle lies in several triangles
};

/// Each texel gets as many points as the pattern has, spread evenly over what is covered of it.
/// Keys hang on seed, texel and sample.
TexelPoints place_points(const Scene& scene, const UvAtlas& atlas, std::size_t block,
                         const SamplePattern& pattern, std::uint64_t seed);

/// Where shadow rays of a point of the triangle begin.
Receiver receiver_at(const BakedTriangle& triangle, Vec3d position);

}  // namespace penumbra
