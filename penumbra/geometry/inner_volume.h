// SPDX-License-Identifier: MIT
// Convex volumes between triangles: what a solid surely has inside.
#pragma once

#include "penumbra/geometry/convex_polyhedron.h"
#include "penumbra/geometry/triangle_tree.h"
#include "penumbra/geometry/vec.h"

namespace penumbra {

/// No triangle comes nearer to the centre than `radius`, and none reaches into the polyhedron.
struct InnerVolume {
  Vec3d center;
  double radius = 0;
  ConvexPolyhedron body;  ///< around the centre; empty if there is only the ball
};

/// The largest ball around the centre that no triangle reaches into: a lower bound of its radius,
/// at most `at_most`, and at most `slack` times too small.
double clearance(const TriangleTree& triangles, Vec3d center, double at_most, double slack);

/// A centre near p, in the ball around p or in a ball around a centre so reached, and so on, with
/// more room around it: climbs to where the distance to the triangles is about largest.
Vec3d roomier_center(const TriangleTree& triangles, Vec3d p, double at_most);

/// Ball and polyhedron around a centre, both within `box`. The polyhedron is cut out by one plane
/// for each triangle, the nearest first, that the planes before have left: the triangle's own where
/// that spares the ball, else the one across the way to its nearest point. Each plane stands a
/// little inside of the triangle, so that it serves for its neighbours, too. A convex surface gives
/// its own planes. No polyhedron where that takes more than 48 planes.
/// Source: the idea of growing a convex region of free space plane by plane is that of Deits,
/// Tedrake, Computing Large Convex Regions of Obstacle-Free Space (2014), with a ball in place of
/// their ellipsoid.
InnerVolume inner_volume(const TriangleTree& triangles, Vec3d center, const Box& box);

}  // namespace penumbra
