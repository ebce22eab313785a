// SPDX-License-Identifier: MIT
// The samples of one (point, light): taken, weighed, traced, summed. What all methods share.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "penumbra/geometry/light_sampling.h"
#include "penumbra/shadow/occluder_cache.h"
#include "penumbra/shadow/shadow_query.h"
#include "penumbra/shadow/shadow_scene.h"

namespace penumbra {

/// Memory that is reused between queries, so that none is allocated for a ray. One bit a sample in
/// words of 32.
struct SampleScratch {
  explicit SampleScratch(std::uint32_t shadow_samples) : pattern(shadow_samples), center(1) {}
  SamplePattern pattern;
  SamplePattern center;  ///< of one sample
  LightSamples samples;
  std::vector<float> weight;
  std::vector<std::uint32_t> active;   ///< above the horizon
  std::vector<std::uint32_t> blocked;  ///< of the active ones
  std::vector<std::uint32_t> remaining, by_one;
};

/// Directions to the light's samples, their weights, and `active`; returns the number of these.
/// None is blocked yet.
std::uint32_t take_samples(const ShadowScene& scene, std::uint32_t light, const Receiver& receiver,
                           std::uint64_t key, SampleScratch& scratch);

/// Fills `blocked` for the active rays, by the cached occluders, then by the geometry set; returns
/// how many were traced. Adds to `counters`.
std::uint64_t trace_samples(const Kernel& kernel, OccluderQueue& queue, SampleScratch& scratch,
                            ShadowCounters& counters);

/// The same by some of the kernel's records, if no other can block.
std::uint64_t trace_samples(const Kernel& kernel, std::span<const std::uint32_t> records,
                            OccluderQueue& queue, SampleScratch& scratch, ShadowCounters& counters);

/// The same for one word of 32 samples.
std::uint64_t trace_word(const Kernel& kernel, std::span<const std::uint32_t> records,
                         std::uint32_t word, OccluderQueue& queue, SampleScratch& scratch,
                         ShadowCounters& counters);

/// By the geometry set, one ray after the other: the queue is asked for each, and learns from each.
std::uint64_t trace_singly(const Kernel& kernel, OccluderQueue& queue, SampleScratch& scratch,
                           ShadowCounters& counters);

/// The visible part, given `blocked`; sums run in sample order. Without class.
Visibility sum_up(const SampleScratch& scratch);

/// The class that the samples tell: nothing is proven.
ShadowClass class_by_samples(const SampleScratch& scratch, const Visibility& seen);

}  // namespace penumbra
