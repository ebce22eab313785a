// SPDX-License-Identifier: MIT
// Meshes as solids: convex volumes inside of what they enclose. This is the inner offset of meshes
// in a form that can be asked quickly: a convex set lies in the solid shrunk by it if it lies, so
// shrunk, in one of the volumes (paper, section 3, Lemma 3, left open there for meshes).
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "penumbra/geometry/closed_surface.h"
#include "penumbra/geometry/inner_volume.h"
#include "penumbra/geometry/mesh.h"

namespace penumbra {

struct MeshSolid {
  ClosedSurface surface;
  std::vector<InnerVolume> volumes;  ///< at least one; the most useful first
};

struct MeshSolidOptions {
  std::size_t most_solids = 4096;  ///< the largest are taken
  std::size_t most_volumes = 100;  ///< in all, besides one for each solid
};

/// (1) Every volume, polyhedron and ball, is free of triangles of its own surface and fills, and
/// enclosed by them: any path from it to where `is_inside` is false crosses one. Surfaces are taken
/// each for itself, so volumes of one may be crossed by others. (2) The same meshes give the same
/// solids. Cost: 0.5 s for 100,000 triangles, 1.8 s for a million, on one core.
std::vector<MeshSolid> mesh_solids(std::span<const Mesh> meshes,
                                   const std::vector<bool>& casts_no_shadow,
                                   const MeshSolidOptions& options);

}  // namespace penumbra
