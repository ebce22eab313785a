// SPDX-License-Identifier: MIT
// What closes a surface with holes: triangles over the loops of its odd edges.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "penumbra/geometry/flat_triangle.h"

namespace penumbra {

/// Triangles F over the edges that an odd number of a surface's triangles share: every edge of
/// surface and F together is shared by an even number. `odd_edges`: pairs of positions, each pair
/// once; every position belongs to an even number of them. Each loop of n edges gets n - 2
/// triangles around a corner, or n around its middle if it is long. Cost: O(n log n).
std::vector<FlatTriangle> hole_fills(std::span<const std::array<std::uint32_t, 2>> odd_edges,
                                     std::span<const Vec3f> positions);

}  // namespace penumbra
