// SPDX-License-Identifier: MIT
// Scene + shadows -> textures: how much of each light the surface under a texel sees. A texel's
// footprint is a polygon; one query may prove all of it lit, or in umbra (shadow/hull_proof.h).
// What is left is sampled.
#pragma once

#include <cstdint>
#include <functional>

#include "penumbra/scene/image.h"
#include "penumbra/scene/scene.h"
#include "penumbra/shadow/visibility.h"
#include "penumbra/trace/uv_atlas.h"

namespace penumbra {

/// What a light's visible part is measured by.
/// fraction: samples that reach the surface, of all; those below the face's horizon do not.
/// cosine_weighted: of the samples above the horizon, by the cosine of each: what an unshadowed
/// light has to be multiplied by, without the facets of coarse meshes where the light sets.
enum class BakeValue { fraction, cosine_weighted };

struct BakeOptions {
  std::uint32_t width = 1024, height = 1024;  ///< product below 2^32
  std::uint32_t shadow_samples = 32;          ///< d, >= 1, of each point and light
  std::uint32_t texel_samples = 4;            ///< points of a texel, >= 1
  std::uint32_t padding = 8;                  ///< texels around charts that get their values
  float background = 0;                       ///< value of all others
  BakeValue value = BakeValue::fraction;
  bool has_classes = false;  ///< makes their channels
  std::uint64_t seed = 0;
  std::uint32_t threads = 0;  ///< 0: all
  /// Called with the finished share in [0, 1], from any thread, one call at a time.
  std::function<void(double)> progress{};
};

/// Exact integers, equal for any number of threads.
struct BakeCounters {
  std::uint64_t covered = 0;      ///< texels with a surface under them
  std::uint64_t padded = 0;       ///< texels that got the value of one of these
  std::uint64_t overlapping = 0;  ///< texels whose middle lies inside of two or more triangles
  /// Covered texels times lights by class.
  std::uint64_t lit = 0, penumbra = 0, umbra = 0;
  /// Samples that one query for a whole footprint answered.
  std::uint64_t proven_samples = 0;
  std::uint64_t asked_samples = 0;  ///< and the others
  ShadowCounters shadow;            ///< of the others

  void add(const BakeCounters& other);
};

struct Bake {
  /// For each light N `visibility.lightN`, the visible fraction in [0, 1]; for each, where asked
  /// for, `class.lightN`: 0 lit, 1 penumbra, 2 umbra, of all of the texel; then `coverage`: 1
  /// covered, 0.5 padding, 0 neither.
  Image image;
  BakeCounters counters;
  double seconds = 0;
  std::uint32_t threads = 1;
};

/// A texture of what the atlas holds (`make_atlas`, of the same size). The scene must be complete,
/// and `shadows` prepared for it.
/// (1) A texel's value is the mean over points spread evenly over the part of its square that
/// triangles cover, of what `BakeValue` says: nothing of what is not covered, and of several
/// triangles each by its share of the area. (2) Points lie on the side that the triangle's turn
/// says is outside, or its vertex normals, where there are. (3) Random numbers hang on seed, texel,
/// sample and light alone: the same bits for any number of threads, and for every method but
/// `hard`. (4) Texels up to `padding` away from a covered one repeat the nearest; others are
/// `background`, class 0.
/// Throws nothing but what `progress` throws. Memory: 4 bytes a texel and channel, and, while
/// charts are padded, 9 more a texel.
Bake bake(const Scene& scene, const ShadowScene& shadows, const UvAtlas& atlas,
          const BakeOptions& options);

}  // namespace penumbra
