// SPDX-License-Identifier: MIT
// Polygon and mesh lights as the triangles that a receiver sees: what sampling, solid angle and
// irradiance share.
#pragma once

#include <array>
#include <cstddef>

#include "penumbra/geometry/light_shape.h"
#include "penumbra/geometry/vec.h"

namespace penumbra {

/// Relative to the receiver, in double, where it is exact: a corner, and the edges from it.
struct SeenTriangle {
  Vec3d corner, to_second, to_third;

  /// Six times the signed volume of the tetrahedron with p: negative where p is on the side from
  /// which the corners go round counter-clockwise.
  double volume() const { return dot(corner, cross(to_second, to_third)); }

  std::array<Vec3d, 3> corners() const { return {corner, corner + to_second, corner + to_third}; }
};

/// Triangle i of the corners.size() - 2 of a fan around corner 0.
SeenTriangle seen_triangle(const PolygonLight& light, std::size_t i, Vec3f p);
SeenTriangle seen_triangle(const MeshLight& light, std::size_t i, Vec3f p);

std::size_t triangle_count(const PolygonLight& light);
std::size_t triangle_count(const MeshLight& light);

/// Solid angle (A. van Oosterom, J. Strackee, The Solid Angle of a Plane Triangle, IEEE Trans.
/// Biomed. Eng. 1983), from either side. Keeps its digits however small.
double solid_angle(const SeenTriangle& seen);

}  // namespace penumbra
