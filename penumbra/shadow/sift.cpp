// SPDX-License-Identifier: MIT
#include "penumbra/shadow/sift.h"

#include <algorithm>

// Highway compiles the rest once for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "penumbra/shadow/sift.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace penumbra::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Lanes = hn::CappedTag<float, 16>;
using V = hn::Vec<Lanes>;
using M = hn::Mask<Lanes>;
constexpr Lanes tag;

struct Vec3Lanes {
  V x, y, z;
};

HWY_INLINE Vec3Lanes sub(Vec3Lanes a, Vec3Lanes b) {
  return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}
HWY_INLINE V dot3(Vec3Lanes a, Vec3Lanes b) {
  return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}
HWY_INLINE Vec3Lanes cross3(Vec3Lanes a, Vec3Lanes b) {
  return {hn::Sub(hn::Mul(a.y, b.z), hn::Mul(a.z, b.y)),
          hn::Sub(hn::Mul(a.z, b.x), hn::Mul(a.x, b.z)),
          hn::Sub(hn::Mul(a.x, b.y), hn::Mul(a.y, b.x))};
}
HWY_INLINE Vec3Lanes all(Vec3f v) {
  return {hn::Set(tag, v.x), hn::Set(tag, v.y), hn::Set(tag, v.z)};
}
HWY_INLINE V norm(Vec3Lanes a) { return hn::Sqrt(dot3(a, a)); }

/// The largest m . (l - c), rounding and doubt included.
HWY_INLINE V spread(const SeenLight& light, Vec3Lanes m) {
  const V length = norm(m);
  V most;
  if (light.is_disk) {
    const V along = dot3(m, all(light.normal));
    const V across = hn::Sub(hn::Mul(length, length), hn::Mul(along, along));
    const V rounding = hn::Mul(hn::Set(tag, 0x1p-20f), hn::Mul(length, length));
    most = hn::Mul(hn::Set(tag, light.size),
                   hn::Sqrt(hn::Add(hn::Max(across, hn::Zero(tag)), rounding)));
  } else if (light.corners > 0) {
    most = dot3(m, all(light.corner[0]));
    for (std::uint32_t i = 1; i < light.corners; ++i)
      most = hn::Max(most, dot3(m, all(light.corner[i])));
  } else {
    most = hn::Mul(hn::Set(tag, light.size), length);
  }
  return hn::Add(most, hn::Mul(hn::Set(tag, light.doubt + 0x1p-20f * light.size), length));
}

HWY_INLINE std::uint32_t bits_of(M mask) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(tag, mask, bytes);
  return bytes[0] | std::uint32_t(bytes[1]) << 8;
}

/// design: with v from p to the ball's centre, the shaft's cross-section at t touches it where
/// a t² - 2 b t + c <= 0; a = w² - R², b = v w + ρ R, c = v² - ρ².
HWY_INLINE M keep_balls(Vec3Lanes center, V radius, const SeenLight& light, Vec3f p) {
  const Vec3Lanes v = sub(center, all(p));
  const V square = dot3(v, v);
  const V rho = hn::Add(radius, hn::Mul(hn::Set(tag, 0x1p-19f), hn::Add(hn::Sqrt(square), radius)));
  const float grown = (light.size + light.doubt) * (1 + 0x1p-20f);
  const float slope = light.distance * light.distance - grown * grown;
  const V a = hn::Set(tag, slope - 0x1p-20f * light.distance * light.distance);
  const V along = dot3(v, all(light.way)), reach = hn::Mul(rho, hn::Set(tag, grown));
  const V sizes = hn::Add(hn::Mul(hn::Sqrt(square), hn::Set(tag, light.distance)), reach);
  const V b = hn::Add(hn::Add(along, reach), hn::Mul(hn::Set(tag, 0x1p-20f), sizes));
  const V c = hn::Sub(hn::Sub(square, hn::Mul(rho, rho)),
                      hn::Mul(hn::Set(tag, 0x1p-20f), hn::Add(square, hn::Mul(rho, rho))));
  if (!(slope > 0)) return hn::FirstN(tag, hn::Lanes(tag));
  const V b_squared = hn::Mul(b, b), ac = hn::Mul(a, c);
  const V rest = hn::Add(hn::Sub(b_squared, ac), hn::Mul(hn::Set(tag, 0x1p-20f), b_squared));
  const V end = hn::Sub(hn::Add(a, c), hn::Add(b, b));
  const V end_sizes = hn::Mul(hn::Set(tag, 0x1p-20f), hn::Add(hn::Add(a, square), hn::Add(b, b)));
  const auto beyond = hn::Gt(b, a);  // nearest at the light's end
  const auto misses =
      hn::And(hn::Gt(c, hn::Zero(tag)),
              hn::Or(hn::Lt(b, hn::Zero(tag)),
                     hn::Or(hn::Lt(rest, hn::Zero(tag)), hn::And(beyond, hn::Gt(end, end_sizes)))));
  return hn::Not(misses);
}

std::uint32_t SiftBalls(const float* const ball[4], const SeenLight& light, Vec3f p) {
  std::uint32_t kept = 0;
  for (std::size_t i = 0; i < 16; i += hn::Lanes(tag)) {
    const Vec3Lanes center{hn::LoadU(tag, ball[0] + i), hn::LoadU(tag, ball[1] + i),
                           hn::LoadU(tag, ball[2] + i)};
    kept |= bits_of(keep_balls(center, hn::LoadU(tag, ball[3] + i), light, p)) << i;
  }
  return kept;
}

/// The light lies outside the plane through p and the edge from v along e; `inside` is the sign of
/// the triangle's side. A hit may lie 64 ulp off the triangle.
HWY_INLINE M outside_edge(Vec3Lanes v, Vec3Lanes e, V inside, V reach, const SeenLight& light) {
  const Vec3Lanes m = cross3(v, e);
  const V height = hn::Mul(inside, dot3(m, all(light.way)));
  // Farthest towards the inside: m turned by its sign.
  const Vec3Lanes inward{hn::Mul(inside, m.x), hn::Mul(inside, m.y), hn::Mul(inside, m.z)};
  const V pad =
      hn::Mul(hn::Mul(hn::Set(tag, 0x1p-17f * (light.distance + light.size)), reach), norm(e));
  return hn::Lt(hn::Add(hn::Add(height, spread(light, inward)), pad), hn::Zero(tag));
}

HWY_INLINE M keep_triangles(const Vec3Lanes corner[3], const SeenLight& light, Vec3f p) {
  const V zero = hn::Zero(tag), one = hn::Set(tag, 1.0f);
  const Vec3Lanes v[3] = {sub(corner[0], all(p)), sub(corner[1], all(p)), sub(corner[2], all(p))};
  const Vec3Lanes e[3] = {sub(corner[1], corner[0]), sub(corner[2], corner[1]),
                          sub(corner[0], corner[2])};
  Vec3Lanes n = cross3(e[0], e[1]);
  const V edges = hn::Mul(norm(e[0]), norm(e[1]));
  const V reach = hn::Max(norm(v[0]), hn::Max(norm(v[1]), norm(v[2])));
  V height = hn::Neg(dot3(n, v[0]));  // of p, times |n|
  const V rounding = hn::Mul(hn::Set(tag, 0x1p-20f), edges);
  const auto sure_side = hn::Gt(hn::Abs(height), hn::Mul(rounding, norm(v[0])));
  const V side = hn::IfThenElse(hn::Lt(height, zero), hn::Neg(one), one);
  n = {hn::Mul(n.x, side), hn::Mul(n.y, side), hn::Mul(n.z, side)};
  height = hn::Abs(height);
  // The light's lowest point over p, as the triangle's plane has it.
  const Vec3Lanes down{hn::Neg(n.x), hn::Neg(n.y), hn::Neg(n.z)};
  const V lowest = hn::Sub(dot3(n, all(light.way)), spread(light, down));
  const V far = hn::Mul(rounding, hn::Add(norm(v[0]), hn::Set(tag, light.distance + light.size)));
  const V bound = hn::Mul(hn::Mul(hn::Set(tag, 0x1p-17f), reach), edges);
  auto misses = hn::Or(hn::Gt(lowest, far), hn::Gt(hn::Add(height, lowest), hn::Add(far, bound)));
  const V inside = hn::Neg(side);
  for (int k = 0; k < 3; ++k)
    misses = hn::Or(misses, outside_edge(v[k], e[k], inside, reach, light));
  return hn::Not(hn::And(misses, sure_side));
}

std::uint32_t SiftTriangles(const float* const triangle[9], const SeenLight& light, Vec3f p) {
  std::uint32_t kept = 0;
  for (std::size_t i = 0; i < 16; i += hn::Lanes(tag)) {
    Vec3Lanes corner[3];
    for (int k = 0; k < 3; ++k)
      corner[k] = {hn::LoadU(tag, triangle[3 * k] + i), hn::LoadU(tag, triangle[3 * k + 1] + i),
                   hn::LoadU(tag, triangle[3 * k + 2] + i)};
    kept |= bits_of(keep_triangles(corner, light, p)) << i;
  }
  return kept;
}

}  // namespace penumbra::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace penumbra {

HWY_EXPORT(SiftBalls);
HWY_EXPORT(SiftTriangles);

SeenLight seen_light(const LightHull& light, Vec3f p) {
  SeenLight seen;
  const Vec3d way = light.center(p) - Vec3d(p);
  seen.way = Vec3f(way);
  seen.distance = round_up(length(way));
  seen.size = round_up(light.size());
  seen.doubt = round_up(light.doubt(p));
  seen.is_disk = light.is_disk();
  seen.normal = Vec3f(light.normal());
  if (!seen.is_disk && light.corners().size() <= seen.corner.size()) {
    seen.corners = static_cast<std::uint32_t>(light.corners().size());
    for (std::uint32_t i = 0; i < seen.corners; ++i) seen.corner[i] = Vec3f(light.corners()[i]);
  }
  return seen;
}

std::uint32_t sift_balls(const float* const ball[4], const SeenLight& light, Vec3f p) {
  return HWY_DYNAMIC_DISPATCH(SiftBalls)(ball, light, p);
}

std::uint32_t sift_triangles(const float* const triangle[9], const SeenLight& light, Vec3f p) {
  return HWY_DYNAMIC_DISPATCH(SiftTriangles)(triangle, light, p);
}

}  // namespace penumbra
#endif
