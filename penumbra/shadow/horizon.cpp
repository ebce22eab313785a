// SPDX-License-Identifier: MIT
#include <algorithm>

#include "penumbra/shadow/offset.h"
#include "penumbra/shadow/record_hull.h"

namespace penumbra {
namespace {

/// Whether p, which is `clearance` above the hull along the unit vector n, and the whole light are
/// so high above it that all between them is farther from the hull than hits lie.
bool clears(double clearance, Vec3d n, double bound, const LightHull& light, Vec3f p) {
  return clearance > bound && clearance + light.least_height(p, n) > bound;
}

bool behind_sphere(const Record& sphere, const LightHull& light, Vec3f p) {
  const Vec3d away = Vec3d(p) - Vec3d(sphere.vector(0));
  const double distance = length(away);
  return clears(distance - sphere.number[3], away / distance, hit_bound(sphere, p), light, p);
}

/// The plane touches the solid where it is nearest to p, which is in the plane of axis and p;
/// inside the solid p is below it.
bool behind_cone(const Record& record, const LightHull& light, Vec3f p) {
  const ConeHull cone(record);
  const Vec3d to = Vec3d(p) - cone.base;
  const double h = dot(to, cone.axis);
  const Vec3d across = to - cone.axis * h, radial = normalize(across);
  const double r = dot(across, radial);
  // Distances in that plane: to the caps, and to the side.
  const double rise = cone.apex_radius - cone.base_radius,
               square = cone.height * cone.height + rise * rise;
  const double side =
      std::clamp((h * cone.height + (r - cone.base_radius) * rise) / square, 0.0, 1.0);
  const Vec3d candidate[3] = {{h, r - std::min(r, cone.base_radius), 0},
                              {h - cone.height, r - std::min(r, cone.apex_radius), 0},
                              {h - side * cone.height, r - cone.base_radius - side * rise, 0}};
  Vec3d nearest = candidate[0];
  for (const Vec3d& other : candidate)
    if (length_squared(other) < length_squared(nearest)) nearest = other;
  const Vec3d n = normalize(cone.axis * nearest.x + radial * nearest.y);
  return clears(dot(Vec3d(p) - cone.support(n), n), n, hit_bound(record, p), light, p);
}

bool behind_ring(const Record& ring, const LightHull& light, Vec3f p) {
  const DiskHull disk(ring);
  const double height = dot(Vec3d(p) - disk.center, disk.normal);
  const Vec3d n = height < 0 ? -disk.normal : disk.normal;
  return clears(std::abs(height), n, hit_bound(ring, p), light, p);
}

/// Points on a triangle are nearer to it than its hits may lie. But where float can't tell the side
/// of the plane that a ray starts from, the intersector finds the crossing in double: rays that
/// start above the plane and go farther away from it are not hits, however low they start. Others
/// must keep their distance.
bool behind_triangle(const Record& record, const LightHull& light, Vec3f p) {
  const Vec3d a(record.vector(0)), ab = Vec3d(record.vector(3)) - a,
                                   ac = Vec3d(record.vector(6)) - a;
  const Vec3d to = Vec3d(p) - a;
  Vec3d n = cross(ab, ac);
  double height = dot(to, n);  // times |n|, like all heights here
  if (height < 0) n = -n, height = -height;
  const double edges = length(ab) * length(ac), size = length(n);
  // Double knows the side, and the direction to better than float.
  if (!(height > 0x1p-48 * length(to) * edges && size > 0x1p-26 * edges)) return false;
  const double least = light.least_height(p, n);
  return least > 0 || height + least > hit_bound(record, p) * size;
}

}  // namespace

bool surely_behind_horizon(const Record& record, const LightHull& light, Vec3f p) {
  switch (record.kind) {
    case ShapeKind::sphere: return behind_sphere(record, light, p);
    case ShapeKind::cone: return behind_cone(record, light, p);
    case ShapeKind::ring: return behind_ring(record, light, p);
    case ShapeKind::triangle: break;
  }
  return behind_triangle(record, light, p);
}

}  // namespace penumbra
