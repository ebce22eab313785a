// SPDX-License-Identifier: MIT
#include "penumbra/shadow/classify.h"

#include <algorithm>

#include "penumbra/shadow/cover.h"

namespace penumbra {
namespace {

bool holds(const Box& box, Vec3f p) { return box.contains({p, p}); }

/// One question to the shadow set: what its candidates come to.
struct Verdict {
  const ShadowScene& scene;
  std::uint32_t light;
  Vec3f p;
  ProofBudget budget;
  OccluderQueue& queue;
  ShadowClass result = ShadowClass::lit;

  Visit see(std::uint32_t record, bool is_candidate) {
    const bool is_first = is_candidate && result == ShadowClass::lit;
    if (is_candidate) result = ShadowClass::penumbra;
    if (result == ShadowClass::penumbra && scene.method != Method::umbra) return Visit::stop;
    if (is_candidate && ((is_first && volume_covers()) || record_covers(record))) {
      result = ShadowClass::umbra;
      return Visit::stop;
    }
    return pay(is_first);
  }

  /// One test is spent.
  Visit pay(bool is_first) {
    if (is_first) budget.tests = std::min(budget.tests, budget.tests_beyond_candidate);
    if (budget.tests-- > 0) return Visit::go_on;
    result = ShadowClass::penumbra;
    return Visit::stop;
  }

  bool volume_covers() {
    const std::uint32_t found =
        scene.inner.covering(light, scene.hulls[light], p, queue.inner_volume).volume;
    if (found != no_volume) queue.inner_volume = found;
    return found != no_volume;
  }

  bool record_covers(std::uint32_t record) {
    const bool covers = surely_covers(scene.kernel->records()[record], scene.hulls[light], p);
    if (covers) queue.move_to_front(record);
    return covers;
  }
};

}  // namespace

ProofBudget proof_budget(std::uint32_t shadow_samples) {
  return {32 + 4ull * shadow_samples, 4 + shadow_samples / 2};
}

ShadowClass classify(const ShadowScene& scene, std::uint32_t light, Vec3f p,
                     const ProofBudget& budget, OccluderQueue& queue, ShadowCounters& counters) {
  if (!holds(scene.receivers, p)) return ShadowClass::penumbra;
  Verdict verdict{scene, light, p, budget, queue};
  ++counters.set_rays;
  counters.set_tests += visit_occluders(
      scene.set, scene.kernel->records(), scene.hulls[light], p,
      [&](std::uint32_t record, bool is_candidate) { return verdict.see(record, is_candidate); });
  return verdict.result;
}

}  // namespace penumbra
