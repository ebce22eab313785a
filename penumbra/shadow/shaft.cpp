// SPDX-License-Identifier: MIT
#include "penumbra/shadow/shaft.h"

#include <algorithm>

#include "penumbra/geometry/separation.h"
#include "penumbra/kernel/kernel.h"
#include "penumbra/shadow/cover.h"
#include "penumbra/shadow/light_box.h"
#include "penumbra/shadow/offset.h"
#include "penumbra/shadow/record_hull.h"

namespace penumbra {
namespace {

bool surely_misses_shaft(const Record& record, const LightHull& light, Vec3f p) {
  const LightShaft shaft(light, p);
  double margin = hit_bound(record, p) + light.doubt(p);
  if (record.kind == ShapeKind::sphere) margin += record.number[3];
  return with_hull(record, [&](const auto& shape) {
    const Vec3d middle = (Vec3d(shape.support({1, 0, 0})) + Vec3d(shape.support({-1, 0, 0}))) * 0.5;
    const Vec3d along = shaft.c - shaft.p;
    const double s = std::clamp(dot(middle - shaft.p, along) / length_squared(along), 0.0, 1.0);
    return surely_apart(shaft, shape, shaft.p + along * s - middle, margin);
  });
}

/// The shaft's boxes, grown by what samples may lie off the light.
ShaftBounds bounds_of(const LightHull& light, const Box& receivers) {
  const ExtentBox spread = spread_box(light);
  const double doubt = greatest_doubt(light, receivers);
  const Vec3d pad{doubt, doubt, doubt};
  const Vec3d from_lo = light.center(receivers.lo) - Vec3d(receivers.lo);
  const Vec3d from_hi = light.center(receivers.hi) - Vec3d(receivers.hi);
  const Box ways = outward(from_lo + spread.lo - pad, from_lo);
  const Box far_ways = outward(from_hi, from_hi + spread.hi + pad);
  return {receivers, ways.lo, far_ways.hi};
}

}  // namespace

bool gather_candidates(const ShadowScene& scene, std::uint32_t light, const Box& receivers,
                       std::size_t most, CandidateList& list, std::uint64_t& tests) {
  list.clear();
  if (!scene.receivers.contains(receivers)) return false;
  const std::span<const Record> records = scene.kernel->records();
  const auto add = [&](std::uint32_t first, std::uint32_t count) {
    for (std::uint32_t i = first; i < first + count; ++i)
      if (records[i].casts_shadow) list.add(records[i], i);
    tests += count;
    return list.size() > most;
  };
  return !walk(scene.kernel->nodes(), bounds_of(scene.hulls[light], receivers), add);
}

Proof prove_by_candidates(const ShadowScene& scene, std::uint32_t light, Vec3f p,
                          OccluderQueue& queue, ShaftScratch& scratch) {
  const LightHull& hull = scene.hulls[light];
  const std::span<const Record> records = scene.kernel->records();
  std::vector<std::uint32_t>& list = scratch.sifted;
  list.clear();
  scratch.tile.sift(hull, p, list);
  constexpr std::size_t few = 12;
  std::erase_if(list, [&](std::uint32_t i) {
    const Record& record = records[i];
    if (surely_behind_horizon(record, hull, p)) return true;
    return (record.kind == ShapeKind::cone || record.kind == ShapeKind::ring || !hull.is_ball()) &&
           surely_misses_shaft(record, hull, p);
  });
  if (list.empty()) return {ShadowClass::lit, true, {}};
  const VolumeAnswer volume = scene.inner.covering(light, hull, p, queue.inner_volume);
  if (volume.volume != no_volume) {
    queue.inner_volume = volume.volume;
    return {ShadowClass::umbra, true, {}};
  }
  for (std::uint32_t& i : list)  // what blocked last, first
    if (i == queue.record[0]) std::swap(i, list.front());
  for (const std::uint32_t i : std::span(list).first(std::min(list.size(), few)))
    if (surely_covers(records[i], hull, p)) {
      queue.move_to_front(i);
      return {ShadowClass::umbra, true, {}};
    }
  return {ShadowClass::penumbra, true, list};
}

}  // namespace penumbra
