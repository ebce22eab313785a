// SPDX-License-Identifier: MIT
// Flat disks as holes: the missing caps of open cones, the holes of rings.
#pragma once

#include <algorithm>
#include <cmath>

#include "penumbra/geometry/separation.h"
#include "penumbra/shadow/sight.h"

namespace penumbra {

/// The point of the unit disk across `normal` (unit) that is farthest along n; near the centre
/// where n is along the normal.
inline Vec3d farthest_of_unit_disk(Vec3d normal, Vec3d n) {
  const Vec3d across = normalize(n - normal * dot(n, normal));
  return across - normal * dot(across, normal);  // rounding may have been all there was
}

struct Disk {
  Vec3d center, normal;  // unit
  double radius;
  Vec3d support(Vec3d n) const { return center + farthest_of_unit_disk(normal, n) * radius; }
};

/// True only if every ray from p to the light's samples stays farther from the disk than twice the
/// margin.
inline bool shaft_misses(const Disk& disk, const Sight& sight) {
  const double margin = 2 * sight.margin + sight.doubt;
  const Vec3d to_p = sight.shaft.p - disk.center, way = sight.to_center();
  const double height = dot(to_p, disk.normal), fall = -dot(way, disk.normal);
  const Vec3d up = disk.normal * (height < 0 ? -1.0 : 1.0);
  if (dot(sight.shaft.support(-up) - disk.center, up) > margin) return true;
  // Where the way to the light's centre is nearest to the plane.
  const double s = fall != 0 ? std::clamp(height / fall, 0.0, 1.0) : 0;
  return surely_apart(sight.shaft, disk, to_p + way * s, margin);
}

}  // namespace penumbra
