// SPDX-License-Identifier: MIT
// Private to the layer: triangles on both sides of a plane.
#pragma once

#include <span>
#include <vector>

#include "penumbra/geometry/convex_polyhedron.h"
#include "penumbra/scene/glowing_surface.h"

namespace penumbra {

struct Halves {
  std::vector<GlowingTriangle> below, above;
};

/// What lies in the half-space, and what beyond it; triangles that the plane meets are cut. What is
/// as near to the plane as 10⁻⁵ of the size of all lies on it, and goes where its middle is.
Halves cut(std::span<const GlowingTriangle> triangles, const HalfSpace& plane);

}  // namespace penumbra
