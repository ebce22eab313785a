// SPDX-License-Identifier: MIT
// Formats that repeat a vertex for each triangle (STL, NFF): back to shared vertices.
#pragma once

#include "penumbra/geometry/mesh.h"

namespace penumbra {

/// Makes vertices one whose position and normal are equal in every bit; they come to stand in the
/// order of their first appearance. For meshes without texture coordinates and colours.
/// Cost: O(n log n), whatever the positions.
void weld(Mesh& mesh);

}  // namespace penumbra
