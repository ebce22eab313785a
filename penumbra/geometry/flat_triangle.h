// SPDX-License-Identifier: MIT
// Triangles by value: a surface as a list of corners.
#pragma once

#include <span>

#include "penumbra/geometry/box.h"
#include "penumbra/geometry/vec.h"

namespace penumbra {

struct FlatTriangle {
  Vec3f a, b, c;
};

inline Box bounds(const FlatTriangle& t) {
  Box box;
  box.add(t.a), box.add(t.b), box.add(t.c);
  return box;
}

Box bounds(std::span<const FlatTriangle> triangles);

/// The point of the triangle that is nearest to p. Slivers and triangles of no area are fine.
struct NearestPoint {
  Vec3d point;
  double distance_squared = 0;
};
NearestPoint nearest_point(const FlatTriangle& triangle, Vec3d p);

/// More than by what the distance of a nearest point to p may be too large: slivers narrower than
/// 1e-8 of their length count as their edges.
inline double distance_doubt(Vec3d p, double distance) { return 1e-9 * (max_abs(p) + distance); }

}  // namespace penumbra
