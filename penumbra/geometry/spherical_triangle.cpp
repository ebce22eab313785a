// SPDX-License-Identifier: MIT
#include "penumbra/geometry/spherical_triangle.h"

#include <algorithm>
#include <cmath>

namespace penumbra {

SphericalTriangle spherical_triangle(Vec3d a, Vec3d b, Vec3d c, double solid_angle) {
  SphericalTriangle t;
  t.solid_angle = solid_angle;
  t.a = normalize(a), t.b = normalize(b);
  // Edges instead of corners: their cross products lose no digits where the triangle is small.
  const Vec3d across_ab = cross(t.a, b - a), across_ac = cross(t.a, c - a);
  t.toward_c = normalize(cross(across_ac, t.a));
  t.angle = std::atan2(length(cross(across_ab, across_ac)), dot(across_ab, across_ac));
  t.sine = std::sin(t.angle), t.cosine = std::cos(t.angle);
  t.cos_ab = dot(t.a, t.b);
  return t;
}

Vec3d direction_in(const SphericalTriangle& tri, double u, double v) {
  const double phi = u * tri.solid_angle - tri.angle;
  const double s = std::sin(phi), t = std::cos(phi);
  const double p = t - tri.cosine, q = s + tri.sine * tri.cos_ab;
  const double below = (q * s + p * t) * tri.sine;
  const double cos_ac =
      below == 0 ? 1 : std::clamp(((q * t - p * s) * tri.cosine - q) / below, -1.0, 1.0);
  const Vec3d c = tri.a * cos_ac + tri.toward_c * std::sqrt((1 - cos_ac) * (1 + cos_ac));
  const Vec3d across = c - tri.b * dot(c, tri.b);
  const double h = v * 0.5 * length_squared(c - tri.b);  // 1 - cos of the arc from b
  return tri.b * (1 - h) + normalize(across) * std::sqrt(std::max(0.0, h * (2 - h)));
}

}  // namespace penumbra
