// SPDX-License-Identifier: MIT
// Rays and vectors in SIMD lanes.
//
// Highway "inl" header: included once for each instruction set.

#if defined(PENUMBRA_KERNEL_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PENUMBRA_KERNEL_LANES_INL_H_
#undef PENUMBRA_KERNEL_LANES_INL_H_
#else
#define PENUMBRA_KERNEL_LANES_INL_H_
#endif

#include <hwy/highway.h>

#include <cfloat>
#include <cstddef>
#include <cstdint>

#include "penumbra/geometry/vec.h"

HWY_BEFORE_NAMESPACE();
namespace penumbra::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Sixteen lanes, or as many as there are, and sets of them as bits.
using LaneTag = hn::CappedTag<float, 16>;
using Lane = hn::Vec<LaneTag>;
using LaneMask = hn::Mask<LaneTag>;
constexpr LaneTag lane_tag;
constexpr std::size_t lane_count = hn::MaxLanes(LaneTag());

HWY_INLINE LaneMask mask_of(std::uint32_t bits) {
  const std::uint8_t bytes[8] = {static_cast<std::uint8_t>(bits),
                                 static_cast<std::uint8_t>(bits >> 8)};
  return hn::LoadMaskBits(lane_tag, bytes);
}

HWY_INLINE std::uint32_t bits_of(LaneMask mask) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(lane_tag, mask, bytes);
  return bytes[0] | std::uint32_t(bytes[1]) << 8;
}

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

/// Vectors in lanes.
template <class V>
struct Vec3Lanes {
  V x, y, z;
};

template <class V>
HWY_INLINE V dot(const Vec3Lanes<V>& a, const Vec3Lanes<V>& b) {
  return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}

template <class V>
HWY_INLINE Vec3Lanes<V> cross(const Vec3Lanes<V>& a, const Vec3Lanes<V>& b) {
  return {hn::Sub(hn::Mul(a.y, b.z), hn::Mul(a.z, b.y)),
          hn::Sub(hn::Mul(a.z, b.x), hn::Mul(a.x, b.z)),
          hn::Sub(hn::Mul(a.x, b.y), hn::Mul(a.y, b.x))};
}

/// a + s b
template <class V>
HWY_INLINE Vec3Lanes<V> along(const Vec3Lanes<V>& a, V s, const Vec3Lanes<V>& b) {
  return {hn::Add(a.x, hn::Mul(s, b.x)), hn::Add(a.y, hn::Mul(s, b.y)),
          hn::Add(a.z, hn::Mul(s, b.z))};
}

template <class D, class V = hn::Vec<D>>
HWY_INLINE Vec3Lanes<V> all_lanes(D d, Vec3f v) {
  return {hn::Set(d, v.x), hn::Set(d, v.y), hn::Set(d, v.z)};
}

}  // namespace penumbra::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include once for each instruction set
