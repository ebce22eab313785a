// SPDX-License-Identifier: MIT
// Rays against a triangle: a part of the intersector, see intersect-inl.h.
//
// Highway "inl" header: included once for each instruction set.

#if defined(PENUMBRA_KERNEL_INTERSECT_TRIANGLE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PENUMBRA_KERNEL_INTERSECT_TRIANGLE_INL_H_
#undef PENUMBRA_KERNEL_INTERSECT_TRIANGLE_INL_H_
#else
#define PENUMBRA_KERNEL_INTERSECT_TRIANGLE_INL_H_
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstdint>

#include "penumbra/kernel/lanes-inl.h"
#include "penumbra/kernel/record.h"

HWY_BEFORE_NAMESPACE();
namespace penumbra::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Sign of an edge function where float gave 0: products of floats are exact in double.
inline float exact_edge(float ax, float ay, float bx, float by) {
  const double difference = double(ax) * double(by) - double(ay) * double(bx);
  return static_cast<float>(difference > 0 ? 1 : difference < 0 ? -1 : 0) * FLT_MIN;
}

/// The three edge functions where at least one lane is 0 in one of them.
template <class D, class V = hn::Vec<D>>
HWY_NOINLINE void refine_edges(D d, const V* px, const V* py, V* edge) {
  constexpr std::size_t most = 16;
  alignas(64) float x[3][most], y[3][most], e[3][most];
  for (int corner = 0; corner < 3; ++corner) {
    hn::Store(px[corner], d, x[corner]);
    hn::Store(py[corner], d, y[corner]);
    hn::Store(edge[corner], d, e[corner]);
  }
  for (int k = 0; k < 3; ++k) {
    const int from = (k + 2) % 3, to = (k + 1) % 3;
    for (std::size_t lane = 0; lane < hn::Lanes(d); ++lane)
      if (e[k][lane] == 0)
        e[k][lane] = exact_edge(x[from][lane], y[from][lane], x[to][lane], y[to][lane]);
    edge[k] = hn::Load(d, e[k]);
  }
}

/// Where a ray that passes the triangle crosses its plane, by double arithmetic. Where the ray runs
/// so flat that this lies outside the triangle by more than `doubt`, the nearest t that doesn't.
inline double exact_crossing(Vec3d a, Vec3d b, Vec3d c, Vec3d origin, Vec3d direction,
                             double doubt) {
  const Vec3d normal = cross(b - a, c - a), corner[3] = {a, b, c};
  const double t = dot(a - origin, normal) / dot(direction, normal);
  double first = -DBL_MAX, last = DBL_MAX;
  for (int k = 0; k < 3; ++k) {
    const Vec3d inward = cross(normal, corner[(k + 1) % 3] - corner[k]);
    const double inside = dot(origin - corner[k], inward) + doubt * length(inward);
    const double slope = dot(direction, inward);
    if (slope > 0) first = std::max(first, -inside / slope);
    if (slope < 0) last = std::min(last, -inside / slope);
  }
  // Runs in the plane, or away from it by rounding alone: a hit where the outline is ahead. The
  // sheared test gave the crossing to this triangle and to none of its neighbours.
  if (!(t > 0) || !std::isfinite(t)) return first > 0 ? std::min(first, last) : t;
  return std::clamp(t, std::min(first, last), std::max(first, last));
}

/// The same for the lanes of `wanted`.
template <class D, class V = hn::Vec<D>>
HWY_NOINLINE V exact_crossings(D d, const Record& record, Vec3f origin, const RayLanes<D>& ray,
                               hn::Mask<D> wanted, float doubt) {
  alignas(64) float x[16], y[16], z[16], t[16] = {};
  hn::Store(ray.x, d, x), hn::Store(ray.y, d, y), hn::Store(ray.z, d, z);
  const Vec3d a(record.vector(0)), b(record.vector(3)), c(record.vector(6));
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(d, wanted, bits);
  for (std::size_t lane = 0; lane < hn::Lanes(d); ++lane)
    if (bits[lane / 8] >> lane % 8 & 1)
      t[lane] = static_cast<float>(
          exact_crossing(a, b, c, Vec3d(origin), {x[lane], y[lane], z[lane]}, doubt));
  return hn::Load(d, t);
}

/// Watertight (Woop, Benthin, Wald 2013): corners are sheared so that the ray runs along one axis;
/// then the signs of the edge functions are exact in the sheared coordinates, so that triangles
/// which share an edge or a corner let no ray pass between them. Two-sided. For the lanes whose
/// largest axis is `kz`.
template <class D, class Report, class V = hn::Vec<D>>
HWY_INLINE void intersect_triangle_along(D d, const Record& record, Vec3f origin,
                                         const RayLanes<D>& ray, int kz, hn::Mask<D> wanted,
                                         Report&& report) {
  const int kx = kz == 2 ? 0 : kz + 1, ky = kz == 0 ? 2 : kz - 1;
  V px[3], py[3], pz[3];
  for (int corner = 0; corner < 3; ++corner) {
    const V z = hn::Set(d, record.number[3 * corner + kz] - origin[kz]);
    px[corner] =
        hn::Sub(hn::Set(d, record.number[3 * corner + kx] - origin[kx]), hn::Mul(ray.shear_x, z));
    py[corner] =
        hn::Sub(hn::Set(d, record.number[3 * corner + ky] - origin[ky]), hn::Mul(ray.shear_y, z));
    pz[corner] = z;
  }
  V edge[3];
  for (int k = 0; k < 3; ++k) {
    const int from = (k + 2) % 3, to = (k + 1) % 3;
    edge[k] = hn::Sub(hn::Mul(px[from], py[to]), hn::Mul(py[from], px[to]));
  }
  const V zero = hn::Zero(d);
  const auto any_zero =
      hn::Or(hn::Eq(edge[0], zero), hn::Or(hn::Eq(edge[1], zero), hn::Eq(edge[2], zero)));
  if (HWY_UNLIKELY(!hn::AllFalse(d, hn::And(wanted, any_zero)))) refine_edges(d, px, py, edge);
  const V least = hn::Min(edge[0], hn::Min(edge[1], edge[2]));
  const V most = hn::Max(edge[0], hn::Max(edge[1], edge[2]));
  auto hit = hn::And(wanted, hn::Or(hn::Ge(least, zero), hn::Le(most, zero)));
  if (hn::AllFalse(d, hit)) return;
  const V sum = hn::Add(hn::Add(edge[0], edge[1]), edge[2]);
  hit = hn::And(hit, hn::Ne(sum, zero));
  const V depth =
      hn::Add(hn::Add(hn::Mul(edge[0], pz[0]), hn::Mul(edge[1], pz[1])), hn::Mul(edge[2], pz[2]));
  V t = hn::Div(hn::Mul(ray.scale, depth), sum);
  V width = zero;
  float reach = 0;
  for (int corner = 0; corner < 3; ++corner) {
    width = hn::Max(width, hn::Max(hn::Abs(px[corner]), hn::Abs(py[corner])));
    reach = std::max(reach, max_abs(record.vector(3 * corner) - origin));
  }
  // Float loses the side of the plane that the origin lies on when that is near; and where along
  // the ray the triangle is when that sees a sliver. FLT_MIN: products may have underflown.
  const V unsure = hn::Set(d, 0x1p-21f * reach * reach), tiny = hn::Set(d, FLT_MIN / 0x1p-21f);
  const auto sure =
      hn::And(hn::Gt(hn::Abs(depth), hn::Max(hn::Mul(width, unsure), tiny)),
              hn::Gt(hn::Abs(sum), hn::Mul(hn::Set(d, 0.125f), hn::Mul(width, width))));
  const auto doubtful = hn::And(hit, hn::Not(sure));
  if (HWY_UNLIKELY(!hn::AllFalse(d, doubtful)))
    t = hn::IfThenElse(doubtful,
                       exact_crossings(d, record, origin, ray, doubtful, 0x1p-22f * reach), t);
  report(t, hit);
}

template <class D, class Report, class V = hn::Vec<D>>
HWY_INLINE void intersect_triangle(D d, const Record& record, Vec3f origin, const RayLanes<D>& ray,
                                   Report&& report) {
  for (int kz = 0; kz < 3; ++kz) {
    const auto lanes = hn::Eq(ray.axis, hn::Set(d, static_cast<float>(kz)));
    if (!hn::AllFalse(d, lanes))
      intersect_triangle_along(d, record, origin, ray, kz, lanes, report);
  }
}

}  // namespace penumbra::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include once for each instruction set
