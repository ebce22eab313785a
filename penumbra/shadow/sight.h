// SPDX-License-Identifier: MIT
// One record and one light seen from p, with what float may do to the rays between them.
#pragma once

#include <array>

#include "penumbra/kernel/record.h"
#include "penumbra/shadow/light_hull.h"

namespace penumbra {

/// Everything a cover proof is about. A ray is from p to a sample l; l lies within `doubt` of the
/// light, so that the ray's point at s lies within s `doubt` of the exact segment's.
struct Sight {
  LightShaft shaft;
  double doubt;   ///< as LightHull::doubt
  double margin;  ///< deeper than this inside a shape is a hit, farther than this off it is none:
                  ///< 64 ulp, where the intersector promises 8 and at most 64

  Sight(const LightHull& light, Vec3f p, double margin_)
      : shaft(light, p), doubt(light.doubt(p)), margin(margin_) {}

  Vec3d to_center() const { return shaft.c - shaft.p; }
};

/// Whether float's range suffices for what the intersector computes of the record and rays from p
/// to the light (`greatest_ratio`).
bool is_in_range(const Record& record, const LightHull& light, Vec3f p);

/// 64 ulp of the intersector: of the record's farthest box coordinate from p. NaN where float's
/// range may not suffice for the record, p and the light: then nothing is to be proven.
double intersector_margin(const Record& record, const LightHull& light, Vec3f p);

/// The corners of a polygon that hides a ball light from p: tangent to it, its plane the nearest
/// one, so that no sample lies before it. As ways from p. 2 % wider than the ball. p outside the
/// ball: NaN otherwise.
std::array<Vec3d, 16> outline_of_ball(const LightShaft& shaft);

/// Whether `holds(way)` for the ways from p to the corners of a polygon, polyhedron or outline that
/// every segment from p to the light ends in or passes: by convexity then for all of them, if
/// `holds` means that the way passes through some convex set.
template <typename F>
bool holds_for_outline(const LightShaft& shaft, const F& holds) {
  if (shaft.light.is_ball()) {
    for (const Vec3d& way : outline_of_ball(shaft))
      if (!holds(way)) return false;
    return true;
  }
  for (const Vec3d& corner : shaft.light.corners())
    if (!holds(shaft.c + corner - shaft.p)) return false;
  return true;
}

}  // namespace penumbra
