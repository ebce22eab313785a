// SPDX-License-Identifier: MIT
// Round shapes as triangle meshes, for maps that leave them no quadric of ours, and for parts of
// them. All are swept around an axis: straight segments between points of the true surface, with
// its normals.
#pragma once

#include <numbers>

#include "penumbra/geometry/mesh.h"
#include "penumbra/geometry/shape.h"

namespace penumbra {

inline constexpr double full_turn_rad = 2 * std::numbers::pi;

// Parts of surfaces around the z axis and the origin, from the xz plane (x > 0) counter-clockwise
// by `angle_rad` in (0, full_turn_rad].

/// The points of a sphere with z_min <= z <= z_max (clamped to it); seen from outside.
struct SphereZone {
  double radius = 1, z_min = -1, z_max = 1, angle_rad = full_turn_rad;
};

/// The side of a cylinder; seen from outside.
struct CylinderWall {
  double radius = 1, z_min = -1, z_max = 1, angle_rad = full_turn_rad;
};

/// The points at inner_radius <= distance <= radius of the axis in a plane across it; seen from +z.
struct DiskSector {
  double radius = 1, inner_radius = 0, height = 0, angle_rad = full_turn_rad;
};

// A mesh for each. `segments` (3 or more) are in a full turn, and half as many from pole to pole.
// (1) Every vertex lies on the shape to float precision, and its normal is the shape's there.
// (2) Triangles are counter-clockwise seen from where the shape is: the side its normals point to.
// (3) Whole spheres and capped cones are closed. (4) No triangle is degenerate where the shape is
// not. Chords are at most radius (1 - cos(pi / segments)) away from the shape.
// Cost: linear in the triangles: segments² for a sphere, 2 segments for a wall, a ring and each of
// a cone's parts.
Mesh tessellated(const SphereZone& zone, int segments);
Mesh tessellated(const CylinderWall& wall, int segments);
Mesh tessellated(const DiskSector& sector, int segments);
Mesh tessellated(const Sphere& sphere, int segments);
Mesh tessellated(const Cone& cone, int segments);
Mesh tessellated(const Ring& ring, int segments);

}  // namespace penumbra
