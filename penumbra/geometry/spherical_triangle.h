// SPDX-License-Identifier: MIT
// Directions uniform in a spherical triangle (J. Arvo, Stratified Sampling of Spherical Triangles,
// SIGGRAPH 1995).
#pragma once

#include "penumbra/geometry/vec.h"

namespace penumbra {

/// What Arvo's method needs of a spherical triangle with unit corners a, b, c.
struct SphericalTriangle {
  double solid_angle = 0;
  double sine = 0, cosine = 0, angle = 0;  // at a
  double cos_ab = 0;
  Vec3d a, toward_c, b;  // toward_c: unit, perpendicular to a, in the plane of a and c
};

/// Of the triangle that these corners, of any length, span with the origin.
SphericalTriangle spherical_triangle(Vec3d a, Vec3d b, Vec3d c, double solid_angle);

/// Unit length, uniform in solid angle for (u, v) uniform in the unit square: the sub-triangle
/// a b c' has u of the area; v goes along the arc from b to c'. So u runs along the side from a to
/// c, and triangles in a fan around b join without a jump.
Vec3d direction_in(const SphericalTriangle& triangle, double u, double v);

}  // namespace penumbra
