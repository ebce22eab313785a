// SPDX-License-Identifier: MIT
// The closed set of shapes that a scene is made of. To add one: a kind here, its vector in
// ShapeSet, its bounds and surface, and the kernels; the switches without default list the rest.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "penumbra/geometry/box.h"
#include "penumbra/geometry/mesh.h"
#include "penumbra/geometry/transform.h"
#include "penumbra/geometry/vec.h"

namespace penumbra {

/// Whether a cone has its two disks.
enum class Caps : std::uint8_t { open, capped };

/// All points at distance `radius` (> 0) of the centre.
struct Sphere {
  Vec3f center;
  float radius = 1;
  std::uint32_t surface = 0;
};

/// A truncated cone between two circles around its axis; equal radii make a cylinder, an apex
/// radius of 0 a full cone. Radii are >= 0 and not both 0; base and apex differ. Open: the side
/// alone. Capped: a solid.
struct Cone {
  Vec3f base, apex;
  float base_radius = 1, apex_radius = 1;
  Caps caps = Caps::open;
  std::uint32_t surface = 0;
};

inline bool is_cylinder(const Cone& c) { return c.base_radius == c.apex_radius; }

/// A flat ring: points of the plane at inner_radius <= distance <= radius of the centre; a disk
/// when inner_radius is 0. The normal is unit length.
struct Ring {
  Vec3f center, normal{0, 0, 1};
  float radius = 1, inner_radius = 0;
  std::uint32_t surface = 0;
};

/// A placement of one of a ShapeSet's groups.
struct Instance {
  std::uint32_t group = 0;
  Transform placement;
};

/// Everything that can be hit, one vector a kind. Polygons are meshes (see `triangulate`).
/// Groups are stored once and drawn where instances place them, not by themselves; they hold
/// shapes alone.
struct ShapeSet {
  std::vector<Sphere> spheres;
  std::vector<Cone> cones;
  std::vector<Ring> rings;
  std::vector<Mesh> meshes;
  std::vector<ShapeSet> groups{};
  std::vector<Instance> instances{};
};

/// The vectors of a ShapeSet, by what is in them.
enum class ShapeKind : std::uint8_t { sphere, cone, ring, triangle };

/// Names one primitive of a ShapeSet.
struct ShapeRef {
  ShapeKind kind = ShapeKind::sphere;
  std::uint32_t index = 0;     ///< into the kind's vector; for a triangle, into meshes
  std::uint32_t triangle = 0;  ///< of that mesh; else 0
  std::uint32_t instance = 0;  ///< 0: one of the set's own; else 1 + the instance that places it

  constexpr bool operator==(const ShapeRef&) const = default;
};

/// Number of primitives, a mesh counts as its triangles: without what instances place, and with it.
std::size_t own_primitive_count(const ShapeSet& shapes);
std::size_t primitive_count(const ShapeSet& shapes);

/// The set's own primitives, in the order spheres, cones, rings, meshes.
std::vector<ShapeRef> all_primitives(const ShapeSet& shapes);

/// Boxes with float corners that surely hold the exact shape (rounded outward from double).
Box bounds(const Sphere& sphere);
Box bounds(const Cone& cone);
Box bounds(const Ring& ring);
Box bounds(const ShapeSet& shapes, ShapeRef ref);
/// What instances place included: exactly, but where more than 2^24 primitives stand at the
/// outside; of these the boxes of their groups are placed. Cost: linear in what is placed there.
Box bounds(const ShapeSet& shapes);

/// Box of everything but backdrops: "the largest extent of the scene's objects" is its longest
/// edge.
Box object_bounds(const ShapeSet& shapes);

/// The surface (index of a material) of a primitive.
std::uint32_t surface_of(const ShapeSet& shapes, ShapeRef ref);

}  // namespace penumbra
