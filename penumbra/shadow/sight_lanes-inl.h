// SPDX-License-Identifier: MIT
// The light in lanes: as one receiver (or group) sees it, for lanes of candidates, or as sixteen
// receivers do, for one candidate. u = 2^-24; sums of products are off by at most 8 u of the sum of
// their terms' sizes, and are padded by 16 u = 2^-20 of it.
//
// Highway "inl" header: included once for each instruction set.

#if defined(PENUMBRA_SHADOW_SIGHT_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PENUMBRA_SHADOW_SIGHT_LANES_INL_H_
#undef PENUMBRA_SHADOW_SIGHT_LANES_INL_H_
#else
#define PENUMBRA_SHADOW_SIGHT_LANES_INL_H_
#endif

#include <hwy/highway.h>

#include <cstdint>

#include "penumbra/kernel/lanes-inl.h"
#include "penumbra/shadow/seen_light.h"

HWY_BEFORE_NAMESPACE();
namespace penumbra::HWY_NAMESPACE {

using LaneVec = Vec3Lanes<Lane>;
constexpr float sum_pad = 0x1p-20f;
/// What is nearer than this to anything may be hit for lack of float's range.
constexpr float tiny = 2e-18f;

HWY_INLINE LaneMask none() { return hn::FirstN(lane_tag, 0); }
HWY_INLINE Lane all(float x) { return hn::Set(lane_tag, x); }
HWY_INLINE LaneVec all(Vec3f v) { return {all(v.x), all(v.y), all(v.z)}; }
HWY_INLINE LaneVec sub(const LaneVec& a, const LaneVec& b) {
  return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}
HWY_INLINE LaneVec scaled(const LaneVec& a, Lane s) {
  return {hn::Mul(a.x, s), hn::Mul(a.y, s), hn::Mul(a.z, s)};
}
HWY_INLINE Lane norm(const LaneVec& a) { return hn::Sqrt(dot(a, a)); }
HWY_INLINE Lane max_of(Lane a, Lane b, Lane c) { return hn::Max(a, hn::Max(b, c)); }
HWY_INLINE Lane min_of(Lane a, Lane b, Lane c) { return hn::Min(a, hn::Min(b, c)); }
HWY_INLINE Lane largest(const LaneVec& a) {
  return max_of(hn::Abs(a.x), hn::Abs(a.y), hn::Abs(a.z));
}
HWY_INLINE LaneMask is_inside(const LaneVec& p, const Box& box) {
  const auto within = [](Lane x, float lo, float hi) {
    return hn::And(hn::Ge(x, all(lo)), hn::Le(x, all(hi)));
  };
  return hn::And(within(p.x, box.lo.x, box.hi.x),
                 hn::And(within(p.y, box.lo.y, box.hi.y), within(p.z, box.lo.z, box.hi.z)));
}

/// The numbers that all tests share.
struct SightLanes {
  explicit SightLanes(const SeenLight& seen)
      : light(*seen.light),
        form(seen.counts_as_ball ? LightForm::Form::ball : seen.light->form),
        p(all(seen.p)),
        n(all(seen.normal)),
        way(all(seen.way)),
        distance(all(seen.distance)),
        doubt(all(seen.doubt)),
        radius(seen.receiver_radius),
        floor(seen.floor) {
    add_sizes(seen.size);
  }
  SightLanes(const LightForm& light_, const ReceiverRows& rows, std::size_t first)
      : light(light_),
        form(light_.form),
        p(load(rows.p, first)),
        n(load(rows.normal, first)),
        way(load(rows.way, first)),
        distance(hn::LoadU(lane_tag, rows.distance + first)),
        doubt(hn::LoadU(lane_tag, rows.doubt + first)) {
    add_sizes(light_.size);
  }

  const LightForm& light;
  LightForm::Form form;
  LaneVec p, n, way;
  Lane distance, doubt;
  float radius = 0, floor = 0;  // r, of the receivers
  Lane size;                    // R, with all rounding
  Lane taper;        // R - r: the shaft's cross-section at t has the radius r + t (R - r)
  Lane reach;        // farther than any sample
  Lane least_reach;  // of what something is proven (`greatest_ratio`); a sun's rays are unit

  /// The largest m . (l - c) over the samples, rounded up.
  HWY_INLINE Lane extent(const LaneVec& m, Lane length) const {
    if (form == LightForm::Form::ball) return hn::Mul(hn::Mul(size, all(1 + sum_pad)), length);
    Lane most;
    if (form == LightForm::Form::disk) {
      most = hn::Mul(all(light.size), norm(cross(m, all(light.axis))));
    } else {
      most = dot(m, all(light.corner[0]));
      for (std::uint32_t i = 1; i < light.corner_count; ++i)
        most = hn::Max(most, dot(m, all(light.corner[i])));
    }
    return hn::Add(most, hn::Mul(hn::Add(doubt, all(sum_pad * light.size)), length));
  }

 private:
  static HWY_INLINE LaneVec load(const float (&row)[3][ReceiverRows::padded], std::size_t first) {
    return {hn::LoadU(lane_tag, row[0] + first), hn::LoadU(lane_tag, row[1] + first),
            hn::LoadU(lane_tag, row[2] + first)};
  }
  HWY_INLINE void add_sizes(float of_light) {
    size = hn::Mul(hn::Add(all(of_light), doubt), all(1 + sum_pad));
    taper = hn::Sub(size, all(radius));
    constexpr float least_ratio = 1 / greatest_ratio;
    least_reach = light.is_sun ? hn::Zero(lane_tag) : hn::Mul(distance, all(least_ratio));
    reach = hn::Add(hn::Mul(distance, all(1 + sum_pad)), hn::Add(size, all(radius)));
  }
};

}  // namespace penumbra::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include once for each instruction set
