// SPDX-License-Identifier: MIT
#include "penumbra/shadow/light_clearance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "penumbra/geometry/separation.h"
#include "penumbra/geometry/surface_parity.h"
#include "penumbra/geometry/triangle_tree.h"
#include "penumbra/shadow/flat_hull.h"

namespace penumbra {
namespace {

/// Clearances that are tried where the ball around the light gives none, by the surface's extent.
constexpr double tried[] = {1e-1, 1e-2, 1e-3, 1e-4, 1e-5};

/// The largest of the tried clearances that all triangles keep, or -1.
double proven_clearance(const ClosedSurface& surface, const LightSet& light, double extent) {
  std::size_t level = 0;
  for (const FlatTriangle& triangle : surface.triangles) {
    const NearestPoint nearest = nearest_point(triangle, light.c);
    const double distance = std::sqrt(nearest.distance_squared) - light.light.size();
    while (!(distance > tried[level] * extent) &&
           !surely_apart(light, FlatHull(triangle), light.c - nearest.point, tried[level] * extent))
      if (++level == std::size(tried)) return -1;
  }
  return tried[level] * extent;
}

}  // namespace

double light_clearance(const ClosedSurface& surface, const LightHull& light) {
  if (light.is_sun()) return std::numeric_limits<double>::infinity();
  const Vec3d center = light.center({});
  const double extent = max_abs(Vec3d(surface.box.hi) - Vec3d(surface.box.lo));
  const double from_box = std::sqrt(TriangleTree::distance_squared(surface.box, center));
  const double off_box = from_box - light.size() - distance_doubt(center, from_box);
  if (off_box > tried[0] * extent) return off_box;
  double square = std::numeric_limits<double>::infinity();
  for (const FlatTriangle& triangle : surface.triangles)
    square = std::min(square, nearest_point(triangle, center).distance_squared);
  const double distance = std::sqrt(square);
  double clearance = distance - light.size() - distance_doubt(center, distance);
  if (!light.is_ball() && !(clearance > tried[0] * extent))
    clearance = proven_clearance(surface, {light, center}, extent);
  return clearance > 0 && !is_inside(surface.triangles, center) ? clearance : -1;
}

}  // namespace penumbra
