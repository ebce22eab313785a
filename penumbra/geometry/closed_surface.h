// SPDX-License-Identifier: MIT
// The parts of meshes that enclose a volume, or would with their holes filled.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "penumbra/geometry/flat_triangle.h"
#include "penumbra/geometry/mesh.h"

namespace penumbra {

/// Triangles S of meshes and fills F of their holes. Every edge of S and F together is shared by an
/// even number of triangles (the edges of equal corner positions being one), so that any path from
/// where `is_inside` holds to where it doesn't crosses S or F. The surface may cross itself.
struct ClosedSurface {
  std::vector<FlatTriangle> triangles;  ///< S, then F
  std::size_t first_fill = 0;           ///< where F begins
  Box box;                              ///< of S and F

  std::span<const FlatTriangle> fills() const { return std::span(triangles).subspan(first_fill); }
};

/// One for each component (triangles connected by edges, across meshes) of those triangles that
/// cast shadows (`casts_no_shadow` by surface; shorter than the surfaces: the rest casts). Of
/// components in which every triangle is there an even number of times (two-sided models) one each
/// is taken. Components with more holes than surface (single polygons, foliage, triangle soup) are
/// left out, those with more than 512 fills and those that have a corner that isn't finite, too.
/// Cost: O(n log n): 0.3 s for a million triangles.
std::vector<ClosedSurface> closed_surfaces(std::span<const Mesh> meshes,
                                           const std::vector<bool>& casts_no_shadow);

}  // namespace penumbra
