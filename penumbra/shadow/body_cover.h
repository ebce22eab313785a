// SPDX-License-Identifier: MIT
// Convex polyhedra that hide a whole light.
#pragma once

#include "penumbra/geometry/convex_polyhedron.h"
#include "penumbra/shadow/light_hull.h"

namespace penumbra {

/// True only if every segment from p to a point within `doubt` of the light passes a point that
/// lies deeper than `margin` inside the polyhedron around `center`, or p does. Exact for polyhedron
/// and light but for the margins: what a convex set hides from p is convex itself, bounded by the
/// set's faces that p sees and by planes through p along its outline. Cost: linear in the faces,
/// edges and corners of the light. NaN gives false.
bool body_covers(const ConvexPolyhedron& body, Vec3d center, const LightShaft& shaft, double margin,
                 double doubt);

}  // namespace penumbra
