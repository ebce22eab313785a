// SPDX-License-Identifier: MIT
#include "penumbra/geometry/parallelogram.h"

#include <cmath>

namespace penumbra {

std::array<double, 2> triangle_solid_angles(const SeenParallelogram& seen) {
  // The triple product of the corners is that of the centre and two edges: no digits cancel.
  const double volume = std::abs(dot(seen.center, cross(seen.u * 2.0, seen.v * 2.0)));
  if (volume == 0) return {0, 0};
  const std::array<Vec3d, 4> corners = seen.corners();
  const Vec3d a = corners[0], c = corners[2];
  const double a_length = length(a), c_length = length(c);
  const auto with = [&](Vec3d b) {
    const double b_length = length(b);
    const double below = a_length * b_length * c_length + dot(a, b) * c_length +
                         dot(b, c) * a_length + dot(c, a) * b_length;
    return 2 * std::atan2(volume, below);
  };
  return {with(corners[1]), with(corners[3])};
}

}  // namespace penumbra
