// SPDX-License-Identifier: MIT
// Convex volumes between triangles: what a solid surely has inside.
#pragma once

#include <optional>

#include "penumbra/geometry/convex_polyhedron.h"
#include "penumbra/geometry/triangle_tree.h"
#include "penumbra/geometry/vec.h"

namespace penumbra {

/// No triangle reaches into the polyhedron.
struct InnerVolume {
  Vec3d center;
  double radius = 0;      ///< none comes nearer to the centre than this: a lower bound
  ConvexPolyhedron body;  ///< around the centre
};

/// The largest ball around the centre that no triangle reaches into: a lower bound of its radius,
/// at most `at_most`, and at most `slack` times too small.
double clearance(const TriangleTree& triangles, Vec3d center, double at_most, double slack);

/// A centre near p, in the ball around p or in a ball around a centre so reached, and so on, with
/// more room around it: climbs to where the distance to the triangles is about largest.
Vec3d roomier_center(const TriangleTree& triangles, Vec3d p, double at_most);

/// The polyhedron around a centre, within `box`, that is cut out by one plane for each triangle,
/// the nearest first, which the planes before have left: the triangle's own where that spares the
/// largest ball, else the one across the way to its nearest point. Each plane stands a little
/// inside of its triangle, so that it serves for the neighbours, too. A convex surface gives its
/// own planes. Nothing where that takes more than 48 planes or the result is too thin (see
/// `convex_polyhedron.h`). The idea of growing a region of free space plane by plane is that of R.
/// Deits, R. Tedrake, Computing Large Convex Regions of Obstacle-Free Space through Semidefinite
/// Programming (2014), with a ball in place of their ellipsoid.
std::optional<InnerVolume> inner_volume(const TriangleTree& triangles, Vec3d center,
                                        const Box& box);

}  // namespace penumbra
