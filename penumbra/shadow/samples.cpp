// SPDX-License-Identifier: MIT
#include "penumbra/shadow/samples.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "penumbra/geometry/sample_loops.h"
#include "penumbra/kernel/kernel.h"

namespace penumbra {

namespace {

/// The one ray of `hard`: to the centre.
void aim_at_center(const LightShape& light, Vec3f p, LightSamples& out) {
  const Vec3f to = towards_center(light, p);
  out.resize(1);
  out.origin = p;
  out.t_max = center(light) ? 1.0f : std::numeric_limits<float>::infinity();
  std::fill(out.x.begin(), out.x.end(), to.x);
  std::fill(out.y.begin(), out.y.end(), to.y);
  std::fill(out.z.begin(), out.z.end(), to.z);
}

/// Cosine of each sample, and a bit for each that lies above the horizon; -1 says that it doesn't.
std::uint32_t weigh(const Receiver& receiver, SampleScratch& scratch) {
  const LightSamples& s = scratch.samples;
  scratch.weight.resize(s.x.size());
  scratch.active.assign((s.count + 31) / 32, 0);
  scratch.blocked.assign(scratch.active.size(), 0);
  if (receiver.has_horizon())
    weigh_directions(receiver.normal, s.x.data(), s.y.data(), s.z.data(), s.x.size(),
                     scratch.weight.data());
  else
    std::fill(scratch.weight.begin(), scratch.weight.end(), 1.0f);
  std::uint32_t above = 0;
  for (std::uint32_t i = 0; i < s.count; ++i) {
    const std::uint32_t is_above = !(scratch.weight[i] < 0);
    scratch.active[i / 32] |= is_above << i % 32;
    above += is_above;
  }
  return above;
}

std::uint64_t count_bits(std::span<const std::uint32_t> words) {
  std::uint64_t bits = 0;
  for (const std::uint32_t word : words) bits += static_cast<std::uint64_t>(std::popcount(word));
  return bits;
}

/// Tries the cached occluders on all active rays: moves those that one blocks from `remaining` to
/// `blocked`.
void ask_cache(const Kernel& kernel, OccluderQueue& queue, SampleScratch& scratch,
               ShadowCounters& counters) {
  for (const std::uint32_t record : std::array(queue.record)) {
    if (record == no_record) continue;
    const OccludedReport report = occluded_among(kernel.records(), {&record, 1}, scratch.samples,
                                                 scratch.remaining, scratch.by_one);
    counters.tests += report.tests;
    if (report.blocker == no_record) continue;
    queue.move_to_front(record);
    counters.cache_decided += count_bits(scratch.by_one);
    for (std::size_t i = 0; i < scratch.remaining.size(); ++i) {
      scratch.remaining[i] &= ~scratch.by_one[i];
      scratch.blocked[i] |= scratch.by_one[i];
    }
  }
}

bool is_any_blocked(const SampleScratch& scratch) {
  return std::any_of(scratch.blocked.begin(), scratch.blocked.end(),
                     [](std::uint32_t word) { return word != 0; });
}

/// Adds what a query of the remaining rays found.
void note(const OccludedReport& report, std::uint64_t rays, OccluderQueue& queue,
          SampleScratch& scratch, ShadowCounters& counters) {
  counters.rays += rays;
  counters.tests += report.tests;
  for (std::size_t i = 0; i < scratch.blocked.size(); ++i) scratch.blocked[i] |= scratch.by_one[i];
  if (report.blocker != no_record)
    queue.move_to_front(report.blocker);
  else if (!is_any_blocked(scratch))
    queue.drop_last();
}

}  // namespace

std::uint64_t trace_samples(const Kernel& kernel, OccluderQueue& queue, SampleScratch& scratch,
                            ShadowCounters& counters) {
  scratch.remaining = scratch.active;
  scratch.by_one.resize(scratch.active.size());
  ask_cache(kernel, queue, scratch, counters);
  const std::uint64_t rays = count_bits(scratch.remaining);
  if (rays == 0) return 0;
  note(kernel.occluded(scratch.samples, scratch.remaining, scratch.by_one), rays, queue, scratch,
       counters);
  return rays;
}

std::uint64_t trace_samples(const Kernel& kernel, std::span<const std::uint32_t> records,
                            OccluderQueue& queue, SampleScratch& scratch,
                            ShadowCounters& counters) {
  scratch.by_one.resize(scratch.active.size());
  const std::uint64_t rays = count_bits(scratch.active);
  note(occluded_among(kernel.records(), records, scratch.samples, scratch.active, scratch.by_one),
       rays, queue, scratch, counters);
  return rays;
}

std::uint64_t trace_word(const Kernel& kernel, std::span<const std::uint32_t> records,
                         std::uint32_t word, OccluderQueue& queue, SampleScratch& scratch,
                         ShadowCounters& counters) {
  scratch.by_one.resize(scratch.active.size());
  scratch.remaining.assign(scratch.active.size(), 0);
  scratch.remaining[word] = scratch.active[word];
  const auto rays = static_cast<std::uint64_t>(std::popcount(scratch.active[word]));
  note(
      occluded_among(kernel.records(), records, scratch.samples, scratch.remaining, scratch.by_one),
      rays, queue, scratch, counters);
  return rays;
}

std::uint64_t trace_singly(const Kernel& kernel, OccluderQueue& queue, SampleScratch& scratch,
                           ShadowCounters& counters) {
  const SingleReport report =
      kernel.occluded_singly(scratch.samples, scratch.active, queue, scratch.blocked);
  counters.rays += report.traced;
  counters.tests += report.tests;
  counters.cache_decided += report.decided;
  return report.traced;
}

Visibility sum_up(const SampleScratch& scratch) {
  double all = 0, free = 0;
  std::uint32_t free_count = 0;
  for (std::uint32_t i = 0; i < scratch.samples.count; ++i) {
    const std::uint32_t is_active = scratch.active[i / 32] >> i % 32 & 1;
    const std::uint32_t is_free = is_active & ~(scratch.blocked[i / 32] >> i % 32);
    all += is_active ? scratch.weight[i] : 0;
    free += is_free ? scratch.weight[i] : 0;
    free_count += is_free;
  }
  Visibility result;
  result.fraction = static_cast<float>(free_count) / static_cast<float>(scratch.samples.count);
  const double ratio = free / all;
  result.cosine_weighted =
      all > 0 && std::isfinite(ratio) ? static_cast<float>(ratio) : result.fraction;
  return result;
}

ShadowClass class_by_samples(const SampleScratch& scratch, const Visibility& seen) {
  if (seen.fraction == 0) return ShadowClass::umbra;
  return is_any_blocked(scratch) ? ShadowClass::penumbra : ShadowClass::lit;
}

std::uint32_t take_samples(const ShadowScene& scene, std::uint32_t light, const Receiver& receiver,
                           std::uint64_t key, SampleScratch& scratch) {
  const LightShape& shape = scene.lights[light];
  const SamplePattern& pattern = is_point(shape) ? scratch.center : scratch.pattern;
  if (scene.method == Method::hard)
    aim_at_center(shape, receiver.position, scratch.samples);
  else
    sample_light(shape, receiver.position, pattern, key, scratch.samples);
  return weigh(receiver, scratch);
}

}  // namespace penumbra
