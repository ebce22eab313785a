// SPDX-License-Identifier: MIT
#include "penumbra/kernel/embree_user_geometry.h"

#include <limits>

#include "penumbra/kernel/kernel.h"
#include "penumbra/kernel/traverse.h"

// Highway compiles the rest once for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "penumbra/kernel/embree_user_geometry.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

#include "penumbra/kernel/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace penumbra::HWY_NAMESPACE {

/// Neighbouring rays of a packet.
template <class D, class V = hn::Vec<D>>
struct UserRays {
  Vec3Lanes<V> origin, direction;
  V near, far;
};

template <class D, class V = hn::Vec<D>>
HWY_INLINE UserRays<D> load_rays(D d, RTCRayN* rays, unsigned n, unsigned i) {
  return {{hn::LoadU(d, &RTCRayN_org_x(rays, n, i)), hn::LoadU(d, &RTCRayN_org_y(rays, n, i)),
           hn::LoadU(d, &RTCRayN_org_z(rays, n, i))},
          {hn::LoadU(d, &RTCRayN_dir_x(rays, n, i)), hn::LoadU(d, &RTCRayN_dir_y(rays, n, i)),
           hn::LoadU(d, &RTCRayN_dir_z(rays, n, i))},
          hn::LoadU(d, &RTCRayN_tnear(rays, n, i)),
          hn::LoadU(d, &RTCRayN_tfar(rays, n, i))};
}

template <class D, class V = hn::Vec<D>>
HWY_INLINE hn::Mask<D> is_between(const UserRays<D>& ray, V t) {
  return hn::And(hn::Gt(t, ray.near), hn::Lt(t, ray.far));
}

/// Where the ray's line is within `radius` of the axis at this height of a cone. `origin` is
/// relative to the base.
template <class D, class V = hn::Vec<D>>
HWY_INLINE hn::Mask<D> meets_cap(D d, const UserRays<D>& ray, const Vec3Lanes<V>& origin,
                                 const Vec3Lanes<V>& axis, V axial_origin, V axial_direction,
                                 float height, float radius) {
  const V t = hn::Div(hn::Sub(hn::Set(d, height), axial_origin), axial_direction);
  const Vec3Lanes<V> there = along(along(origin, t, ray.direction), hn::Set(d, -height), axis);
  return hn::And(is_between(ray, t), hn::Le(dot(there, there), hn::Set(d, radius * radius)));
}

/// The quadratic about the ray's point that is nearest to the middle of the axis.
template <class D, class V = hn::Vec<D>>
HWY_INLINE hn::Mask<D> meets_cone(D d, const Record& record, const UserRays<D>& ray) {
  const Vec3Lanes<V> base = all_lanes(d, record.vector(0)), axis = all_lanes(d, record.vector(3));
  const V height = hn::Set(d, record.number[6]), slope = hn::Set(d, record.number[9]);
  const V one_back = hn::Set(d, -1.0f), half_back = hn::Set(d, -0.5f * record.number[6]);
  const Vec3Lanes<V> origin = along(ray.origin, one_back, base);
  const V shift = hn::Neg(hn::Div(dot(along(origin, half_back, axis), ray.direction),
                                  dot(ray.direction, ray.direction)));
  const Vec3Lanes<V> there = along(origin, shift, ray.direction);
  const V axial = dot(there, axis), axial_direction = dot(ray.direction, axis);
  const Vec3Lanes<V> radial = along(there, hn::Neg(axial), axis);
  const Vec3Lanes<V> radial_direction = along(ray.direction, hn::Neg(axial_direction), axis);
  const V radius = hn::Add(hn::Set(d, record.number[7]), hn::Mul(slope, axial));
  const V growth = hn::Mul(slope, axial_direction);
  const V a = hn::Sub(dot(radial_direction, radial_direction), hn::Mul(growth, growth));
  const V b = hn::Sub(dot(radial, radial_direction), hn::Mul(growth, radius));
  const V c = hn::Sub(dot(radial, radial), hn::Mul(radius, radius));
  const V discriminant = hn::Sub(hn::Mul(b, b), hn::Mul(a, c));
  auto met = hn::FirstN(d, 0);
  const auto is_real = hn::Ge(discriminant, hn::Zero(d));
  if (!hn::AllFalse(d, is_real)) {
    const V root = hn::Sqrt(hn::Max(discriminant, hn::Zero(d)));
    const V inverse = hn::Div(hn::Set(d, 1.0f), a);
    for (const V& numerator : {hn::Sub(root, b), hn::Neg(hn::Add(root, b))}) {
      const V step = hn::Mul(numerator, inverse);
      const V at = hn::Add(axial, hn::Mul(step, axial_direction));
      const auto is_on_cone = hn::And(hn::Ge(at, hn::Zero(d)), hn::Le(at, height));
      met = hn::Or(met, hn::And(is_on_cone, is_between(ray, hn::Add(shift, step))));
    }
    met = hn::And(met, is_real);
  }
  if (!record.is_capped) return met;
  const V axial_origin = dot(origin, axis);
  const auto meets = [&](float at, float within) {
    return meets_cap(d, ray, origin, axis, axial_origin, axial_direction, at, within);
  };
  return hn::Or(met, hn::Or(meets(0, record.number[7]), meets(record.number[6], record.number[8])));
}

template <class D, class V = hn::Vec<D>>
HWY_INLINE hn::Mask<D> meets_ring(D d, const Record& record, const UserRays<D>& ray) {
  const Vec3Lanes<V> normal = all_lanes(d, record.vector(3));
  const Vec3Lanes<V> origin = along(ray.origin, hn::Set(d, -1.0f), all_lanes(d, record.vector(0)));
  const V t = hn::Neg(hn::Div(dot(origin, normal), dot(ray.direction, normal)));
  const Vec3Lanes<V> there = along(origin, t, ray.direction);
  const V square = dot(there, there);
  const float outer = record.number[6], inner = record.number[7];
  return hn::And(is_between(ray, t), hn::And(hn::Le(square, hn::Set(d, outer * outer)),
                                             hn::Ge(square, hn::Set(d, inner * inner))));
}

template <class D, class V = hn::Vec<D>>
HWY_INLINE hn::Mask<D> meets_sphere(D d, const Record& record, const UserRays<D>& ray) {
  const Vec3Lanes<V> origin = along(ray.origin, hn::Set(d, -1.0f), all_lanes(d, record.vector(0)));
  const V inverse = hn::Div(hn::Set(d, 1.0f), dot(ray.direction, ray.direction));
  const V middle = hn::Neg(hn::Mul(dot(origin, ray.direction), inverse));
  const Vec3Lanes<V> there = along(origin, middle, ray.direction);
  const V rest = hn::Sub(hn::Set(d, record.number[3] * record.number[3]), dot(there, there));
  const auto is_real = hn::Ge(rest, hn::Zero(d));
  if (hn::AllFalse(d, is_real)) return is_real;
  const V half = hn::Sqrt(hn::Mul(hn::Max(rest, hn::Zero(d)), inverse));
  return hn::And(is_real, hn::Or(is_between(ray, hn::Sub(middle, half)),
                                 is_between(ray, hn::Add(middle, half))));
}

template <class D>
HWY_INLINE hn::Mask<D> meets_user(D d, const Record& record, const UserRays<D>& ray) {
  switch (record.kind) {
    case ShapeKind::sphere: return meets_sphere(d, record, ray);
    case ShapeKind::cone: return meets_cone(d, record, ray);
    case ShapeKind::ring: return meets_ring(d, record, ray);
    case ShapeKind::triangle: break;  // Embree has them
  }
  return hn::FirstN(d, 0);
}

template <class D>
HWY_INLINE void occlude(D d, const Record& record, const RTCOccludedFunctionNArguments& arguments) {
  const hn::RebindToSigned<D> di;
  for (unsigned i = 0; i < arguments.N; i += static_cast<unsigned>(hn::Lanes(d))) {
    const auto valid = hn::RebindMask(d, hn::Ne(hn::LoadU(di, &arguments.valid[i]), hn::Zero(di)));
    if (hn::AllFalse(d, valid)) continue;
    const UserRays<D> ray = load_rays(d, arguments.ray, arguments.N, i);
    const auto met = meets_user(d, record, ray);
    const auto blocked = hn::Set(d, -std::numeric_limits<float>::infinity());
    hn::StoreU(hn::IfThenElse(hn::And(met, valid), blocked, ray.far), d,
               &RTCRayN_tfar(arguments.ray, arguments.N, i));
  }
}

/// Embree's packets have 1, 4, 8 or 16 rays.
void UserOccluded(const RTCOccludedFunctionNArguments* arguments) {
  const auto& records = *static_cast<const std::vector<Record>*>(arguments->geometryUserPtr);
  const Record& record = records[arguments->primID];
  if (arguments->N % 16 == 0)
    occlude(hn::CappedTag<float, 16>(), record, *arguments);
  else if (arguments->N % 8 == 0)
    occlude(hn::CappedTag<float, 8>(), record, *arguments);
  else if (arguments->N % 4 == 0)
    occlude(hn::CappedTag<float, 4>(), record, *arguments);
  else
    occlude(hn::CappedTag<float, 1>(), record, *arguments);
}

}  // namespace penumbra::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace penumbra {

HWY_EXPORT(UserOccluded);

namespace {

const std::vector<Record>& records_of(const void* user) {
  return *static_cast<const std::vector<Record>*>(user);
}

void user_bounds(const RTCBoundsFunctionArguments* arguments) {
  const Box b = bounds(records_of(arguments->geometryUserPtr)[arguments->primID]);
  *arguments->bounds_o = {b.lo.x, b.lo.y, b.lo.z, 0, b.hi.x, b.hi.y, b.hi.z, 0};
}

void user_intersect(const RTCIntersectFunctionNArguments* arguments) {
  const Record& record = records_of(arguments->geometryUserPtr)[arguments->primID];
  const unsigned n = arguments->N;
  RTCRayN* ray = RTCRayHitN_RayN(arguments->rayhit, n);
  RTCHitN* hits = RTCRayHitN_HitN(arguments->rayhit, n);
  for (unsigned i = 0; i < n; ++i) {
    if (!arguments->valid[i]) continue;
    const Ray one{{RTCRayN_org_x(ray, n, i), RTCRayN_org_y(ray, n, i), RTCRayN_org_z(ray, n, i)},
                  {RTCRayN_dir_x(ray, n, i), RTCRayN_dir_y(ray, n, i), RTCRayN_dir_z(ray, n, i)},
                  RTCRayN_tnear(ray, n, i),
                  RTCRayN_tfar(ray, n, i)};
    const NearestRecord found = nearest_brute({&record, 1}, one);
    if (!found.record) continue;
    RTCRayN_tfar(ray, n, i) = found.t;
    RTCHitN_geomID(hits, n, i) = arguments->geomID;
    RTCHitN_primID(hits, n, i) = arguments->primID;
  }
}

void user_occluded(const RTCOccludedFunctionNArguments* arguments) {
  HWY_DYNAMIC_DISPATCH(UserOccluded)(arguments);
}

}  // namespace

void attach_records(RTCDevice device, RTCScene scene, const std::vector<Record>& records) {
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryBuildQuality(geometry, RTC_BUILD_QUALITY_HIGH);
  rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(records.size()));
  rtcSetGeometryUserData(geometry, const_cast<std::vector<Record>*>(&records));
  rtcSetGeometryBoundsFunction(geometry, user_bounds, nullptr);
  rtcSetGeometryIntersectFunction(geometry, user_intersect);
  rtcSetGeometryOccludedFunction(geometry, user_occluded);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
}

}  // namespace penumbra
#endif
