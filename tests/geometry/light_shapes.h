// SPDX-License-Identifier: MIT
// Polygon and mesh lights for tests.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "penumbra/geometry/light_shape.h"

namespace penumbra {

/// A regular polygon around `center`, its first corner along u.
inline PolygonLight polygon_around(Vec3f center, Vec3f u, Vec3f v, int corners) {
  PolygonLight light{center, {}};
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    light.corners.push_back(
        Vec3f(Vec3d(center) + Vec3d(u) * std::cos(angle) + Vec3d(v) * std::sin(angle)));
  }
  return light;
}

/// A box with these half extents, its corners numbered by the bits of their signs.
inline MeshLight box_around(Vec3f center, Vec3f half) {
  MeshLight light{center, {}, {}};
  for (int i = 0; i < 8; ++i)
    light.corners.push_back(center + Vec3f(i & 1 ? half.x : -half.x, i & 2 ? half.y : -half.y,
                                           i & 4 ? half.z : -half.z));
  light.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                     {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return light;
}

}  // namespace penumbra
