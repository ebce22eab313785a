// SPDX-License-Identifier: MIT
// How much of a light a point sees, by any method. `stochastic` is the judge: every other but
// `hard` returns the same bits in `cosine_weighted` and `fraction`.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "penumbra/geometry/light_sampling.h"
#include "penumbra/shadow/occluder_cache.h"
#include "penumbra/shadow/proof.h"
#include "penumbra/shadow/shadow_scene.h"
#include "penumbra/shadow/shaft.h"

namespace penumbra {

/// Exact integers. A query is a (point, light) with at least one sample above the point's horizon.
struct ShadowCounters {
  std::uint64_t lit = 0, penumbra = 0, umbra = 0;  ///< queries by class
  std::uint64_t rays = 0;   ///< sample rays traced in the geometry set, after the occluder cache
  std::uint64_t tests = 0;  ///< primitives tested by them
  std::uint64_t cache_decided = 0;  ///< sample rays that the occluder cache decided
  std::uint64_t set_rays = 0;       ///< rays traced in the shadow set
  std::uint64_t set_tests = 0;      ///< grown occluders tested by them
  void add(const ShadowCounters& other);
};

/// p' of a surface point and the geometric normal on the side it was moved to.
struct Receiver {
  Vec3f position;
  Vec3f normal;  ///< unit
};

struct Visibility {
  float cosine_weighted =
      0;  ///< V = sum w v / sum w, w the cosine; where sum w is 0 or not finite, `fraction`
  float fraction = 0;  ///< free samples / d; a sample on or below the horizon is not free
  ShadowClass shadow_class = ShadowClass::umbra;
  std::uint32_t rays = 0;  ///< sample rays traced for it
};

/// One question: a receiver, and the key of its random numbers (`light_key`).
struct ShadowQuery {
  Receiver receiver;
  std::uint64_t key = 0;
};

/// What a thread reuses between queries: the pattern of d samples and memory, so that none is
/// allocated for a ray.
struct VisibilityScratch {
  explicit VisibilityScratch(std::uint32_t shadow_samples) : pattern(shadow_samples), center(1) {}
  SamplePattern pattern;
  SamplePattern center;  // of one sample
  LightSamples samples;
  std::vector<float> weight;
  std::vector<std::uint32_t> active, remaining, blocked, by_one;
  ShaftScratch shaft;
};

/// The visible part of one light (an index into the scene's) from one receiver. Samples are taken
/// in order, and a blocked one is a sample whose open segment from p' meets a shadow-casting
/// primitive. Point lights, whose samples are all equal, cost one ray. p' in the light, and NaN
/// anywhere: the samples decide, and the class is penumbra. `queue` holds what blocked this light
/// last; it changes counters alone. Adds to `counters`.
Visibility visibility(const ShadowScene& scene, std::uint32_t light, const Receiver& receiver,
                      std::uint64_t key, OccluderQueue& queue, VisibilityScratch& scratch,
                      ShadowCounters& counters);

/// The same for many receivers, best near one another: `seen[i]` answers `queries[i]`.
void visibilities(const ShadowScene& scene, std::uint32_t light,
                  std::span<const ShadowQuery> queries, OccluderQueue& queue,
                  VisibilityScratch& scratch, ShadowCounters& counters, std::span<Visibility> seen);

/// Key of a light's random numbers at a point: `point_key` identifies the point (pixel, sample in
/// the pixel and path in the ray tree; a library caller's own, by default the index).
std::uint64_t light_key(std::uint64_t point_key, std::uint32_t light_index);

}  // namespace penumbra
