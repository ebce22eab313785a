// SPDX-License-Identifier: MIT
// Convex polyhedra that hide a whole light.
#pragma once

#include <array>
#include <cstddef>

#include "penumbra/geometry/convex_polyhedron.h"
#include "penumbra/shadow/light_hull.h"

namespace penumbra {

/// What a shaft is at least as wide as, across its axis: rejects volumes that are too small.
struct ShaftWidth {
  Vec3d p, axis;                // axis: c - p, by its square length
  double length = 0;            // of c - p
  std::array<Vec3d, 4> out;     // unit, across
  std::array<double, 4> reach;  // of L - c along them

  explicit ShaftWidth(const LightShaft& shaft);

  /// False only if no part of the ball hides the whole light: the shaft is wider than the ball even
  /// at its near end, or lies beside it.
  bool may_fit(Vec3d center, double radius) const {
    const Vec3d to = center - p;
    const double from = dot(to, axis) - radius / length;  // share of the way where the ball begins
    if (!(from < 1)) return false;
    for (std::size_t i = 0; i < out.size(); ++i)
      if (from * reach[i] > dot(to, out[i]) + radius) return false;
    return true;
  }
};

/// True only if every segment from p to a point within `doubt` of the light passes a point that
/// lies deeper than `margin` inside the polyhedron around `center`, or p does. Exact for polyhedron
/// and light but for the margins: what a convex set hides from p is convex itself, bounded by the
/// set's faces that p sees and by planes through p along its outline. Cost: linear in the faces,
/// edges and corners of the light. At most 64 faces: more prove nothing. NaN gives false.
bool body_covers(const ConvexPolyhedron& body, Vec3d center, const LightShaft& shaft, double margin,
                 double doubt);

}  // namespace penumbra
