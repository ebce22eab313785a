// SPDX-License-Identifier: MIT
// A parallelogram as a receiver sees it: what sampling, solid angle and irradiance share.
#pragma once

#include <array>

#include "penumbra/geometry/light_shape.h"
#include "penumbra/geometry/vec.h"

namespace penumbra {

/// Everything relative to the receiver p, in double, where it is exact: p + center + a u + b v.
struct SeenParallelogram {
  Vec3d center, u, v;

  /// In order around it, (a, b) = (-1, -1), (1, -1), (1, 1), (-1, 1).
  std::array<Vec3d, 4> corners() const {
    return {center - u - v, center + u - v, center + u + v, center - u + v};
  }
};

inline SeenParallelogram seen_from(const ParallelogramLight& light, Vec3f p) {
  return {Vec3d(light.center) - Vec3d(p), Vec3d(light.u), Vec3d(light.v)};
}

/// Solid angles of the two triangles that share the diagonal from corner 0 to corner 2 (A. van
/// Oosterom, J. Strackee, The Solid Angle of a Plane Triangle, IEEE Trans. Biomed. Eng. 1983).
/// First that of corners 0, 1, 2, then that of 0, 3, 2. Keeps its digits however small they are.
std::array<double, 2> triangle_solid_angles(const SeenParallelogram& seen);

/// Their sum: that of the parallelogram, 0 where p lies in its plane.
inline double solid_angle(const SeenParallelogram& seen) {
  const std::array<double, 2> halves = triangle_solid_angles(seen);
  return halves[0] + halves[1];
}

}  // namespace penumbra
