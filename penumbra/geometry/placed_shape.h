// SPDX-License-Identifier: MIT
// Shapes as instances place them.
#pragma once

#include <array>

#include "penumbra/geometry/shape.h"
#include "penumbra/geometry/transform.h"

namespace penumbra {

/// What the map multiplies all lengths by, if it turns, mirrors, moves and scales alone (to 2^-22);
/// else 0. Spheres, cones and rings stay what they are only then.
double similarity_scale(const Transform& map);

/// The similarity nearest to the map in that order: its x axis' direction stays, y turns in their
/// plane, and lengths become the cube root of the volume. For maps that text has rounded.
Transform nearest_similarity(const Transform& map);

// The shapes under a similarity of this scale, rounded to float once.
Sphere placed(const Sphere& sphere, const Transform& map, double scale);
Cone placed(const Cone& cone, const Transform& map, double scale);
Ring placed(const Ring& ring, const Transform& map, double scale);

/// Corners in the world. Under mirroring maps in the other order, so that outside stays outside.
std::array<Vec3f, 3> corners(const ShapeSet& shapes, ShapeRef triangle);

/// Box that holds the box under the map.
Box placed(const Box& box, const Transform& map);

/// The set that a primitive is stored in: the shapes themselves, or the group of its instance.
inline const ShapeSet& home_of(const ShapeSet& shapes, ShapeRef ref) {
  return ref.instance == 0 ? shapes : shapes.groups[shapes.instances[ref.instance - 1].group];
}

/// The same scene without groups: every instance as shapes of its own, in the order of instances.
/// Cost: memory of all that is placed.
ShapeSet flattened(const ShapeSet& shapes);

/// Adds the group as `placement` has it to the shapes.
void add_placed(ShapeSet& shapes, const ShapeSet& group, const Transform& placement);

}  // namespace penumbra
