// SPDX-License-Identifier: MIT
#include "penumbra/shadow/cover.h"

#include <algorithm>
#include <limits>

#include "penumbra/shadow/cover_flat.h"
#include "penumbra/shadow/cover_solid.h"

namespace penumbra {

namespace {

/// False where the segment from p to the light's centre misses the record: the cheap half of most
/// answers. Rounding doesn't matter, since proofs need more than it decides.
bool may_cover(const Record& record, Vec3d p, Vec3d way) {
  const Vec3d first = Vec3d(record.vector(0)) - p;
  switch (record.kind) {
    case ShapeKind::sphere: {
      const double along = std::clamp(dot(first, way) / length_squared(way), 0.0, 1.0);
      const double radius = record.number[3];
      return length_squared(first - way * along) < radius * radius;
    }
    case ShapeKind::cone: return true;  // begins with that test itself
    case ShapeKind::ring: {
      const Vec3d normal(record.vector(3));
      const double s = dot(normal, first) / dot(normal, way), radius = record.number[6];
      return s > 0 && s < 1 && length_squared(first - way * s) < radius * radius;
    }
    case ShapeKind::triangle: break;
  }
  const Vec3d second = Vec3d(record.vector(3)) - p, third = Vec3d(record.vector(6)) - p;
  const double a = dot(way, cross(first, second)), b = dot(way, cross(second, third)),
               c = dot(way, cross(third, first));
  return (a > 0 && b > 0 && c > 0) || (a < 0 && b < 0 && c < 0);
}

}  // namespace

bool surely_covers(const Record& record, const LightHull& light, Vec3f p) {
  if (!record.casts_shadow || !may_cover(record, Vec3d(p), light.center(p) - Vec3d(p)))
    return false;
  const Sight sight(light, p, intersector_margin(record, light, p));
  if (!(sight.margin + sight.doubt < std::numeric_limits<double>::infinity())) return false;
  switch (record.kind) {
    case ShapeKind::sphere: return sphere_covers(record, sight);
    case ShapeKind::cone: return cone_covers(record, sight);
    case ShapeKind::ring: return ring_covers(record, sight);
    case ShapeKind::triangle: break;
  }
  return triangle_covers(record, sight);
}

bool ball_covers(Vec3d center, double radius, const LightHull& light, Vec3f p, double margin) {
  return ball_hides(center, radius, Sight(light, p, margin));
}

}  // namespace penumbra
