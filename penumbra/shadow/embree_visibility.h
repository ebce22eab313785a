// SPDX-License-Identifier: MIT
// The questions of `visibility`, answered as a skilled user of Embree would: the competitor that
// `penumbra bench` measures against. Samples, weights and sums are those of `stochastic`.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "penumbra/kernel/embree_baseline.h"
#include "penumbra/shadow/visibility.h"

namespace penumbra {

/// What a thread reuses between queries.
struct EmbreeScratch {
  explicit EmbreeScratch(std::uint32_t shadow_samples);
  std::vector<SampleScratch> points;  ///< that share packets
  MixedRays rays;
  std::vector<std::uint32_t> active, blocked;
};

/// `seen[i]` answers `queries[i]`, about one of the scene's lights: d rays a point, those of a
/// point in packets of its own where they fill them, else with those of its neighbours in the span.
/// If the scene's method is `hard`, one ray to the light's centre, without sampling. Classes are by
/// the samples. Adds queries and rays to `counters`.
void embree_visibilities(const EmbreeBaseline& embree, EmbreeVariant variant,
                         const ShadowScene& scene, std::uint32_t light,
                         std::span<const ShadowQuery> queries, EmbreeScratch& scratch,
                         ShadowCounters& counters, std::span<Visibility> seen);

}  // namespace penumbra
