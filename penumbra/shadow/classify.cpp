// SPDX-License-Identifier: MIT
#include "penumbra/shadow/classify.h"

#include "penumbra/shadow/cover.h"

namespace penumbra {
namespace {

bool holds(const Box& box, Vec3f p) { return box.contains({p, p}); }

/// One question to the shadow set: what its candidates come to.
struct Verdict {
  const ShadowScene& scene;
  std::uint32_t light;
  Vec3f p;
  OccluderQueue& queue;
  ShadowClass result = ShadowClass::lit;

  /// True when it is settled.
  bool settles(std::uint32_t candidate) {
    const bool is_first = result == ShadowClass::lit;
    result = ShadowClass::penumbra;
    if (scene.method != Method::umbra) return true;
    if (!(is_first && volume_covers()) && !record_covers(candidate)) return false;
    result = ShadowClass::umbra;
    return true;
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

ShadowClass classify(const ShadowScene& scene, std::uint32_t light, Vec3f p, OccluderQueue& queue,
                     ShadowCounters& counters) {
  if (!holds(scene.receivers, p)) return ShadowClass::penumbra;
  Verdict verdict{scene, light, p, queue};
  ++counters.set_rays;
  counters.set_tests +=
      visit_candidates(scene.set, scene.kernel->records(), scene.hulls[light], p,
                       [&](std::uint32_t candidate) { return verdict.settles(candidate); });
  return verdict.result;
}

}  // namespace penumbra
