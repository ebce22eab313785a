// SPDX-License-Identifier: MIT
// How far a light keeps off the surface of a mesh.
#pragma once

#include "penumbra/geometry/closed_surface.h"
#include "penumbra/shadow/light_hull.h"

namespace penumbra {

/// A lower bound of the distance between the light and the surface with its fills, if it lies
/// wholly outside of what they enclose; else, and in doubt, -1. Infinite for suns. Cost: linear in
/// the triangles; a lower bound may be as low as 1e-5 of the surface's extent where the light is as
/// near as it is large.
double light_clearance(const ClosedSurface& surface, const LightHull& light);

}  // namespace penumbra
