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
// (2) costs nothing where (1) fails, rejects no true hit (the formulas' errors are below 2^-20 of
// that distance), and makes every hierarchy of nested boxes exact by construction: subtraction,
// multiplication by a constant, and min/max are monotone under rounding, so a node that holds the
// box can never be missed.
//
// Highway "inl" header: included once for each instruction set.

#if defined(PENUMBRA_KERNEL_INTERSECT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PENUMBRA_KERNEL_INTERSECT_INL_H_
#undef PENUMBRA_KERNEL_INTERSECT_INL_H_
#else
#define PENUMBRA_KERNEL_INTERSECT_INL_H_
#endif

#include <hwy/highway.h>

#include <cfloat>
#include <cmath>
#include <cstdint>

#include "penumbra/kernel/record.h"

HWY_BEFORE_NAMESPACE();
namespace penumbra::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Share of the distance by which boxes are padded.
inline constexpr float box_pad = 0x1p-19f;

/// Reciprocal without infinities, monotone where the sign is constant; zeros of either sign count
/// as positive.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V safe_reciprocal(D d, V x) {
  const V inverse = hn::Div(hn::Set(d, 1.0f), hn::Add(x, hn::Zero(d)));
  return hn::Max(hn::Min(inverse, hn::Set(d, FLT_MAX)), hn::Set(d, -FLT_MAX));
}

/// Directions of rays in lanes, and what is derived from each direction alone.
template <class D, class V = hn::Vec<D>>
struct RayLanes {
  V x, y, z;
  V inverse_square;           // 1 / |d|²
  V shear_x, shear_y, scale;  // Woop, Benthin, Wald 2013: d[kx] / d[kz], d[ky] / d[kz], 1 / d[kz]
  V axis;                     // kz, the axis of the largest component, as a number
};

template <class D, class V = hn::Vec<D>>
HWY_INLINE RayLanes<D> make_ray_lanes(D d, V x, V y, V z) {
  RayLanes<D> ray;
  ray.x = x, ray.y = y, ray.z = z;
  const V square = hn::Add(hn::Add(hn::Mul(x, x), hn::Mul(y, y)), hn::Mul(z, z));
  ray.inverse_square = hn::Div(hn::Set(d, 1.0f), square);
  const V ax = hn::Abs(x), ay = hn::Abs(y), az = hn::Abs(z);
  const auto is_x = hn::And(hn::Ge(ax, ay), hn::Ge(ax, az));
  const auto is_y = hn::AndNot(is_x, hn::Ge(ay, az));
  const V along = hn::IfThenElse(is_x, x, hn::IfThenElse(is_y, y, z));
  const V first = hn::IfThenElse(is_x, y, hn::IfThenElse(is_y, z, x));
  const V second = hn::IfThenElse(is_x, z, hn::IfThenElse(is_y, x, y));
  ray.scale = hn::Div(hn::Set(d, 1.0f), along);
  ray.shear_x = hn::Div(first, along);
  ray.shear_y = hn::Div(second, along);
  ray.axis =
      hn::IfThenElse(is_x, hn::Zero(d), hn::IfThenElse(is_y, hn::Set(d, 1.0f), hn::Set(d, 2.0f)));
  return ray;
}

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

/// Quadratic about the point of the ray that is nearest to the axis within the cone's slab, so that
/// the numbers it squares are of the cone's size and not of the distance.
template <class D, class Report, class V = hn::Vec<D>>
HWY_INLINE void intersect_cone(D d, const Record& record, Vec3f origin, const RayLanes<D>& ray,
                               Report&& report) {
  const V zero = hn::Zero(d);
  const Vec3f m = origin - record.vector(0), a = record.vector(3);
  const float height = record.number[6], base = record.number[7], apex = record.number[8];
  const float slope = record.number[9];
  const float m_axial = dot(m, a);
  const Vec3f m_radial = m - a * m_axial;
  const V ax = hn::Set(d, a.x), ay = hn::Set(d, a.y), az = hn::Set(d, a.z);
  const V d_axial = hn::Add(hn::Add(hn::Mul(ray.x, ax), hn::Mul(ray.y, ay)), hn::Mul(ray.z, az));
  const V dx = hn::Sub(ray.x, hn::Mul(d_axial, ax));
  const V dy = hn::Sub(ray.y, hn::Mul(d_axial, ay));
  const V dz = hn::Sub(ray.z, hn::Mul(d_axial, az));
  const V d_square = hn::Add(hn::Add(hn::Mul(dx, dx), hn::Mul(dy, dy)), hn::Mul(dz, dz));

  const V inverse = safe_reciprocal(d, d_axial);
  const V t_base = hn::Mul(hn::Set(d, -m_axial), inverse);
  const V t_apex = hn::Mul(hn::Set(d, height - m_axial), inverse);
  const V crossing =
      hn::Add(hn::Add(hn::Mul(dx, hn::Set(d, m_radial.x)), hn::Mul(dy, hn::Set(d, m_radial.y))),
              hn::Mul(dz, hn::Set(d, m_radial.z)));
  const V nearest = hn::Mul(hn::Neg(crossing), safe_reciprocal(d, d_square));
  const V shift = hn::Min(hn::Max(nearest, hn::Min(t_base, t_apex)), hn::Max(t_base, t_apex));

  const V wx = hn::Add(hn::Set(d, m.x), hn::Mul(shift, ray.x));
  const V wy = hn::Add(hn::Set(d, m.y), hn::Mul(shift, ray.y));
  const V wz = hn::Add(hn::Set(d, m.z), hn::Mul(shift, ray.z));
  const V w_axial = hn::Add(hn::Add(hn::Mul(wx, ax), hn::Mul(wy, ay)), hn::Mul(wz, az));
  const V rx = hn::Sub(wx, hn::Mul(w_axial, ax));
  const V ry = hn::Sub(wy, hn::Mul(w_axial, ay));
  const V rz = hn::Sub(wz, hn::Mul(w_axial, az));
  const V k = hn::Set(d, slope);
  const V radius = hn::Add(hn::Set(d, base), hn::Mul(k, w_axial));
  const V growth = hn::Mul(k, d_axial);
  const V A = hn::Sub(d_square, hn::Mul(growth, growth));
  const V B = hn::Sub(hn::Add(hn::Add(hn::Mul(rx, dx), hn::Mul(ry, dy)), hn::Mul(rz, dz)),
                      hn::Mul(growth, radius));
  const V C = hn::Sub(hn::Add(hn::Add(hn::Mul(rx, rx), hn::Mul(ry, ry)), hn::Mul(rz, rz)),
                      hn::Mul(radius, radius));
  const V discriminant = hn::Sub(hn::Mul(B, B), hn::Mul(A, C));
  const auto real = hn::Ge(discriminant, zero);
  const auto side = [&](V step, hn::Mask<D> valid) {
    const V axial = hn::Add(w_axial, hn::Mul(step, d_axial));
    const auto hit =
        hn::And(valid, hn::And(hn::Ge(axial, zero), hn::Le(axial, hn::Set(d, height))));
    if (!hn::AllFalse(d, hit)) report(hn::Add(shift, step), hit);
  };
  if (!hn::AllFalse(d, real)) {
    const V root = hn::Sqrt(hn::Max(discriminant, zero));
    const V q = hn::Neg(hn::Add(B, hn::CopySign(root, B)));
    side(hn::Div(C, q), real);
    side(hn::Div(q, A), real);
  }
  if (!record.is_capped) return;
  const auto cap = [&](V t, float r) {
    const V px = hn::Add(hn::Set(d, m_radial.x), hn::Mul(t, dx));
    const V py = hn::Add(hn::Set(d, m_radial.y), hn::Mul(t, dy));
    const V pz = hn::Add(hn::Set(d, m_radial.z), hn::Mul(t, dz));
    const V square = hn::Add(hn::Add(hn::Mul(px, px), hn::Mul(py, py)), hn::Mul(pz, pz));
    const auto hit = hn::Le(square, hn::Set(d, r * r));
    if (!hn::AllFalse(d, hit)) report(t, hit);
  };
  cap(t_base, base);
  cap(t_apex, apex);
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
    hit = hn::And(hn::And(hit, wanted), hn::And(hn::Gt(t, hn::Zero(d)), hn::Lt(t, t_max)));
    if (!hn::AllFalse(d, hit)) met = hn::Or(met, confirm(d, record, origin, ray, t, hit));
  });
  return met;
}

}  // namespace penumbra::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include once for each instruction set
