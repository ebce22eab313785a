// SPDX-License-Identifier: MIT
// Convex polygons in the plane: hulls (A. M. Andrew, Another Efficient Algorithm for Convex Hulls
// in Two Dimensions, Information Processing Letters 1979), and the same with fewer corners.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "penumbra/geometry/polygon_ears.h"

namespace penumbra {

/// Counter-clockwise, from the leftmost corner on, no three corners in a row; fewer than three
/// where the points have no area. The same whatever order the points come in. Cost: O(n log n).
std::vector<PlanePoint> planar_hull(std::vector<PlanePoint> points);

/// Positive when counter-clockwise.
double area(std::span<const PlanePoint> ring);

/// A convex ring without those corners that stand out by at most `slack`, and then, while it has
/// more than `most` (at least 3), without the one that takes the least area with it; what is left
/// then is widened about its middle to the area it had. Cost: corners².
std::vector<PlanePoint> fewer_corners(std::vector<PlanePoint> ring, std::size_t most, double slack);

}  // namespace penumbra
