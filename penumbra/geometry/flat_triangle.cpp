// SPDX-License-Identifier: MIT
#include "penumbra/geometry/flat_triangle.h"

#include <algorithm>
#include <limits>

namespace penumbra {
namespace {

NearestPoint nearest_on_edge(Vec3d a, Vec3d b, Vec3d p) {
  const Vec3d along = b - a;
  const double square = length_squared(along);
  const double t = square > 0 ? std::clamp(dot(p - a, along) / square, 0.0, 1.0) : 0;
  const Vec3d point = a + along * t;
  return {point, length_squared(p - point)};
}

}  // namespace

Box bounds(std::span<const FlatTriangle> triangles) {
  Box box;
  for (const FlatTriangle& t : triangles) box.add(bounds(t));
  return box;
}

NearestPoint nearest_point(const FlatTriangle& triangle, Vec3d p) {
  const Vec3d a(triangle.a), b(triangle.b), c(triangle.c);
  const Vec3d n = cross(b - a, c - a);
  const double square = length_squared(n);
  // A sliver is as near as its edges; its normal may be noise.
  const bool has_normal = square > 1e-16 * length_squared(b - a) * length_squared(c - a);
  if (has_normal && dot(cross(n, b - a), p - a) >= 0 && dot(cross(n, c - b), p - b) >= 0 &&
      dot(cross(n, a - c), p - c) >= 0) {
    const double height = dot(n, p - a) / square;
    return {p - n * height, height * height * square};
  }
  NearestPoint best = nearest_on_edge(a, b, p);
  for (const NearestPoint& other : {nearest_on_edge(b, c, p), nearest_on_edge(c, a, p)})
    if (other.distance_squared < best.distance_squared) best = other;
  return best;
}

}  // namespace penumbra
