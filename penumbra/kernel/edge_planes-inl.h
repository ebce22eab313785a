// SPDX-License-Identifier: MIT
// Which rays of an origin pass by a triangle, by the planes through the origin and its edges: a
// third of the work of the intersector, and no ray is lost that it would call a hit.
//
// With a, b, c the corners as seen from the origin, rounded once as in the intersector, the edge
// function of a and b there is the sheared form of (a x b) . d / d[kz]; the three share the sign of
// d[kz]. It is computed with an error of at most 49 u R^2, u = 2^-24 and R the largest coordinate
// of a, b, c: 4 u R in each sheared coordinate (of size 2 R), which makes 32 u R^2 in the
// difference of two products, and 16 u R^2 for their rounding. Here the float cross product is
// wrong by 4 u R^2 a component and the dot product by 16 u R^2 m more, m = |d[kz]|: in all 28 u R^2
// m. So where
// |(a x b) . d| comes out above 77 u R^2 m both have the same sign, and two edge functions of
// opposite signs are no hit. The test takes 128 u. Limits for R, and for the doubt from below and
// above, keep the errors of underflow far below it and make overflow impossible; fused
// multiplications only make errors smaller. NaN passes by nothing.
//
// Highway "inl" header: included once for each instruction set.

#if defined(PENUMBRA_KERNEL_EDGE_PLANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PENUMBRA_KERNEL_EDGE_PLANES_INL_H_
#undef PENUMBRA_KERNEL_EDGE_PLANES_INL_H_
#else
#define PENUMBRA_KERNEL_EDGE_PLANES_INL_H_
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <limits>

#include "penumbra/kernel/lanes-inl.h"
#include "penumbra/kernel/record.h"

HWY_BEFORE_NAMESPACE();
namespace penumbra::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

struct EdgePlanes {
  Vec3f normal[3];
  float doubt;  // times m
};

HWY_INLINE EdgePlanes edge_planes(const Record& triangle, Vec3f origin) {
  const Vec3f a = triangle.vector(0) - origin, b = triangle.vector(3) - origin,
              c = triangle.vector(6) - origin;
  const float reach = std::max({max_abs(a), max_abs(b), max_abs(c)});
  const bool is_in_range = reach > 0x1p-60f && reach < 0x1p60f;
  return {{cross(b, c), cross(c, a), cross(a, b)},
          is_in_range ? 0x1p-17f * reach * reach : std::numeric_limits<float>::infinity()};
}

template <class D, class V = hn::Vec<D>>
HWY_INLINE hn::Mask<D> passes_by(D d, const EdgePlanes& planes, V x, V y, V z) {
  const V m = hn::Max(hn::Abs(x), hn::Max(hn::Abs(y), hn::Abs(z)));
  const V doubt = hn::Max(hn::Mul(hn::Set(d, planes.doubt), m), hn::Set(d, 0x1p-120f));
  V side[3];
  for (int k = 0; k < 3; ++k) {
    const Vec3f n = planes.normal[k];
    side[k] =
        hn::MulAdd(hn::Set(d, n.z), z, hn::MulAdd(hn::Set(d, n.y), y, hn::Mul(hn::Set(d, n.x), x)));
  }
  const V least = hn::Min(side[0], hn::Min(side[1], side[2]));
  const V most = hn::Max(side[0], hn::Max(side[1], side[2]));
  const auto differ = hn::And(hn::Gt(most, doubt), hn::Lt(least, hn::Neg(doubt)));
  return hn::And(differ, hn::Lt(doubt, hn::Set(d, 0x1p100f)));
}

}  // namespace penumbra::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include once for each instruction set
