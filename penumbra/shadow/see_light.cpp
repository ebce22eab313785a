// SPDX-License-Identifier: MIT
#include <algorithm>

#include "penumbra/shadow/seen_light.h"

// Highway compiles the rest once for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "penumbra/shadow/see_light.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

#include "penumbra/shadow/sight_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace penumbra::HWY_NAMESPACE {

/// Squares and products of four lengths stay in float's range.
constexpr float least_distance = 1e-6f, most_distance = 1e8f, least_size = 1e-12f;

void SeeLight(const LightForm& light, const Box& scene, ReceiverRows& rows, ReceiverBits& bits) {
  for (std::size_t i = 0; i < rows.count; i += lane_count) {
    const LaneVec p{hn::LoadU(lane_tag, rows.p[0] + i), hn::LoadU(lane_tag, rows.p[1] + i),
                    hn::LoadU(lane_tag, rows.p[2] + i)};
    const LaneVec n{hn::LoadU(lane_tag, rows.normal[0] + i),
                    hn::LoadU(lane_tag, rows.normal[1] + i),
                    hn::LoadU(lane_tag, rows.normal[2] + i)};
    LaneVec way = all(light.center);
    if (!light.is_sun) {
      const LaneVec rest = all(light.center_rest), to = sub(way, p);
      way = {hn::Add(to.x, rest.x), hn::Add(to.y, rest.y), hn::Add(to.z, rest.z)};
    }
    const Lane distance = norm(way);
    const Lane sizes =
        hn::Add(hn::Add(hn::Mul(all(1.75f), largest(p)), distance), all(2 * light.size));
    const Lane doubt = hn::Mul(all(0x1.01p-20f), sizes);
    hn::StoreU(way.x, lane_tag, rows.way[0] + i);
    hn::StoreU(way.y, lane_tag, rows.way[1] + i);
    hn::StoreU(way.z, lane_tag, rows.way[2] + i);
    hn::StoreU(distance, lane_tag, rows.distance + i);
    hn::StoreU(doubt, lane_tag, rows.doubt + i);
    const SightLanes sight(light, rows, i);
    const Lane height = dot(n, way), length = norm(n);
    const Lane unsure = hn::Mul(all(sum_pad), distance);
    const LaneVec down = scaled(n, all(-1.0f));
    const LaneMask has_no_horizon = hn::Eq(largest(n), hn::Zero(lane_tag));
    const LaneMask above =
        hn::Or(has_no_horizon, hn::Gt(hn::Sub(height, sight.extent(down, length)), unsure));
    const LaneMask below =
        hn::Lt(hn::Add(hn::Add(height, sight.extent(n, length)), unsure), hn::Zero(lane_tag));
    const Lane outside = hn::Add(all(light.size * (1 + sum_pad)), hn::Mul(doubt, all(6.0f)));
    LaneMask usable =
        hn::And(hn::Gt(distance, all(least_distance)), hn::Lt(distance, all(most_distance)));
    usable = hn::And(
        usable, hn::And(hn::Lt(hn::Abs(height), all(most_distance)), hn::Lt(length, all(1.001f))));
    usable = hn::And(usable, hn::And(hn::Lt(outside, all(most_distance)), is_inside(p, scene)));
    const LaneMask apart = hn::Gt(distance, outside);
    bits.certain |= std::uint64_t(bits_of(hn::And(usable, apart))) << i;
    bits.near |= std::uint64_t(bits_of(hn::AndNot(apart, usable))) << i;
    bits.above |= std::uint64_t(bits_of(above)) << i;
    bits.below |= std::uint64_t(bits_of(below)) << i;
  }
  const std::uint64_t used = rows.count == 64 ? ~0ull : (1ull << rows.count) - 1;
  const std::uint64_t usable = light.size > least_size && light.size < most_distance ? used : 0;
  bits.certain &= usable, bits.near &= usable;
  bits.above &= bits.certain | bits.near, bits.below &= bits.certain | bits.near;
}

}  // namespace penumbra::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace penumbra {

HWY_EXPORT(SeeLight);

ReceiverBits see_light(const LightForm& light, std::span<const ShadowQuery> queries,
                       const Box& scene, ReceiverRows& rows) {
  rows.count = std::min(queries.size(), ReceiverRows::most);
  for (std::size_t i = 0; i < rows.count; ++i)
    for (int axis = 0; axis < 3; ++axis) {
      rows.p[axis][i] = queries[i].receiver.position[axis];
      rows.normal[axis][i] = queries[i].receiver.normal[axis];
    }
  ReceiverBits bits;
  HWY_DYNAMIC_DISPATCH(SeeLight)(light, scene, rows, bits);
  return bits;
}

}  // namespace penumbra
#endif
