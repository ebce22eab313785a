// SPDX-License-Identifier: MIT
#include "penumbra/shadow/visibility.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "penumbra/shadow/classify.h"
#include "penumbra/shadow/samples.h"
#include "penumbra/shadow/shaft.h"

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

/// Fills `blocked` for the active rays, by the cache, then by the candidates or the whole geometry
/// set; returns how many were traced.
std::uint64_t trace(const Kernel& kernel, const Proof& proof, OccluderQueue& queue,
                    VisibilityScratch& scratch, ShadowCounters& counters) {
  scratch.remaining = scratch.active;
  scratch.by_one.resize(scratch.active.size());
  std::fill(scratch.blocked.begin(), scratch.blocked.end(), 0u);
  if (!proof.has_candidates) ask_cache(kernel, queue, scratch, counters);
  const std::uint64_t rays = count_bits(scratch.remaining);
  if (rays == 0) return 0;
  const OccludedReport report =
      proof.has_candidates ? occluded_among(kernel.records(), proof.candidates, scratch.samples,
                                            scratch.remaining, scratch.by_one)
                           : kernel.occluded(scratch.samples, scratch.remaining, scratch.by_one);
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

ShadowClass class_by_samples(const VisibilityScratch& scratch, const Visibility& seen) {
  if (seen.fraction == 0) return ShadowClass::umbra;
  return count_bits(scratch.blocked) > 0 ? ShadowClass::penumbra : ShadowClass::lit;
}

/// `prove` is asked where there may be a proof.
template <class Prove>
Visibility answer(const ShadowScene& scene, std::uint32_t light, const ShadowQuery& query,
                  Prove&& prove, OccluderQueue& queue, VisibilityScratch& scratch,
                  ShadowCounters& counters) {
  const Receiver& receiver = query.receiver;
  const bool is_doubtful = !is_finite(receiver.position) || !is_finite(receiver.normal) ||
                           contains(scene.lights[light], receiver.position);
  const bool may_prove = proves(scene.method) && !is_doubtful &&
                         !std::holds_alternative<PointLight>(scene.lights[light]);
  // Where nothing needs the samples they are not taken.
  const bool is_above = may_prove && is_surely_above(scene.hulls[light], receiver);
  if (!is_above && take_samples(scene, light, receiver, query.key, scratch) == 0)
    return {0, 0, is_doubtful ? ShadowClass::penumbra : ShadowClass::umbra};

  const Proof proof = may_prove ? prove() : Proof{};
  Visibility result;
  std::uint64_t rays = 0;
  if (proof.shadow_class == ShadowClass::umbra) {
    result = {0, 0, ShadowClass::umbra};
  } else if (proof.shadow_class == ShadowClass::lit && is_above) {
    result = {1, 1, ShadowClass::lit};
  } else {
    if (is_above) take_samples(scene, light, receiver, query.key, scratch);
    if (proof.shadow_class == ShadowClass::lit)
      std::fill(scratch.blocked.begin(), scratch.blocked.end(), 0u);
    else
      rays = trace(*scene.kernel, proof, queue, scratch, counters);
    result = sum_up(scratch);
    result.shadow_class =
        may_prove || is_doubtful ? proof.shadow_class : class_by_samples(scratch, result);
  }
  result.rays = static_cast<std::uint32_t>(rays);
  count(result.shadow_class, counters);
  return result;
}

/// A tile of neighbours shares one query; where that finds too much to list, quarters of it ask
/// again.
class TileByShaft {
 public:
  TileByShaft(const ShadowScene& scene, std::uint32_t light, OccluderQueue& queue,
              VisibilityScratch& scratch, ShadowCounters& counters)
      : scene_(scene), light_(light), queue_(queue), scratch_(scratch), counters_(counters) {}

  void answer_all(std::span<const ShadowQuery> tile, std::span<Visibility> seen) {
    Box receivers;
    for (const ShadowQuery& query : tile) receivers.add(query.receiver.position);
    ++counters_.set_rays;
    const bool has_list = gather_candidates(scene_, light_, receivers, most_candidates,
                                            scratch_.shaft.tile, counters_.set_tests);
    if (!has_list && tile.size() > 1) {
      const std::size_t part = (tile.size() + 3) / 4;
      for (std::size_t first = 0; first < tile.size(); first += part) {
        const std::size_t count = std::min(part, tile.size() - first);
        answer_all(tile.subspan(first, count), seen.subspan(first, count));
      }
      return;
    }
    for (std::size_t i = 0; i < tile.size(); ++i) {
      const Vec3f p = tile[i].receiver.position;
      const auto prove = [&] {
        return has_list ? prove_by_candidates(scene_, light_, p, queue_, scratch_.shaft) : Proof{};
      };
      seen[i] = answer(scene_, light_, tile[i], prove, queue_, scratch_, counters_);
    }
  }

 private:
  static constexpr std::size_t most_candidates = 256;
  const ShadowScene& scene_;
  std::uint32_t light_;
  OccluderQueue& queue_;
  VisibilityScratch& scratch_;
  ShadowCounters& counters_;
};

void by_shaft(const ShadowScene& scene, std::uint32_t light, std::span<const ShadowQuery> queries,
              OccluderQueue& queue, VisibilityScratch& scratch, ShadowCounters& counters,
              std::span<Visibility> seen) {
  constexpr std::size_t tile_size = 16;
  TileByShaft tiles(scene, light, queue, scratch, counters);
  for (std::size_t first = 0; first < queries.size(); first += tile_size) {
    const std::size_t count = std::min(tile_size, queries.size() - first);
    tiles.answer_all(queries.subspan(first, count), seen.subspan(first, count));
  }
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
                  VisibilityScratch& scratch, ShadowCounters& counters,
                  std::span<Visibility> seen) {
  if (scene.method == Method::shaft)
    return by_shaft(scene, light, queries, queue, scratch, counters, seen);
  const ProofBudget budget = proof_budget(scratch.pattern.size());
  for (std::size_t i = 0; i < queries.size(); ++i)
    seen[i] = answer(
        scene, light, queries[i],
        [&] {
          return Proof{
              classify(scene, light, queries[i].receiver.position, budget, queue, counters), false, {}};
        },
        queue, scratch, counters);
}

}  // namespace penumbra
