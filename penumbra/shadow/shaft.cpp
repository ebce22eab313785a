// SPDX-License-Identifier: MIT
#include "penumbra/shadow/shaft.h"

#include <cmath>

#include "penumbra/kernel/kernel.h"

namespace penumbra {
namespace {

/// Rounded down and up by more than float's rounding.
Vec3f below(Vec3d v) {
  return Vec3f(v - Vec3d(std::abs(v.x), std::abs(v.y), std::abs(v.z)) * 0x1p-22);
}
Vec3f above(Vec3d v) { return -below(-v); }

/// The shaft's boxes, grown by what samples may lie off the light.
ShaftBounds bounds_of(const LightHull& light, const Box& receivers) {
  // Convex in p: the greatest is at a corner.
  const Vec3f far = max(max(receivers.hi, -receivers.lo), Vec3f{});
  const double distance =
      length(light.center(receivers.lo) - Vec3d(receivers.lo)) + length(Vec3d(receivers.size()));
  const double doubt = light.doubt(far, distance);
  const Vec3d pad{doubt, doubt, doubt};
  const Vec3d from_lo = light.center(receivers.lo) - Vec3d(receivers.lo);
  const Vec3d from_hi = light.center(receivers.hi) - Vec3d(receivers.hi);
  return {receivers, below(from_lo + light.spread_box().lo - pad),
          above(from_hi + light.spread_box().hi + pad)};
}

/// What is below the receivers' horizon blocks nothing. Hits may lie off by 64 ulp of the scene's
/// extent at most.
void add_floor(const SeenLight& sight, const Box& scene, ShaftBounds& bounds) {
  const double extent = max_abs(scene.size()) + max_abs(scene.lo) + max_abs(scene.hi);
  const double height = dot(Vec3d(sight.normal), Vec3d(sight.p)) + double(sight.floor);
  bounds.up = sight.normal;
  bounds.floor = static_cast<float>(height - 0x1p-17 * extent);
}

}  // namespace

ShaftBounds shaft_bounds(const ShadowScene& scene, std::uint32_t light, const Box& receivers,
                         const SeenLight& sight) {
  ShaftBounds bounds = bounds_of(scene.hulls[light], receivers);
  add_floor(sight, scene.receivers, bounds);
  return bounds;
}

bool gather_candidates(const ShadowScene& scene, std::uint32_t light, const Box& receivers,
                       const SeenLight& sight, std::size_t most, CandidateList& list,
                       std::uint64_t& tests) {
  list.clear();
  const WideTree& tree = scene.kernel->tree();
  if (scene.kernel->bounds().is_empty()) return true;  // there is nothing
  if (tree.nodes.empty()) return false;
  const auto add = [&](std::span<const Record> records, std::uint32_t first) {
    for (std::uint32_t i = 0; i < records.size(); ++i)
      if (records[i].casts_shadow) list.add(records[i], first + i);
    tests += records.size();
    return list.size() > most;
  };
  return !walk(tree, shaft_bounds(scene, light, receivers, sight), add);
}

}  // namespace penumbra
