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

#include <cfloat>

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

/// Where each ray crosses the triangle's plane, by double arithmetic.
template <class D, class V = hn::Vec<D>>
HWY_NOINLINE V plane_crossing(D d, const Record& record, Vec3f origin, const RayLanes<D>& ray) {
  alignas(64) float x[16], y[16], z[16], t[16];
  hn::Store(ray.x, d, x), hn::Store(ray.y, d, y), hn::Store(ray.z, d, z);
  const Vec3d a(record.vector(0)), b(record.vector(3)), c(record.vector(6));
  const Vec3d normal = cross(b - a, c - a);
  const double height = dot(a - Vec3d(origin), normal);
  for (std::size_t lane = 0; lane < hn::Lanes(d); ++lane)
    t[lane] =
        static_cast<float>(height / (normal.x * x[lane] + normal.y * y[lane] + normal.z * z[lane]));
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
  // Slivers lose the digits of depth, and with them the side of the plane that the origin lies on.
  V width = zero;
  float reach = 0;
  for (int corner = 0; corner < 3; ++corner) {
    width = hn::Max(width, hn::Max(hn::Abs(px[corner]), hn::Abs(py[corner])));
    reach = std::max(reach, max_abs(record.vector(3 * corner) - origin));
  }
  const V unsure = hn::Mul(width, hn::Set(d, 0x1p-21f * reach * reach));
  const auto doubtful = hn::And(hit, hn::Not(hn::Gt(hn::Abs(depth), unsure)));
  if (HWY_UNLIKELY(!hn::AllFalse(d, doubtful)))
    t = hn::IfThenElse(doubtful, plane_crossing(d, record, origin, ray), t);
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
