// SPDX-License-Identifier: MIT
// A question of visibility, its answer, and what answers cost.
#pragma once

#include <cstdint>

#include "penumbra/geometry/vec.h"

namespace penumbra {

/// p' of a surface point and the geometric normal on the side it was moved to.
struct Receiver {
  Vec3f position;
  Vec3f normal;  ///< unit; (0, 0, 0): no surface, all samples are above the horizon and weigh 1

  bool has_horizon() const { return normal != Vec3f{}; }
};

/// One question: a receiver, and the key of its random numbers (`light_key`).
struct ShadowQuery {
  Receiver receiver;
  std::uint64_t key = 0;
};

/// Key of a light's random numbers at a point: `point_key` identifies the point (pixel, sample in
/// the pixel and path in the ray tree; a library caller's own, by default the index).
std::uint64_t light_key(std::uint64_t point_key, std::uint32_t light_index);

/// Class of (point, light). lit and umbra are proofs, except that `stochastic` and `hard` class by
/// their samples: umbra when no sample is free, lit when no ray is blocked.
enum class ShadowClass : std::uint8_t { lit = 0, penumbra = 1, umbra = 2 };

/// What a point sees of a light.
struct Visibility {
  float cosine_weighted =
      0;  ///< V = sum w v / sum w, w the cosine; where sum w is 0 or not finite, `fraction`
  float fraction = 0;  ///< free samples / d; a sample on or below the horizon is not free
  ShadowClass shadow_class = ShadowClass::umbra;
  std::uint32_t rays = 0;  ///< sample rays traced for it
};

/// Exact integers. A query is a (point, light) with at least one sample above the point's horizon.
struct ShadowCounters {
  std::uint64_t lit = 0, penumbra = 0, umbra = 0;  ///< queries by class
  std::uint64_t rays = 0;   ///< sample rays traced in the geometry set, after the occluder cache
  std::uint64_t tests = 0;  ///< primitives tested by them
  std::uint64_t cache_decided = 0;  ///< sample rays that the occluder cache decided
  std::uint64_t set_rays = 0;       ///< rays traced in the shadow set; shafts of `shaft`
  std::uint64_t set_tests = 0;      ///< grown occluders tested by them; records gathered by shafts

  void add(const ShadowCounters& other) {
    lit += other.lit, penumbra += other.penumbra, umbra += other.umbra;
    rays += other.rays, tests += other.tests, cache_decided += other.cache_decided;
    set_rays += other.set_rays, set_tests += other.set_tests;
  }
  void count(ShadowClass shadow_class) {
    switch (shadow_class) {
      case ShadowClass::lit: ++lit; break;
      case ShadowClass::penumbra: ++penumbra; break;
      case ShadowClass::umbra: ++umbra; break;
    }
  }
};

}  // namespace penumbra
