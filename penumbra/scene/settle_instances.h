// SPDX-License-Identifier: MIT
// Instances as files have them, brought to what the kernel can place.
#pragma once

#include <cstddef>

#include "penumbra/geometry/shape.h"

namespace penumbra {

/// What became of instances.
struct SettledInstances {
  std::size_t expanded = 0;   ///< now shapes of their own
  std::size_t stretched = 0;  ///< spheres, cones and rings that became meshes, once for each group
};

/// Groups placed once, and those of at most four primitives, become shapes of their own, where they
/// cost no more; so does what a placement flattens. Groups with spheres, cones or rings that a
/// placement stretches get a twin of meshes for it, the coarser the more there are. Indices of
/// groups must be in range. Throws Error where flattening placements would make more than 2^24
/// primitives and vertices, or twins as many triangles.
SettledInstances settle_instances(ShapeSet& shapes);

/// Whether there are spheres, cones or rings, which similarities alone can place.
bool has_quadrics(const ShapeSet& shapes);

/// Whether the kernel can place shapes by it: not flat, and the largest entry of each row from
/// 1e-15 to 1e15 (see `make_placement`). Not for NaN.
bool can_place(const Transform& map);

}  // namespace penumbra
