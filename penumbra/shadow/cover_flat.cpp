// SPDX-License-Identifier: MIT
#include "penumbra/shadow/cover_flat.h"

#include <cmath>

#include "penumbra/shadow/disk.h"

namespace penumbra {
namespace {

/// Least n . (l - p) over the samples, n of unit length.
double least(const Sight& sight, Vec3d n) {
  return dot(n, sight.to_center() + sight.shaft.light.spread(-n)) - sight.doubt;
}

double most(const Sight& sight, Vec3d n) { return -least(sight, -n); }

/// Whether a plane `height` before p lies surely between p and all samples, the nearest of which is
/// `nearest` before p: a hit of the intersector on it then lies between them.
bool is_between(const Sight& sight, double height, double nearest) {
  return height > 2 * sight.margin && nearest - height > 2 * sight.margin;
}

/// By how much the errors of rays may move the points where they cross a plane, within `reach` of
/// p.
double stray_in_plane(const Sight& sight, double height, double nearest, double reach) {
  // Flat rays move along the plane while they are within the margin of it.
  const double grazing = sight.margin * (1 + reach / height);
  // A sample off by `doubt`, the rise of whose ray is at least `nearest`.
  const double length_of_ray = length(sight.to_center()) + sight.shaft.light.size();
  return grazing + height / nearest * sight.doubt * (1 + length_of_ray / nearest);
}

}  // namespace

bool triangle_covers(const Record& record, const Sight& sight) {
  const Vec3d p = sight.shaft.p;
  const Vec3d corner[3] = {Vec3d(record.vector(0)) - p, Vec3d(record.vector(3)) - p,
                           Vec3d(record.vector(6)) - p};
  Vec3d n = normalize(cross(corner[1] - corner[0], corner[2] - corner[0]));
  const double turn = dot(n, corner[0]) < 0 ? -1 : 1;
  n = n * turn;
  const double height = dot(n, corner[0]);
  if (!is_between(sight, height, least(sight, n))) return false;
  // Rays cross at s and more, where they are that much nearer to the planes through p than the
  // light is.
  const double s = height / most(sight, n);
  for (int k = 0; k < 3; ++k) {
    const Vec3d inward = normalize(cross(corner[k], corner[(k + 1) % 3])) * turn;
    if (!(s * least(sight, inward) > sight.margin)) return false;
  }
  return true;
}

bool ring_covers(const Record& record, const Sight& sight) {
  const Vec3d to_center = Vec3d(record.vector(0)) - sight.shaft.p;
  Vec3d n = normalize(Vec3d(record.vector(3)));
  if (dot(n, to_center) < 0) n = -n;
  const double height = dot(n, to_center), radius = record.number[6];
  const double nearest = least(sight, n);
  if (!is_between(sight, height, nearest)) return false;
  const double stray = stray_in_plane(sight, height, nearest, length(to_center) + radius);
  const auto crosses = [&](Vec3d way) {
    const double rise = dot(n, way);
    return rise > 0 && length(way * (height / rise) - to_center) + stray < radius;
  };
  if (!crosses(sight.to_center()) || !holds_for_outline(sight.shaft, crosses)) return false;
  const double inner = record.number[7];
  return inner == 0 || shaft_misses({Vec3d(record.vector(0)), n, inner}, sight);
}

}  // namespace penumbra
