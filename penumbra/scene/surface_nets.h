// SPDX-License-Identifier: MIT
// Private to the layer: the zero set of a function as a closed triangle mesh. Surface nets (Gibson,
// Constrained Elastic Surface Nets, 1998, in the common form without the elastic step): one vertex
// a grid cell that the surface crosses, one quadrilateral a grid edge.
#pragma once

#include <array>
#include <vector>

#include "penumbra/geometry/mesh.h"
#include "penumbra/geometry/vec.h"

namespace penumbra::detail {

/// The grid planes along x, y and z, increasing; they need not be evenly spaced.
using GridPlanes = std::array<std::vector<double>, 3>;

/// The surface where `field` is 0, below 0 inside. The field must be positive on the whole boundary
/// of the grid and change by at most `steepness` a unit of length; then the mesh is closed.
/// Vertices are moved onto the surface within their cells and get its normals. Cost: the field is
/// evaluated once a grid point near the surface.
Mesh surface_nets(const GridPlanes& planes, double (*field)(Vec3d), double steepness);

}  // namespace penumbra::detail
