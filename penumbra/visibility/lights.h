// SPDX-License-Identifier: MIT
// Lights that need some computing before they are one; the others are structs to be filled
// (geometry/light_shape.h).
#pragma once

#include <span>

#include "penumbra/geometry/light_shape.h"

namespace penumbra {

/// A convex polygon, corners in order around it. Throws Error where it is bent, dented, or has
/// fewer than three.
PolygonLight polygon_light(std::span<const Vec3f> corners);

/// The convex hull of points. Throws Error where they lie in one plane.
MeshLight hull_light(std::span<const Vec3f> points);

/// A sun. `towards` it, any length; its angular diameter in degrees, that of the Earth's by
/// default.
SunLight sun_light(Vec3f towards, float diameter_deg = 0.533f);

/// The light with unit directions. Throws Error with what is wrong with one that is none: a size
/// that is not above 0, coordinates that are not finite. Every question does so with its light.
LightShape checked_light(LightShape light);

}  // namespace penumbra
