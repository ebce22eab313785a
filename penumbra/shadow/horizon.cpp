// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>

#include "penumbra/shadow/offset.h"
#include "penumbra/shadow/record_hull.h"
#include "penumbra/shadow/sight.h"

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

/// The half-plane of a cone's axis and p, in which the solid is a quadrilateral: height above the
/// base and distance from the axis.
struct Profile {
  double h, r;                // of p
  double height, base, apex;  // of the quadrilateral: radii at 0 and at `height`
  double rise, slant;         // of its slanted side

  /// The plane of a cap or the side, and how high p is above it.
  struct Plane {
    double h, r, clearance;
  };
  std::array<Plane, 3> faces() const {
    return {{{-1, 0, -h},
             {1, 0, h - height},
             {-rise / slant, height / slant, ((r - base) * height - h * rise) / slant}}};
  }

  /// The plane that touches the solid where it is nearest to p, which is outside.
  Plane nearest() const {
    const double s = std::clamp((h * height + (r - base) * rise) / (slant * slant), 0.0, 1.0);
    const Vec3d way[3] = {{h, r - std::min(r, base), 0},
                          {h - height, r - std::min(r, apex), 0},
                          {h - s * height, r - base - s * rise, 0}};
    Vec3d least = way[0];
    for (Vec3d other : way)
      if (length_squared(other) < length_squared(least)) least = other;
    const double distance = length(least);
    return {least.x / distance, least.y / distance, distance};
  }
};

/// Next to a rim the nearest point's plane turns with p's rounding: the faces' own come first.
bool behind_cone(const Record& record, const LightHull& light, Vec3f p) {
  const ConeHull cone(record);
  const Vec3d to = Vec3d(p) - cone.base, radial = across(to, cone.axis);
  const double rise = cone.apex_radius - cone.base_radius;
  const Profile profile{dot(to, cone.axis),
                        dot(to, radial),
                        cone.height,
                        cone.base_radius,
                        cone.apex_radius,
                        rise,
                        std::sqrt(cone.height * cone.height + rise * rise)};
  const double bound = hit_bound(record, p);
  const auto is_behind = [&](const Profile::Plane& plane) {
    return plane.clearance > bound &&
           clears(plane.clearance, cone.axis * plane.h + radial * plane.r, bound, light, p);
  };
  bool is_outside = false;
  for (const Profile::Plane& face : profile.faces()) {
    if (is_behind(face)) return true;
    is_outside = is_outside || face.clearance > bound;
  }
  return is_outside && is_behind(profile.nearest());
}

bool behind_ring(const Record& ring, const LightHull& light, Vec3f p) {
  const DiskHull disk(ring);
  const double height = dot(Vec3d(p) - disk.center, disk.normal);
  const Vec3d n = height < 0 ? -disk.normal : disk.normal;
  return clears(std::abs(height), n, hit_bound(ring, p), light, p);
}

/// Points on a triangle are nearer to it than its hits may lie. But where float can't tell the side
/// of the plane that a ray starts from, the intersector finds the crossing in double: rays that
/// start above the plane by more than 8 ulp and go farther away from it are not hits. Others must
/// keep their distance.
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
  const double bound = hit_bound(record, p) * size;
  return (least > 0 && height > bound / 8) || height + least > bound;
}

}  // namespace

bool surely_behind_horizon(const Record& record, const LightHull& light, Vec3f p) {
  if (!is_in_range(record, light, p)) return false;
  switch (record.kind) {
    case ShapeKind::sphere: return behind_sphere(record, light, p);
    case ShapeKind::cone: return behind_cone(record, light, p);
    case ShapeKind::ring: return behind_ring(record, light, p);
    case ShapeKind::triangle: break;
  }
  return behind_triangle(record, light, p);
}

}  // namespace penumbra
