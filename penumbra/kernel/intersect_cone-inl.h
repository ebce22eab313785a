// SPDX-License-Identifier: MIT
// Rays against a cone or cylinder: a part of the intersector, see intersect-inl.h.
//
// Highway "inl" header: included once for each instruction set.

#if defined(PENUMBRA_KERNEL_INTERSECT_CONE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PENUMBRA_KERNEL_INTERSECT_CONE_INL_H_
#undef PENUMBRA_KERNEL_INTERSECT_CONE_INL_H_
#else
#define PENUMBRA_KERNEL_INTERSECT_CONE_INL_H_
#endif

#include <hwy/highway.h>

#include "penumbra/kernel/lanes-inl.h"
#include "penumbra/kernel/record.h"

HWY_BEFORE_NAMESPACE();
namespace penumbra::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Rays against a cone's axis: everything split into its part along the axis and the rest.
template <class V>
struct ConeLanes {
  Vec3Lanes<V> axis, origin, direction;  // origin relative to the base
  Vec3Lanes<V> radial_origin, radial_direction;
  V axial_direction;
  V t_base, t_apex;  // where the ray crosses the planes of the two circles
};

template <class D, class V = hn::Vec<D>>
HWY_INLINE ConeLanes<V> make_cone_lanes(D d, const Record& record, Vec3f origin,
                                        const RayLanes<D>& ray) {
  const Vec3f m = origin - record.vector(0), a = record.vector(3);
  const float axial = penumbra::dot(m, a);
  ConeLanes<V> cone;
  cone.axis = all_lanes(d, a);
  cone.origin = all_lanes(d, m);
  cone.direction = {ray.x, ray.y, ray.z};
  cone.axial_direction = dot(cone.direction, cone.axis);
  cone.radial_origin = all_lanes(d, m - a * axial);
  cone.radial_direction = along(cone.direction, hn::Neg(cone.axial_direction), cone.axis);
  const V inverse = safe_reciprocal(d, cone.axial_direction);
  cone.t_base = hn::Mul(hn::Set(d, -axial), inverse);
  cone.t_apex = hn::Mul(hn::Set(d, record.number[6] - axial), inverse);
  return cone;
}

/// Quadratic about the point of the ray that is nearest to the axis within the cone's slab, so that
/// the numbers it squares are of the cone's size and not of the distance.
template <class D, class Report, class V = hn::Vec<D>>
HWY_INLINE void intersect_cone_side(D d, const Record& record, const ConeLanes<V>& cone,
                                    Report&& report) {
  const V zero = hn::Zero(d), height = hn::Set(d, record.number[6]);
  const V square = dot(cone.radial_direction, cone.radial_direction);
  const V nearest =
      hn::Mul(hn::Neg(dot(cone.radial_direction, cone.radial_origin)), safe_reciprocal(d, square));
  const V shift = hn::Min(hn::Max(nearest, hn::Min(cone.t_base, cone.t_apex)),
                          hn::Max(cone.t_base, cone.t_apex));

  const Vec3Lanes<V> there = along(cone.origin, shift, cone.direction);
  const V axial = dot(there, cone.axis);
  const Vec3Lanes<V> radial = along(there, hn::Neg(axial), cone.axis);
  const V slope = hn::Set(d, record.number[9]);
  const V radius = hn::Add(hn::Set(d, record.number[7]), hn::Mul(slope, axial));
  const V growth = hn::Mul(slope, cone.axial_direction);
  const V A = hn::Sub(square, hn::Mul(growth, growth));
  const V B = hn::Sub(dot(radial, cone.radial_direction), hn::Mul(growth, radius));
  const V C = hn::Sub(dot(radial, radial), hn::Mul(radius, radius));
  const V discriminant = hn::Sub(hn::Mul(B, B), hn::Mul(A, C));
  const auto real = hn::Ge(discriminant, zero);
  if (hn::AllFalse(d, real)) return;
  const V root = hn::Sqrt(hn::Max(discriminant, zero));
  const V q = hn::Neg(hn::Add(B, hn::CopySign(root, B)));
  for (const V& step : {hn::Div(C, q), hn::Div(q, A)}) {
    const V at = hn::Add(axial, hn::Mul(step, cone.axial_direction));
    const auto hit = hn::And(real, hn::And(hn::Ge(at, zero), hn::Le(at, height)));
    if (!hn::AllFalse(d, hit)) report(hn::Add(shift, step), hit);
  }
}

template <class D, class Report, class V = hn::Vec<D>>
HWY_INLINE void intersect_cap(D d, const ConeLanes<V>& cone, V t, float radius, Report&& report) {
  const Vec3Lanes<V> there = along(cone.radial_origin, t, cone.radial_direction);
  const auto hit = hn::Le(dot(there, there), hn::Set(d, radius * radius));
  if (!hn::AllFalse(d, hit)) report(t, hit);
}

template <class D, class Report>
HWY_INLINE void intersect_cone(D d, const Record& record, Vec3f origin, const RayLanes<D>& ray,
                               Report&& report) {
  const auto cone = make_cone_lanes(d, record, origin, ray);
  intersect_cone_side(d, record, cone, report);
  if (!record.is_capped) return;
  intersect_cap(d, cone, cone.t_base, record.number[7], report);
  intersect_cap(d, cone, cone.t_apex, record.number[8], report);
}

}  // namespace penumbra::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include once for each instruction set
