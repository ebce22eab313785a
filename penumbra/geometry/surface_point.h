// SPDX-License-Identifier: MIT
// Where on a primitive a ray hit it, and where shadow rays start: the point p' that all methods
// share.
#pragma once

#include "penumbra/geometry/shape.h"
#include "penumbra/geometry/vec.h"

namespace penumbra {

struct SurfacePoint {
  Vec3d position;        ///< on the primitive, to double precision
  Vec3d normal;          ///< unit, geometric, on the side the ray came from
  bool is_back = false;  ///< the ray came from the side the primitive's own normal points away from
                         ///< (its inside)
  double offset =
      0;  ///< more than the error of `position` in float and of the intersector on this primitive
  double barycentric[3] = {};  ///< of triangles: weights of the corners
};

/// The point nearest to origin + t direction on the primitive that was hit there. Degenerate
/// primitives give some finite point. offset = 32 ulp of (largest coordinate + extent of the
/// primitive): the intersector's own error at that distance is below it for all shapes (but for
/// sharp corners of triangles seen edge-on), and the rounding of p' is 1 ulp.
SurfacePoint surface_point(const ShapeSet& shapes, ShapeRef ref, Vec3d origin, Vec3d direction,
                           double t);

/// p' = position + offset * normal, rounded to float.
Vec3f receiver_position(const SurfacePoint& point);

/// The same on the other side, where refracted rays start.
Vec3f behind_position(const SurfacePoint& point);

}  // namespace penumbra
