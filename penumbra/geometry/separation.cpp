// SPDX-License-Identifier: MIT
#include "penumbra/geometry/separation.h"

#include <cstdint>

namespace penumbra {
namespace {

/// The nearest point of the hull of some corners, and which corners (as bits) it is made of.
struct Nearest {
  Vec3d point;
  double square = std::numeric_limits<double>::infinity();
  unsigned corners = 0;

  void improve(const Nearest& other) {
    if (other.square < square) *this = other;
  }
};

Nearest made(Vec3d point, unsigned corners) { return {point, length_squared(point), corners}; }

Nearest on_segment(const Simplex& s, int i, int j) {
  const Vec3d a = s.point[i], along = s.point[j] - a;
  const double way = -dot(a, along), square = length_squared(along);
  if (!(way > 0)) return made(a, 1u << i);
  if (!(way < square)) return made(s.point[j], 1u << j);
  return made(a + along * (way / square), 1u << i | 1u << j);
}

Nearest on_triangle(const Simplex& s, int i, int j, int k) {
  const int corner[3] = {i, j, k};
  const Vec3d normal = cross(s.point[j] - s.point[i], s.point[k] - s.point[i]);
  Nearest best;
  for (int e = 0; e < 3; ++e) {
    const int from = corner[e], to = corner[(e + 1) % 3];
    const Vec3d inward = cross(normal, s.point[to] - s.point[from]);
    // A triangle without area is its edges.
    if (!(dot(s.point[from], inward) < 0)) best.improve(on_segment(s, from, to));
  }
  if (best.corners != 0) return best;
  // Along the normal, which slivers leave more digits than weights of their corners.
  const double along = dot(s.point[i], normal) / length_squared(normal);
  return made(normal * along, 1u << i | 1u << j | 1u << k);
}

/// The face opposite to the newest corner is left out: it was the nearest, and the newest is
/// nearer.
Nearest on_tetrahedron(const Simplex& s) {
  constexpr int face[3][4] = {{0, 1, 3, 2}, {1, 2, 3, 0}, {2, 0, 3, 1}};  // and the corner opposite
  Nearest best;
  for (const auto& [i, j, k, opposite] : face) {
    const Vec3d a = s.point[i], normal = cross(s.point[j] - a, s.point[k] - a);
    const double inner = dot(s.point[opposite] - a, normal), origin = -dot(a, normal);
    if (!(inner * origin > 0)) best.improve(on_triangle(s, i, j, k));
  }
  return best.corners != 0 ? best : Nearest{{}, 0, 15};
}

Nearest nearest(const Simplex& s) {
  switch (s.count) {
    case 1: return made(s.point[0], 1);
    case 2: return on_segment(s, 0, 1);
    case 3: return on_triangle(s, 0, 1, 2);
    default: return on_tetrahedron(s);
  }
}

}  // namespace

Vec3d extend(Simplex& simplex, Vec3d point) {
  simplex.point[simplex.count++] = point;
  const Nearest found = nearest(simplex);
  int kept = 0;
  for (int i = 0; i < simplex.count; ++i)
    if (found.corners >> i & 1) simplex.point[kept++] = simplex.point[i];
  simplex.count = kept;
  return found.point;
}

}  // namespace penumbra
