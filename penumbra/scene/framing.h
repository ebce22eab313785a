// SPDX-License-Identifier: MIT
// Private to the layer: where a camera stands that sees all objects.
#pragma once

#include "penumbra/geometry/box.h"
#include "penumbra/geometry/shape.h"
#include "penumbra/scene/camera.h"

namespace penumbra::detail {

/// What counts as the scene when it is framed, lit and put on a ground.
struct Subject {
  Vec3d center;
  double extent = 1;  ///< the longest edge of its box, > 0
  Box box;
};

/// The objects; in a scene of nothing but backdrops, those.
Subject subject_of(const ShapeSet& shapes);

/// Farthest any object (backdrop, if there is nothing else) reaches along a direction: the largest
/// dot(p, direction). Exact for the shapes themselves, not for their boxes; but an upper bound
/// where more than 2^24 primitives stand at the outside of what instances place. Cost: linear in
/// these.
double reach(const ShapeSet& shapes, Vec3d direction);

/// The horizontal direction a model of this up looks to by convention: -y for z up, +z for y up.
Vec3d front(Vec3d up);

/// `v` turned about the unit vector `axis`, counter-clockwise seen from its tip.
Vec3d rotated(Vec3d v, Vec3d axis, double angle_rad);

/// A three-quarter view from the front, a little from above, as near as a square picture allows
/// with a margin on each side.
Camera camera_around(const ShapeSet& shapes, Vec3d up, double fov_deg);

}  // namespace penumbra::detail
