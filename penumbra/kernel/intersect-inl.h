// SPDX-License-Identifier: MIT
// THE intersector: the one definition of what "this ray meets this primitive" means. It is written
// over lanes of rays that share their origin, and compiled for one lane (brute force) and for every
// instruction set; it uses only operations that IEEE 754 rounds exactly, so all of them give the
// same bits.
//
// A ray o + t d meets a primitive at t if
//   (1) the primitive's formula below gives t, with t_min < t < t_max, and
//   (2) t lies in the slabs of the primitive's own box, padded by 2^-19 of the farthest box
//   coordinate from o.
// (2) costs nothing where (1) fails, rejects no true hit (see below), and makes every hierarchy of
// nested boxes exact by construction: subtraction, multiplication by a constant, and min/max are
// monotone under rounding, so a node that holds the box can never be missed.
//
// With ulp = 2^-24 of that distance: hits lie within 16 ulp of a sphere or ring, 32 of a cone, 64
// of a triangle (near the sharp corner of one seen edge-on; else 16). A ray that passes more than 8
// ulp deep through a shape, measured where it crosses and not along it, is a hit; so is one that
// passes so deep through the solid of a capped cone no flatter than 1 : 4, its rims included.
//
// Highway "inl" header: included once for each instruction set.

#if defined(PENUMBRA_KERNEL_INTERSECT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PENUMBRA_KERNEL_INTERSECT_INL_H_
#undef PENUMBRA_KERNEL_INTERSECT_INL_H_
#else
#define PENUMBRA_KERNEL_INTERSECT_INL_H_
#endif

#include <hwy/highway.h>

#include "penumbra/kernel/intersect_cone-inl.h"
#include "penumbra/kernel/intersect_triangle-inl.h"
#include "penumbra/kernel/lanes-inl.h"
#include "penumbra/kernel/record.h"

HWY_BEFORE_NAMESPACE();
namespace penumbra::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Share of the distance by which boxes are padded.
inline constexpr float box_pad = 0x1p-19f;

/// Part (2) of the definition, for the lanes of `hit`.
template <class D, class V = hn::Vec<D>>
HWY_NOINLINE hn::Mask<D> confirm(D d, const Record& record, Vec3f origin, const RayLanes<D>& ray,
                                 V t, hn::Mask<D> hit) {
  const Box box = bounds(record);
  const Vec3f lo = box.lo - origin, hi = box.hi - origin;
  const float pad = box_pad * std::max(max_abs(lo), max_abs(hi));
  const V direction[3] = {ray.x, ray.y, ray.z};
  for (int axis = 0; axis < 3; ++axis) {
    const V inverse = safe_reciprocal(d, direction[axis]);
    const V a = hn::Mul(hn::Set(d, lo[axis] - pad), inverse);
    const V b = hn::Mul(hn::Set(d, hi[axis] + pad), inverse);
    hit = hn::And(hit, hn::And(hn::Le(hn::Min(a, b), t), hn::Ge(hn::Max(a, b), t)));
  }
  return hit;
}

// Each intersector calls report(t, mask) for every crossing of the ray's line with the surface. NaN
// never passes the comparisons that make a mask.

/// Perpendicular form of the quadratic (Haines et al., Ray Tracing Gems, chapter 7): the error of
/// the crossing is a few ulp of the distance, not of its square.
template <class D, class Report, class V = hn::Vec<D>>
HWY_INLINE void intersect_sphere(D d, const Record& record, Vec3f origin, const RayLanes<D>& ray,
                                 Report&& report) {
  const Vec3f to = record.vector(0) - origin;
  const V cx = hn::Set(d, to.x), cy = hn::Set(d, to.y), cz = hn::Set(d, to.z);
  const V along = hn::Add(hn::Add(hn::Mul(cx, ray.x), hn::Mul(cy, ray.y)), hn::Mul(cz, ray.z));
  const V middle = hn::Mul(along, ray.inverse_square);
  const V px = hn::Sub(cx, hn::Mul(middle, ray.x));
  const V py = hn::Sub(cy, hn::Mul(middle, ray.y));
  const V pz = hn::Sub(cz, hn::Mul(middle, ray.z));
  const V miss = hn::Add(hn::Add(hn::Mul(px, px), hn::Mul(py, py)), hn::Mul(pz, pz));
  const V rest = hn::Sub(hn::Set(d, record.number[3] * record.number[3]), miss);
  const auto hit = hn::Ge(rest, hn::Zero(d));
  if (hn::AllFalse(d, hit)) return;
  const V half = hn::Sqrt(hn::Mul(rest, ray.inverse_square));
  report(hn::Sub(middle, half), hit);
  report(hn::Add(middle, half), hit);
}

template <class D, class Report, class V = hn::Vec<D>>
HWY_INLINE void intersect_ring(D d, const Record& record, Vec3f origin, const RayLanes<D>& ray,
                               Report&& report) {
  const Vec3f to = record.vector(0) - origin, n = record.vector(3);
  const V slope = hn::Add(hn::Add(hn::Mul(hn::Set(d, n.x), ray.x), hn::Mul(hn::Set(d, n.y), ray.y)),
                          hn::Mul(hn::Set(d, n.z), ray.z));
  const V t = hn::Div(hn::Set(d, dot(to, n)), slope);
  const V px = hn::Sub(hn::Mul(t, ray.x), hn::Set(d, to.x));
  const V py = hn::Sub(hn::Mul(t, ray.y), hn::Set(d, to.y));
  const V pz = hn::Sub(hn::Mul(t, ray.z), hn::Set(d, to.z));
  const V square = hn::Add(hn::Add(hn::Mul(px, px), hn::Mul(py, py)), hn::Mul(pz, pz));
  const float outer = record.number[6], inner = record.number[7];
  const auto hit =
      hn::And(hn::Le(square, hn::Set(d, outer * outer)), hn::Ge(square, hn::Set(d, inner * inner)));
  if (!hn::AllFalse(d, hit)) report(t, hit);
}

template <class D, class Report>
HWY_INLINE void intersect(D d, const Record& record, Vec3f origin, const RayLanes<D>& ray,
                          Report&& report) {
  switch (record.kind) {
    case ShapeKind::triangle: return intersect_triangle(d, record, origin, ray, report);
    case ShapeKind::sphere: return intersect_sphere(d, record, origin, ray, report);
    case ShapeKind::cone: return intersect_cone(d, record, origin, ray, report);
    case ShapeKind::ring: return intersect_ring(d, record, origin, ray, report);
  }
}

/// Lanes of `wanted` whose open segment (t_min, t_max) meets the primitive.
template <class D, class V = hn::Vec<D>>
HWY_INLINE hn::Mask<D> meets(D d, const Record& record, Vec3f origin, const RayLanes<D>& ray,
                             V t_max, hn::Mask<D> wanted) {
  auto met = hn::FirstN(d, 0);
  intersect(d, record, origin, ray, [&](V t, hn::Mask<D> hit) {
    hit = hn::And(hn::And(hn::AndNot(met, hit), wanted),
                  hn::And(hn::Gt(t, hn::Zero(d)), hn::Lt(t, t_max)));
    if (!hn::AllFalse(d, hit)) met = hn::Or(met, confirm(d, record, origin, ray, t, hit));
  });
  return met;
}

}  // namespace penumbra::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include once for each instruction set
