// SPDX-License-Identifier: MIT
// A flat surface of triangles as few convex polygons: cut along lines where that takes most from
// the hulls of the pieces, then put together again what makes convex unions.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "penumbra/geometry/polygon_ears.h"

namespace penumbra {

using PlaneTriangle = std::array<PlanePoint, 3>;

struct FlatPiece {
  std::vector<PlanePoint> ring;  ///< convex, counter-clockwise
  double area = 0;  ///< of the triangles in it: that of the ring where the piece fills it
};

/// At most `most` polygons that cover the triangles, which turn either way and do not overlap; how
/// they meet (T-junctions, points along edges) does not matter.
/// (1) Where few enough convex polygons make the surface, to 10⁻⁴ of each one's area, it is cut
///     into such, though not always into the fewest; a convex surface is one.
/// (2) The areas of the pieces add up to that of the triangles.
/// (3) The same triangles in another order give the same pieces.
/// None where the triangles have no area. Cost: O(n log n), up to a second for 10⁵ triangles.
std::vector<FlatPiece> flat_pieces(std::span<const PlaneTriangle> triangles, std::size_t most);

}  // namespace penumbra
