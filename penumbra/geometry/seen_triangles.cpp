// SPDX-License-Identifier: MIT
#include "penumbra/geometry/seen_triangles.h"

#include <cmath>

namespace penumbra {
namespace {

SeenTriangle seen_from(Vec3f p, Vec3f a, Vec3f b, Vec3f c) {
  const Vec3d first(a);
  return {first - Vec3d(p), Vec3d(b) - first, Vec3d(c) - first};
}

}  // namespace

SeenTriangle seen_triangle(const PolygonLight& light, std::size_t i, Vec3f p) {
  return seen_from(p, light.corners[0], light.corners[i + 1], light.corners[i + 2]);
}

SeenTriangle seen_triangle(const MeshLight& light, std::size_t i, Vec3f p) {
  const auto& t = light.triangles[i];
  return seen_from(p, light.corners[t[0]], light.corners[t[1]], light.corners[t[2]]);
}

std::size_t triangle_count(const PolygonLight& light) {
  return light.corners.size() < 3 ? 0 : light.corners.size() - 2;
}

std::size_t triangle_count(const MeshLight& light) { return light.triangles.size(); }

double solid_angle(const SeenTriangle& seen) {
  const double volume = std::abs(seen.volume());
  if (!(volume > 0)) return 0;
  const Vec3d a = seen.corner, b = a + seen.to_second, c = a + seen.to_third;
  const double a_length = length(a), b_length = length(b), c_length = length(c);
  const double below = a_length * b_length * c_length + dot(a, b) * c_length +
                       dot(b, c) * a_length + dot(c, a) * b_length;
  return 2 * std::atan2(volume, below);
}

}  // namespace penumbra
