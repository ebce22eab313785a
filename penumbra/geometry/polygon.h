// SPDX-License-Identifier: MIT
// Simple polygons, convex or concave, cut into triangles by ear clipping
// (Meisters 1975; the ear test after Held, FIST, Algorithmica 2001, in its basic form).
#pragma once

#include <span>
#include <vector>

#include "penumbra/geometry/mesh.h"
#include "penumbra/geometry/vec.h"

namespace penumbra {

/// Normal by Newell's sum, its length twice the area; zero when the area is.
Vec3d polygon_normal(std::span<const Vec3f> corners);

/// Triangles over the corners' indices, with the polygon's orientation.
/// (1) A simple planar polygon of n corners gives n - 2 triangles that cover it once.
/// (2) A polygon that crosses itself, is not planar or has repeated corners gives at most n - 2
///     triangles, never a crash or an endless loop. Bridges to holes are fine.
/// Cost: O(n) for convex polygons (fanned), near O(n) for usual concave ones; bounded by some 50
/// microseconds a corner. What is left then, of contrived outlines of more than 10⁴ corners, is cut
/// without care.
std::vector<Triangle> triangulate(std::span<const Vec3f> corners);

}  // namespace penumbra
