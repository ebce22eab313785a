// SPDX-License-Identifier: MIT
#include "penumbra/shadow/visibility.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "penumbra/shadow/classify.h"

namespace penumbra {

void ShadowCounters::add(const ShadowCounters& other) {
  lit += other.lit, penumbra += other.penumbra, umbra += other.umbra;
  rays += other.rays, tests += other.tests, cache_decided += other.cache_decided;
  set_rays += other.set_rays, set_tests += other.set_tests;
}

std::uint64_t light_key(std::uint64_t point_key, std::uint32_t light_index) {
  return hash(point_key, light_index);
}

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

/// Cosine of each sample, and a bit for each that lies above the horizon. NaN lies below it.
std::uint32_t weigh(const Vec3f normal, VisibilityScratch& scratch) {
  const LightSamples& s = scratch.samples;
  scratch.weight.resize(s.count);
  scratch.active.assign((s.count + 31) / 32, 0);
  scratch.blocked.resize(scratch.active.size());
  std::uint32_t above = 0;
  for (std::uint32_t i = 0; i < s.count; ++i) {
    const float along = normal.x * s.x[i] + normal.y * s.y[i] + normal.z * s.z[i];
    const float square = s.x[i] * s.x[i] + s.y[i] * s.y[i] + s.z[i] * s.z[i];
    scratch.weight[i] = along / std::sqrt(square);
    if (!(along > 0)) continue;
    scratch.active[i / 32] |= 1u << i % 32;
    ++above;
  }
  return above;
}

/// Sums in sample order.
Visibility sum_up(const VisibilityScratch& scratch) {
  double all = 0, free = 0;
  std::uint32_t free_count = 0;
  for (std::uint32_t i = 0; i < scratch.samples.count; ++i) {
    const std::uint32_t bit = 1u << i % 32;
    if (!(scratch.active[i / 32] & bit)) continue;
    all += scratch.weight[i];
    if (scratch.blocked[i / 32] & bit) continue;
    free += scratch.weight[i];
    ++free_count;
  }
  Visibility result;
  result.fraction = static_cast<float>(free_count) / static_cast<float>(scratch.samples.count);
  const double ratio = free / all;
  result.cosine_weighted =
      all > 0 && std::isfinite(ratio) ? static_cast<float>(ratio) : result.fraction;
  return result;
}

std::uint64_t count_bits(const std::vector<std::uint32_t>& words) {
  std::uint64_t bits = 0;
  for (const std::uint32_t word : words) bits += static_cast<std::uint64_t>(std::popcount(word));
  return bits;
}

/// Moves the rays that one record blocks from `remaining` to `blocked`; returns their number.
std::uint64_t take_blocked(const Record& record, VisibilityScratch& scratch) {
  occluded_by(record, scratch.samples, scratch.remaining, scratch.by_one);
  for (std::size_t i = 0; i < scratch.remaining.size(); ++i) {
    scratch.remaining[i] &= ~scratch.by_one[i];
    scratch.blocked[i] |= scratch.by_one[i];
  }
  return count_bits(scratch.by_one);
}

/// Tries the cached occluders on all active rays.
void ask_cache(const Kernel& kernel, OccluderQueue& queue, VisibilityScratch& scratch,
               ShadowCounters& counters) {
  for (const std::uint32_t record : std::array(queue.record)) {
    if (record == no_record) continue;
    const std::uint64_t rays = count_bits(scratch.remaining);
    if (rays == 0) return;
    counters.tests += rays;
    const std::uint64_t decided = take_blocked(kernel.records()[record], scratch);
    counters.cache_decided += decided;
    if (decided > 0) queue.move_to_front(record);
  }
}

/// Fills `blocked` for the active rays; returns how many were traced.
std::uint64_t trace(const Kernel& kernel, OccluderQueue& queue, VisibilityScratch& scratch,
                    ShadowCounters& counters) {
  scratch.remaining = scratch.active;
  scratch.by_one.resize(scratch.active.size());
  std::fill(scratch.blocked.begin(), scratch.blocked.end(), 0u);
  ask_cache(kernel, queue, scratch, counters);
  const std::uint64_t rays = count_bits(scratch.remaining);
  if (rays == 0) return 0;
  const OccludedReport report = kernel.occluded(scratch.samples, scratch.remaining, scratch.by_one);
  counters.rays += rays;
  counters.tests += report.tests;
  for (std::size_t i = 0; i < scratch.blocked.size(); ++i) scratch.blocked[i] |= scratch.by_one[i];
  if (report.blocker != no_record)
    queue.move_to_front(report.blocker);
  else if (count_bits(scratch.blocked) == 0)
    queue.drop_last();
  return rays;
}

void count(ShadowClass shadow_class, ShadowCounters& counters) {
  switch (shadow_class) {
    case ShadowClass::lit: ++counters.lit; break;
    case ShadowClass::penumbra: ++counters.penumbra; break;
    case ShadowClass::umbra: ++counters.umbra; break;
  }
}

/// Directions to the light's samples, and which lie above the horizon; returns their number.
std::uint32_t take_samples(const ShadowScene& scene, std::uint32_t light, const Receiver& receiver,
                           std::uint64_t key, VisibilityScratch& scratch) {
  const LightShape& shape = scene.lights[light];
  const SamplePattern& pattern =
      std::holds_alternative<PointLight>(shape) ? scratch.center : scratch.pattern;
  if (scene.method == Method::hard)
    aim_at_center(shape, receiver.position, scratch.samples);
  else
    sample_light(shape, receiver.position, pattern, key, scratch.samples);
  return weigh(receiver.normal, scratch);
}

/// All samples are sure to be above the horizon, in float too, however they will be rounded.
bool is_surely_above(const LightHull& light, const Receiver& receiver) {
  const double distance = length(light.center(receiver.position) - Vec3d(receiver.position));
  const bool is_safe = distance > 1e-15 && distance < 1e15;  // squares stay in float's range
  return is_safe && light.least_height(receiver.position, Vec3d(receiver.normal)) > 0;
}

ShadowClass class_by_samples(const VisibilityScratch& scratch, const Visibility& seen) {
  if (seen.fraction == 0) return ShadowClass::umbra;
  return count_bits(scratch.blocked) > 0 ? ShadowClass::penumbra : ShadowClass::lit;
}

}  // namespace

Visibility visibility(const ShadowScene& scene, std::uint32_t light, const Receiver& receiver,
                      std::uint64_t key, OccluderQueue& queue, VisibilityScratch& scratch,
                      ShadowCounters& counters) {
  const bool is_doubtful = !is_finite(receiver.position) || !is_finite(receiver.normal) ||
                           contains(scene.lights[light], receiver.position);
  const bool may_prove = has_shadow_set(scene.method) && !is_doubtful &&
                         !std::holds_alternative<PointLight>(scene.lights[light]);
  // Where nothing needs the samples they are not taken.
  const bool is_above = may_prove && is_surely_above(scene.hulls[light], receiver);
  if (!is_above && take_samples(scene, light, receiver, key, scratch) == 0)
    return {0, 0, is_doubtful ? ShadowClass::penumbra : ShadowClass::umbra};

  const ShadowClass proven = may_prove
                                 ? classify(scene, light, receiver.position,
                                            proof_budget(scratch.pattern.size()), queue, counters)
                                 : ShadowClass::penumbra;
  Visibility result;
  std::uint64_t rays = 0;
  if (proven == ShadowClass::umbra) {
    result = {0, 0, proven};
  } else if (proven == ShadowClass::lit && is_above) {
    result = {1, 1, proven};
  } else {
    if (is_above) take_samples(scene, light, receiver, key, scratch);
    if (proven == ShadowClass::lit)
      std::fill(scratch.blocked.begin(), scratch.blocked.end(), 0u);
    else
      rays = trace(*scene.kernel, queue, scratch, counters);
    result = sum_up(scratch);
    result.shadow_class = may_prove || is_doubtful ? proven : class_by_samples(scratch, result);
  }
  result.rays = static_cast<std::uint32_t>(rays);
  count(result.shadow_class, counters);
  return result;
}

void visibilities(const ShadowScene& scene, std::uint32_t light,
                  std::span<const ShadowQuery> queries, OccluderQueue& queue,
                  VisibilityScratch& scratch, ShadowCounters& counters,
                  std::span<Visibility> seen) {
  for (std::size_t i = 0; i < queries.size(); ++i)
    seen[i] =
        visibility(scene, light, queries[i].receiver, queries[i].key, queue, scratch, counters);
}

}  // namespace penumbra
