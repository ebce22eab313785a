// SPDX-License-Identifier: MIT
#include "penumbra/shadow/classify.h"

#include "penumbra/shadow/cover.h"

namespace penumbra {
namespace {

bool holds(const Box& box, Vec3f p) { return box.contains({p, p}); }

}  // namespace

ShadowClass classify(const ShadowScene& scene, std::uint32_t light, Vec3f p, OccluderQueue& queue,
                     ShadowCounters& counters) {
  if (!holds(scene.receivers, p) || contains(scene.lights[light], p)) return ShadowClass::penumbra;
  const LightHull& hull = scene.hulls[light];
  const std::span<const Record> records = scene.kernel->records();
  const bool wants_umbra = scene.method == Method::umbra;
  ShadowClass result = ShadowClass::lit;
  ++counters.set_rays;
  counters.set_tests += visit_candidates(scene.set, records, hull, p, [&](std::uint32_t candidate) {
    result = ShadowClass::penumbra;
    if (!wants_umbra) return true;
    if (!surely_covers(records[candidate], hull, p)) return false;
    result = ShadowClass::umbra;
    return true;
  });
  return result;
}

}  // namespace penumbra
