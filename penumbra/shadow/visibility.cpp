// SPDX-License-Identifier: MIT
#include "penumbra/shadow/visibility.h"

#include <cmath>

#include "penumbra/geometry/sample_pattern.h"
#include "penumbra/shadow/classify.h"

namespace penumbra {

std::uint64_t light_key(std::uint64_t point_key, std::uint32_t light_index) {
  return hash(point_key, light_index);
}

namespace {

/// All samples are sure to be above the horizon, in float too, however they will be rounded.
bool is_surely_above(const LightHull& light, const Receiver& receiver) {
  if (!receiver.has_horizon()) return true;
  const double distance = length(light.center(receiver.position) - Vec3d(receiver.position));
  const bool is_safe = distance > 1e-15 && distance < 1e15;  // squares stay in float's range
  return is_safe && light.least_height(receiver.position, Vec3d(receiver.normal)) > 0;
}

/// All but `shaft`.
Visibility answer(const ShadowScene& scene, std::uint32_t light, const ShadowQuery& query,
                  const ProofBudget& budget, OccluderQueue& queue, SampleScratch& scratch,
                  ShadowCounters& counters) {
  const Receiver& receiver = query.receiver;
  const bool is_doubtful = !is_finite(receiver.position) || !is_finite(receiver.normal) ||
                           contains(scene.lights[light], receiver.position);
  const bool may_prove =
      has_shadow_set(scene.method) && !is_doubtful && !is_point(scene.lights[light]);
  // Where nothing needs the samples they are not taken.
  const bool is_above = may_prove && is_surely_above(scene.hulls[light], receiver);
  if (!is_above && take_samples(scene, light, receiver, query.key, scratch) == 0)
    return {0, 0, is_doubtful ? ShadowClass::penumbra : ShadowClass::umbra};

  const ShadowClass proven =
      may_prove ? classify(scene, light, receiver.position, budget, queue, counters)
                : ShadowClass::penumbra;
  Visibility result;
  std::uint64_t rays = 0;
  if (proven == ShadowClass::umbra) {
    result = {0, 0, proven};
  } else if (proven == ShadowClass::lit && is_above) {
    result = {1, 1, proven};
  } else {
    if (is_above) take_samples(scene, light, receiver, query.key, scratch);
    if (proven != ShadowClass::lit)
      rays = scene.rays == RayGrouping::single
                 ? trace_singly(*scene.kernel, queue, scratch, counters)
                 : trace_samples(*scene.kernel, queue, scratch, counters);
    result = sum_up(scratch);
    result.shadow_class = may_prove || is_doubtful ? proven : class_by_samples(scratch, result);
  }
  result.rays = static_cast<std::uint32_t>(rays);
  counters.count(result.shadow_class);
  return result;
}

}  // namespace

Visibility visibility(const ShadowScene& scene, std::uint32_t light, const Receiver& receiver,
                      std::uint64_t key, OccluderQueue& queue, VisibilityScratch& scratch,
                      ShadowCounters& counters) {
  Visibility seen;
  const ShadowQuery query{receiver, key};
  visibilities(scene, light, {&query, 1}, queue, scratch, counters, {&seen, 1});
  return seen;
}

void visibilities(const ShadowScene& scene, std::uint32_t light,
                  std::span<const ShadowQuery> queries, OccluderQueue& queue,
                  VisibilityScratch& scratch, ShadowCounters& counters, const AnswerRows& answers) {
  if (scene.method == Method::shaft && !is_point(scene.lights[light]))
    return answer_by_tiles(scene, light, queries, queue, scratch.samples, scratch.tile, counters,
                           answers);
  const ProofBudget budget = proof_budget(scratch.samples.pattern.size());
  for (std::size_t i = 0; i < queries.size(); ++i)
    answers.put(i, answer(scene, light, queries[i], budget, queue, scratch.samples, counters),
                scratch.samples);
}

}  // namespace penumbra
