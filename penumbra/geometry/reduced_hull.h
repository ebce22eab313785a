// SPDX-License-Identifier: MIT
// Convex hulls of few corners: lights cost by the corner.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "penumbra/geometry/convex_polyhedron.h"
#include "penumbra/geometry/light_shape.h"

namespace penumbra {

/// `count` unit vectors, evenly spread (a Fibonacci lattice).
std::vector<Vec3d> spread_directions(std::size_t count);

/// Of the points those that lie farthest in one of `count` spread directions; all where they are no
/// more than `count`. In an order of their own, each once. Cost: points times directions.
std::vector<Vec3f> extreme_points(std::span<const Vec3f> points, std::size_t count);

/// Outward, one a triangle.
std::vector<HalfSpace> face_planes(const MeshLight& light);

/// Surface of a closed mesh.
double surface_area(const MeshLight& light);

/// The points' hull where it has at most `most` (>= 4) corners; else that of so many of them, added
/// by how far they stick out, widened about its centre to the surface that it had. None where the
/// points lie in one plane. The same for any order of points, and their number. Cost: some 20
/// microseconds for the hull of 50 points, 10 ms where 10⁴ corners are reduced to 40.
std::optional<MeshLight> reduced_hull(std::span<const Vec3f> points, std::size_t most);

}  // namespace penumbra
