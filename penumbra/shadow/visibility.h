// SPDX-License-Identifier: MIT
// How much of a light a point sees, by any method. `stochastic` is the judge: every other but
// `hard` returns the same bits in `cosine_weighted` and `fraction`.
#pragma once

#include <cstdint>
#include <span>

#include "penumbra/shadow/answer_rows.h"
#include "penumbra/shadow/occluder_cache.h"
#include "penumbra/shadow/samples.h"
#include "penumbra/shadow/shadow_query.h"
#include "penumbra/shadow/shadow_scene.h"
#include "penumbra/shadow/tile.h"

namespace penumbra {

/// What a thread reuses between queries: the pattern of d samples, and memory.
struct VisibilityScratch {
  explicit VisibilityScratch(std::uint32_t shadow_samples) : samples(shadow_samples) {}
  SampleScratch samples;
  TileScratch tile;
};

/// The visible part of one light (an index into the scene's) from one receiver. Samples are taken
/// in order, and a blocked one is a sample whose open segment from p' meets a shadow-casting
/// primitive. Point lights, whose samples are all equal, cost one ray. p' in the light, and NaN
/// anywhere: the samples decide, and the class is penumbra. `queue` holds what blocked this light
/// last; it changes counters alone. Adds to `counters`.
Visibility visibility(const ShadowScene& scene, std::uint32_t light, const Receiver& receiver,
                      std::uint64_t key, OccluderQueue& queue, VisibilityScratch& scratch,
                      ShadowCounters& counters);

/// The same for many receivers, best near one another: row i answers `queries[i]`.
void visibilities(const ShadowScene& scene, std::uint32_t light,
                  std::span<const ShadowQuery> queries, OccluderQueue& queue,
                  VisibilityScratch& scratch, ShadowCounters& counters, const AnswerRows& answers);
inline void visibilities(const ShadowScene& scene, std::uint32_t light,
                         std::span<const ShadowQuery> queries, OccluderQueue& queue,
                         VisibilityScratch& scratch, ShadowCounters& counters,
                         std::span<Visibility> seen) {
  visibilities(scene, light, queries, queue, scratch, counters, AnswerRows{seen});
}

}  // namespace penumbra
