// SPDX-License-Identifier: MIT
// The tests of sift.h, in lanes.
//
// Highway "inl" header: included once for each instruction set.

#if defined(PENUMBRA_SHADOW_SIFT_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PENUMBRA_SHADOW_SIFT_LANES_INL_H_
#undef PENUMBRA_SHADOW_SIFT_LANES_INL_H_
#else
#define PENUMBRA_SHADOW_SIFT_LANES_INL_H_
#endif

#include <hwy/highway.h>

#include "penumbra/shadow/sight_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace penumbra::HWY_NAMESPACE {

/// (1): the highest point of the shape over the horizon, and the shape's farthest coordinate from
/// p. Active samples rise from p by more than -3 u of their distance; hits lie within `ulps` of it.
HWY_INLINE LaneMask below_horizon(const SightLanes& sight, Lane highest, Lane reach, float ulps) {
  const Lane all_reach = hn::Add(reach, all(2 * sight.radius));
  return hn::Lt(hn::Add(highest, hn::Mul(all((ulps + 16) * 0x1p-24f), all_reach)),
                all(sight.floor - tiny));
}

/// (2) for balls at v of radius `grown` (by what hits may lie off): with w the way to the light,
/// the shaft's cross-section at t touches it where a t² - 2 b t + c <= 0; rho is grown + r and T
/// the taper, a = w² - T², b = v w + rho T, c = v² - rho². Rounded so that a and c are too small
/// and b is too large.
HWY_INLINE LaneMask misses_cone(const SightLanes& sight, const LaneVec& v, Lane grown) {
  const Lane zero = hn::Zero(lane_tag), pad = all(sum_pad), square = dot(v, v);
  const Lane w2 = hn::Mul(sight.distance, sight.distance);
  const Lane a =
      hn::Sub(hn::Sub(w2, hn::Mul(sight.taper, sight.taper)), hn::Mul(all(4 * sum_pad), w2));
  const Lane rho = hn::Add(grown, all(sight.radius));
  const Lane rho_square = hn::Mul(rho, rho), spread = hn::Mul(rho, sight.taper);
  const Lane c = hn::Sub(hn::Sub(square, rho_square), hn::Mul(pad, hn::Add(square, rho_square)));
  const Lane sizes = hn::Add(hn::Mul(hn::Sqrt(square), sight.distance), hn::Abs(spread));
  const Lane b = hn::Add(hn::Add(dot(v, sight.way), spread), hn::Mul(pad, sizes));
  const Lane b_square = hn::Add(hn::Mul(hn::Mul(b, b), all(1 + sum_pad)), all(1e-36f));
  const Lane at_end = hn::Sub(hn::Add(a, c), hn::Add(b, b));
  const Lane end_pad = hn::Mul(pad, hn::Add(hn::Add(w2, square), hn::Add(sizes, sizes)));
  const LaneMask beyond = hn::And(hn::Gt(b, a), hn::Gt(at_end, end_pad));
  const LaneMask outside = hn::Lt(b_square, hn::Mul(a, c));
  const LaneMask is_cone = hn::And(hn::Gt(a, zero), hn::Gt(c, zero));
  return hn::And(is_cone, hn::Or(hn::Lt(b, zero), hn::Or(outside, beyond)));
}

/// Whether the light's cross-section at some t lies in the ball of radius `room` at v (paper, Lemma
/// 3, for each t of its own). Any t proves it; the best is where the sections' boundaries are
/// nearest. `room` is what is left of the radius by all that must be kept off.
HWY_INLINE LaneMask holds_section(const SightLanes& sight, const LaneVec& v, Lane room) {
  const Lane slope =
      hn::Sub(hn::Mul(sight.distance, sight.distance), hn::Mul(sight.taper, sight.taper));
  const Lane rest = hn::Sub(room, all(sight.radius * (1 + sum_pad)));
  const Lane b = hn::Sub(dot(v, sight.way), hn::Mul(rest, sight.taper));
  const Lane t = hn::Min(hn::Max(hn::Div(b, slope), hn::Zero(lane_tag)), all(1.0f));
  const LaneVec off = along(v, hn::Neg(t), sight.way);
  const Lane growth = hn::Mul(t, hn::Add(sight.taper, hn::Mul(all(2 * sum_pad), sight.reach)));
  const Lane rounding = hn::Mul(all(sum_pad), largest(v));
  return hn::And(hn::Gt(slope, hn::Zero(lane_tag)),
                 hn::Gt(rest, hn::Add(hn::Add(norm(off), rounding), growth)));
}

struct Verdict {
  LaneMask missed, covers;
};

/// A sphere covers where it holds a cross-section and the light lies outside.
HWY_INLINE Verdict test_spheres(const SightLanes& sight, const LaneVec& center, Lane radius) {
  const LaneVec v = sub(center, sight.p);
  const Lane reach = hn::Add(hn::Add(largest(v), radius), all(sight.radius));
  const Lane grown = hn::Add(radius, hn::Add(hn::Mul(all(0x1p-19f), reach), all(tiny)));
  Verdict verdict;
  const LaneMask in_range = hn::Gt(reach, sight.least_reach);
  verdict.missed =
      hn::And(in_range, hn::Or(below_horizon(sight, hn::Add(dot(v, sight.n), radius), reach, 16),
                               misses_cone(sight, v, grown)));
  verdict.covers = none();
  if (hn::AllTrue(lane_tag, verdict.missed)) return verdict;
  // Deeper than 64 ulp, and the light as far outside.
  const Lane margin = hn::Add(hn::Mul(all(0x1.1p-18f), reach), all(tiny));
  const Lane clear =
      hn::Add(hn::Add(radius, sight.size),
              hn::Add(hn::Add(margin, margin), hn::Mul(all(4 * sum_pad), sight.reach)));
  verdict.covers = hn::And(in_range, hn::And(holds_section(sight, v, hn::Sub(radius, margin)),
                                             hn::Gt(norm(sub(v, sight.way)), clear)));
  return verdict;
}

/// A ring counts as the ball around it; only its horizon is its own.
HWY_INLINE LaneMask rings_missed(const SightLanes& sight, const LaneVec& center,
                                 const LaneVec& normal, Lane radius) {
  const LaneVec v = sub(center, sight.p);
  const Lane reach = hn::Add(hn::Add(largest(v), radius), all(sight.radius));
  const Lane highest = hn::Add(dot(v, sight.n), hn::Mul(radius, norm(cross(sight.n, normal))));
  const Lane grown = hn::Add(radius, hn::Add(hn::Mul(all(0x1p-19f), reach), all(tiny)));
  return hn::And(hn::Gt(reach, sight.least_reach),
                 hn::Or(below_horizon(sight, highest, reach, 16), misses_cone(sight, v, grown)));
}

/// (2) for a capsule, the points within rho of v + u e, 0 <= u <= 1. The cone around the light has
/// the half angle alpha; with r and z the distances from its axis and along it, a point is outside
/// by r cos alpha - z sin alpha at least. That is convex in u: the tangent at any u bounds it.
HWY_INLINE LaneMask capsule_misses_cone(const SightLanes& sight, const LaneVec& v, const LaneVec& e,
                                        Lane rho, Lane reach) {
  const Lane zero = hn::Zero(lane_tag), one = all(1.0f), inverse = hn::Div(one, sight.distance);
  const Lane sine = hn::Add(hn::Mul(sight.taper, inverse), all(4 * sum_pad));
  const LaneMask is_cone = hn::Lt(hn::Abs(sine), all(0.999f));
  const Lane cosine =
      hn::Sqrt(hn::Max(hn::Mul(hn::Sub(one, sine), hn::Add(one, sine)), all(1e-6f)));
  const LaneVec axis = scaled(sight.way, inverse);
  const Lane z0 = dot(v, axis), rise = dot(e, axis);
  const LaneVec x = cross(v, axis), y = cross(e, axis);
  const Lane yy = dot(y, y), xy = dot(x, y), xx = dot(x, x);
  // Lowest where the slope of r is tan alpha times that of z.
  const Lane nearest = hn::Div(hn::Neg(xy), yy);
  const Lane least = hn::Sqrt(hn::Max(zero, hn::Add(xx, hn::Mul(nearest, xy))));
  const Lane k = hn::Div(sine, cosine), slope = hn::Mul(k, rise);
  const Lane shift =
      hn::Div(hn::Mul(slope, least),
              hn::Sqrt(hn::Mul(yy, hn::Max(zero, hn::Sub(yy, hn::Mul(slope, slope))))));
  // Where yy is about 0, NaN and infinity become some u in [0, 1]: Max and Min may return either.
  const Lane u = hn::Min(hn::Max(hn::Add(nearest, shift), zero), one);
  const LaneMask is_number = hn::And(hn::Ge(u, zero), hn::Le(u, one));
  const Lane at = hn::IfThenElse(is_number, u, zero);
  const LaneVec there{hn::Add(x.x, hn::Mul(at, y.x)), hn::Add(x.y, hn::Mul(at, y.y)),
                      hn::Add(x.z, hn::Mul(at, y.z))};
  const Lane r = norm(there);
  const Lane outside = hn::Sub(hn::Mul(cosine, r), hn::Mul(sine, hn::Add(z0, hn::Mul(at, rise))));
  const Lane tangent = hn::Sub(hn::Div(hn::Mul(cosine, dot(there, y)), r), hn::Mul(sine, rise));
  const Lane bound =
      hn::Add(outside, hn::Min(hn::Mul(tangent, hn::Neg(at)), hn::Mul(tangent, hn::Sub(one, at))));
  // Where r is small its direction, and so the tangent, is unsure.
  const Lane doubt = hn::Add(all(8.0f), hn::Div(hn::Sqrt(yy), r));
  const Lane needed =
      hn::Add(hn::Add(rho, all(sight.radius)), hn::Mul(hn::Mul(all(sum_pad), reach), doubt));
  const Lane lowest = hn::Min(z0, hn::Add(z0, rise)), highest = hn::Max(z0, hn::Add(z0, rise));
  const LaneMask behind = hn::Lt(hn::Add(highest, needed), zero);
  const LaneMask beyond =
      hn::Gt(hn::Sub(lowest, needed), hn::Mul(all(1 + 4 * sum_pad), sight.reach));
  return hn::Or(hn::And(is_cone, hn::Or(hn::Gt(bound, needed), behind)), beyond);
}

struct ConeColumn {
  LaneVec base, axis;
  Lane height, base_radius, apex_radius;
};

HWY_INLINE LaneMask cones_missed(const SightLanes& sight, const ConeColumn& cone) {
  const LaneVec v = sub(cone.base, sight.p), e = scaled(cone.axis, cone.height);
  const Lane radius = hn::Max(cone.base_radius, cone.apex_radius);
  const LaneVec top{hn::Add(v.x, e.x), hn::Add(v.y, e.y), hn::Add(v.z, e.z)};
  const Lane reach = hn::Add(hn::Max(largest(v), largest(top)), hn::Add(radius, all(sight.radius)));
  // The part of the normal across the axis: how high the circles reach over their centres.
  const Lane across = norm(cross(sight.n, cone.axis));
  const Lane low = dot(v, sight.n), high = hn::Add(low, dot(e, sight.n));
  const Lane highest = hn::Max(hn::Add(low, hn::Mul(cone.base_radius, across)),
                               hn::Add(high, hn::Mul(cone.apex_radius, across)));
  const Lane grown = hn::Add(radius, hn::Add(hn::Mul(all(0x1p-18f), reach), all(tiny)));
  return hn::And(hn::Gt(reach, sight.least_reach),
                 hn::Or(below_horizon(sight, highest, reach, 32),
                        capsule_misses_cone(sight, v, e, grown, reach)));
}

struct TriangleColumn {
  LaneVec corner[3];
};

/// (3). What is nearer to p than `nearest`, of which hits may lie off by 64 u of the reach, can't
/// be told apart by planes through p: a hit has to lie so far off that the light's angle outside of
/// the plane makes more of it.
HWY_INLINE LaneMask triangles_missed_by_one(const SightLanes& sight,
                                            const TriangleColumn& triangle) {
  const Lane zero = hn::Zero(lane_tag);
  const LaneVec v[3] = {sub(triangle.corner[0], sight.p), sub(triangle.corner[1], sight.p),
                        sub(triangle.corner[2], sight.p)};
  const Lane reach = max_of(largest(v[0]), largest(v[1]), largest(v[2]));
  const Lane highest = max_of(dot(v[0], sight.n), dot(v[1], sight.n), dot(v[2], sight.n));
  const LaneMask in_range = hn::Gt(reach, sight.least_reach);
  const LaneMask below = hn::And(in_range, below_horizon(sight, highest, reach, 64));
  if (hn::AllTrue(lane_tag, below)) return below;
  const LaneVec e[3] = {sub(triangle.corner[1], triangle.corner[0]),
                        sub(triangle.corner[2], triangle.corner[1]),
                        sub(triangle.corner[0], triangle.corner[2])};
  LaneVec m = cross(e[0], e[1]);
  const Lane length[3] = {norm(e[0]), norm(e[1]), norm(e[2])};
  const Lane edges = hn::Mul(length[0], length[1]), rounding = hn::Mul(all(sum_pad), edges);
  const Lane far[3] = {norm(v[0]), norm(v[1]), norm(v[2])};
  const Lane farthest = max_of(far[0], far[1], far[2]);
  Lane height = hn::Neg(dot(m, v[0]));  // of p, times |m|
  const Lane side = hn::CopySign(all(1.0f), height);
  m = scaled(m, side), height = hn::Abs(height);
  const Lane m_length = norm(m);
  const LaneMask sure_side =
      hn::And(hn::Gt(height, hn::Max(hn::Mul(rounding, farthest), all(1e-30f))),
              hn::Gt(m_length, all(1e-18f)));
  const Lane lowest = hn::Sub(dot(m, sight.way), sight.extent(scaled(m, all(-1.0f)), m_length));
  const Lane unsure = hn::Mul(rounding, hn::Add(farthest, sight.reach));
  const Lane hit_bound = hn::Add(hn::Mul(all(0x1p-18f), reach), all(tiny));
  LaneMask missed =
      hn::Or(hn::Gt(lowest, unsure),
             hn::Gt(hn::Add(height, lowest), hn::Add(unsure, hn::Mul(hit_bound, m_length))));
  // How near a hit may be to p.
  const Lane over_plane = hn::Div(hn::Sub(height, hn::Mul(rounding, farthest)), m_length);
  const Lane over_corners =
      hn::Sub(min_of(far[0], far[1], far[2]), max_of(length[0], length[1], length[2]));
  const Lane nearest = hn::Sub(hn::Max(over_plane, over_corners), hn::Add(hit_bound, hit_bound));
  const Lane stray = hn::Mul(hit_bound, hn::Mul(all(1 + 4 * sum_pad), sight.reach));
  for (int k = 0; k < 3; ++k) {
    const LaneVec outward = scaled(cross(v[k], e[k]), side);
    const Lane out_length = norm(outward);
    const Lane out = hn::Sub(
        hn::Sub(dot(outward, sight.way), sight.extent(scaled(outward, all(-1.0f)), out_length)),
        hn::Mul(hn::Mul(all(sum_pad), sight.reach), hn::Mul(far[k], length[k])));
    missed = hn::Or(missed, hn::And(hn::Gt(nearest, zero),
                                    hn::Gt(hn::Mul(out, nearest), hn::Mul(stray, out_length))));
  }
  return hn::Or(below, hn::And(in_range, hn::And(missed, sure_side)));
}

/// For groups: the ball around the triangle.
HWY_INLINE LaneMask triangles_missed_by_all(const SightLanes& sight,
                                            const TriangleColumn& triangle) {
  const LaneVec v[3] = {sub(triangle.corner[0], sight.p), sub(triangle.corner[1], sight.p),
                        sub(triangle.corner[2], sight.p)};
  const Lane reach = max_of(largest(v[0]), largest(v[1]), largest(v[2]));
  const Lane highest = max_of(dot(v[0], sight.n), dot(v[1], sight.n), dot(v[2], sight.n));
  const Lane third = all(1.0f / 3);
  const LaneVec middle{hn::Mul(hn::Add(hn::Add(v[0].x, v[1].x), v[2].x), third),
                       hn::Mul(hn::Add(hn::Add(v[0].y, v[1].y), v[2].y), third),
                       hn::Mul(hn::Add(hn::Add(v[0].z, v[1].z), v[2].z), third)};
  const Lane radius =
      max_of(norm(sub(v[0], middle)), norm(sub(v[1], middle)), norm(sub(v[2], middle)));
  const Lane hits = hn::Mul(all(0x1p-17f), hn::Add(reach, all(sight.radius)));
  const Lane grown = hn::Add(hn::Add(radius, hits), all(tiny));
  return hn::And(hn::Gt(reach, sight.least_reach), hn::Or(below_horizon(sight, highest, reach, 64),
                                                          misses_cone(sight, middle, grown)));
}

HWY_INLINE LaneMask triangles_missed(const SightLanes& sight, const TriangleColumn& triangle) {
  return sight.radius > 0 ? triangles_missed_by_all(sight, triangle)
                          : triangles_missed_by_one(sight, triangle);
}

}  // namespace penumbra::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include once for each instruction set
