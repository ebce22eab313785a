// SPDX-License-Identifier: MIT
// Which triangles of a mesh lie side by side.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "penumbra/geometry/mesh.h"

namespace penumbra {

inline constexpr std::uint32_t no_triangle = 0xffffffffu;

/// For each triangle the one across its edge from corner k to corner (k + 1) % 3; `no_triangle`
/// where that edge is not shared by exactly two. Positions that are equal count as one. Cost:
/// O(n log n), 0.1 s for a million triangles.
std::vector<std::array<std::uint32_t, 3>> triangle_neighbors(const Mesh& mesh);

}  // namespace penumbra
