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

#include <algorithm>
#include <cmath>

#include "penumbra/kernel/lanes-inl.h"
#include "penumbra/kernel/record.h"

HWY_BEFORE_NAMESPACE();
namespace penumbra::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Rays against a cone's axis: everything split into its part along the axis and the rest.
/// Directions are unit length here, so that products of four lengths never appear: they leave
/// float's range.
template <class V>
struct ConeLanes {
  Vec3Lanes<V> axis, origin, direction;  // origin relative to the base
  Vec3Lanes<V> radial_origin, radial_direction;
  V axial_direction;
  float axial_origin;
  V inverse_length;  // from lengths along the ray to its t
};

template <class D, class V = hn::Vec<D>>
HWY_INLINE ConeLanes<V> make_cone_lanes(D d, const Record& record, Vec3f origin,
                                        const RayLanes<D>& ray) {
  const Vec3f m = origin - record.vector(0), a = record.vector(3);
  ConeLanes<V> cone;
  cone.inverse_length = hn::Sqrt(ray.inverse_square);
  cone.axial_origin = penumbra::dot(m, a);
  cone.axis = all_lanes(d, a);
  cone.origin = all_lanes(d, m);
  cone.direction = {hn::Mul(ray.x, cone.inverse_length), hn::Mul(ray.y, cone.inverse_length),
                    hn::Mul(ray.z, cone.inverse_length)};
  cone.axial_direction = dot(cone.direction, cone.axis);
  cone.radial_origin = all_lanes(d, m - a * cone.axial_origin);
  cone.radial_direction = along(cone.direction, hn::Neg(cone.axial_direction), cone.axis);
  return cone;
}

/// No point of the cone is farther from the origin along any axis.
inline float cone_reach(const Record& record, Vec3f origin) {
  return max_abs(origin - record.vector(0)) + record.number[6] +
         std::max(record.number[7], record.number[8]);
}

/// Side and caps reach past their common rims by what float can't tell, so that no ray through a
/// rim is left to the cap by the side and to the side by the cap.
inline float rim_overlap(const Record& record, Vec3f origin) {
  return 0x1p-22f * cone_reach(record, origin);
}

/// The point of the ray that is nearest to the axis within the cone's slab. The slab is widened by
/// what float can't tell, or a ray along its edge would have no point but far away; and no point is
/// much farther than the cone, or its height there would be noise.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V nearest_to_axis(D d, const Record& record, const ConeLanes<V>& cone, Vec3f origin,
                             V square) {
  const float height = record.number[6], far = 2 * cone_reach(record, origin);
  const float doubt = 0x1p-21f * far;
  const V inverse = safe_reciprocal(d, cone.axial_direction);
  const V a = hn::Mul(hn::Set(d, -doubt - cone.axial_origin), inverse);
  const V b = hn::Mul(hn::Set(d, height + doubt - cone.axial_origin), inverse);
  const V nearest =
      hn::Mul(hn::Neg(dot(cone.radial_direction, cone.radial_origin)), safe_reciprocal(d, square));
  const V in_slab = hn::Min(hn::Max(nearest, hn::Min(a, b)), hn::Max(a, b));
  return hn::Max(hn::Min(in_slab, hn::Set(d, far)), hn::Set(d, -far));
}

/// Quadratic about that point, so that the numbers it squares are of the cone's size and not of the
/// distance.
template <class D, class Report, class V = hn::Vec<D>>
HWY_INLINE void intersect_cone_side(D d, const Record& record, const ConeLanes<V>& cone,
                                    Vec3f origin, Report&& report) {
  const V zero = hn::Zero(d);
  const float along_axis =
      rim_overlap(record, origin) / std::sqrt(1 + record.number[9] * record.number[9]);
  const V lowest = hn::Set(d, -along_axis), highest = hn::Set(d, record.number[6] + along_axis);
  const V square = dot(cone.radial_direction, cone.radial_direction);
  const V shift = nearest_to_axis(d, record, cone, origin, square);
  const Vec3Lanes<V> there = along(cone.origin, shift, cone.direction);
  const V axial = dot(there, cone.axis);
  const Vec3Lanes<V> radial = along(there, hn::Neg(axial), cone.axis);
  const V slope = hn::Set(d, record.number[9]);
  const V radius = hn::Add(hn::Set(d, record.number[7]), hn::Mul(slope, axial));
  const V growth = hn::Mul(slope, cone.axial_direction);
  const V A = hn::Sub(square, hn::Mul(growth, growth));
  const V B = hn::Sub(dot(radial, cone.radial_direction), hn::Mul(growth, radius));
  const V C = hn::Sub(dot(radial, radial), hn::Mul(radius, radius));
  // B² - A C without the terms that cancel, which near an apex are all: |radius d - growth r|² -
  // |d x r|² for the radial parts d and r.
  const Vec3Lanes<V> turn = cross(cone.radial_direction, radial);
  const Vec3Lanes<V> grown{
      hn::Sub(hn::Mul(radius, cone.radial_direction.x), hn::Mul(growth, radial.x)),
      hn::Sub(hn::Mul(radius, cone.radial_direction.y), hn::Mul(growth, radial.y)),
      hn::Sub(hn::Mul(radius, cone.radial_direction.z), hn::Mul(growth, radial.z))};
  const V discriminant = hn::Sub(dot(grown, grown), dot(turn, turn));
  const auto real = hn::Ge(discriminant, zero);
  if (hn::AllFalse(d, real)) return;
  const V root = hn::CopySign(hn::Sqrt(hn::Max(discriminant, zero)), B);
  const V q = hn::Neg(hn::Add(B, root));
  // The other root is C / q or (root - B) / A: the one that suffers less from the errors of C or B.
  const V size = hn::Add(dot(radial, radial), hn::Mul(radius, radius));
  const auto is_tangent = hn::Gt(hn::Mul(size, hn::Mul(A, A)), hn::Mul(square, hn::Mul(q, q)));
  const V other = hn::IfThenElse(is_tangent, hn::Div(hn::Sub(root, B), A), hn::Div(C, q));
  for (const V& step : {other, hn::Div(q, A)}) {
    const V at = hn::Add(axial, hn::Mul(step, cone.axial_direction));
    const auto hit = hn::And(real, hn::And(hn::Ge(at, lowest), hn::Le(at, highest)));
    if (!hn::AllFalse(d, hit)) report(hn::Mul(hn::Add(shift, step), cone.inverse_length), hit);
  }
}

/// One of the two circles; `height` above the base.
template <class D, class Report, class V = hn::Vec<D>>
HWY_INLINE void intersect_cap(D d, const ConeLanes<V>& cone, float height, float radius,
                              Report&& report) {
  const V way =
      hn::Mul(hn::Set(d, height - cone.axial_origin), safe_reciprocal(d, cone.axial_direction));
  const Vec3Lanes<V> there = along(cone.radial_origin, way, cone.radial_direction);
  const auto hit = hn::Le(dot(there, there), hn::Set(d, radius * radius));
  if (!hn::AllFalse(d, hit)) report(hn::Mul(way, cone.inverse_length), hit);
}

template <class D, class Report>
HWY_INLINE void intersect_cone(D d, const Record& record, Vec3f origin, const RayLanes<D>& ray,
                               Report&& report) {
  const auto cone = make_cone_lanes(d, record, origin, ray);
  intersect_cone_side(d, record, cone, origin, report);
  if (!record.is_capped) return;
  const float overlap = rim_overlap(record, origin);
  intersect_cap(d, cone, 0, record.number[7] + overlap, report);
  intersect_cap(d, cone, record.number[6], record.number[8] + overlap, report);
}

}  // namespace penumbra::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include once for each instruction set
