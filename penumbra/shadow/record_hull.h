// SPDX-License-Identifier: MIT
// The convex hull of a record's shape by its support mapping, and how far off it a hit may lie.
// Spheres are their centre and a radius around it: balls add to a margin, and what is left is a
// point.
#pragma once

#include "penumbra/geometry/vec.h"
#include "penumbra/kernel/record.h"
#include "penumbra/shadow/flat_hull.h"

#include <cmath>

namespace penumbra {

/// Unit vector along the part of n that is across the axis (a unit vector). Where n runs along the
/// axis that part is noise, of which nothing may stay along the axis: what is left is shorter then.
inline Vec3d across(Vec3d n, Vec3d axis) {
  const Vec3d part = n - axis * dot(n, axis);
  const double square = length_squared(part);
  if (!(square > 0)) return square == 0 ? Vec3d{} : part;  // NaN stays
  const Vec3d unit = part * (1 / std::sqrt(square));
  return unit - axis * dot(unit, axis);
}

/// Hull of a sphere but for its radius.
struct PointHull {
  Vec3d center;
  explicit PointHull(const Record& sphere) : center(sphere.vector(0)) {}
  Vec3d support(Vec3d) const { return center; }
};

/// A ring without its hole.
struct DiskHull {
  Vec3d center, normal;  // unit
  double radius;
  explicit DiskHull(const Record& ring)
      : center(ring.vector(0)), normal(normalize(Vec3d(ring.vector(3)))), radius(ring.number[6]) {}
  Vec3d support(Vec3d n) const { return center + across(n, normal) * radius; }
};

/// A cone with both caps, as the record gives it.
struct ConeHull {
  Vec3d base, axis, apex;  // axis: unit
  double height, base_radius, apex_radius;
  explicit ConeHull(const Record& cone)
      : base(cone.vector(0)),
        axis(normalize(Vec3d(cone.vector(3)))),
        apex(base + axis * double(cone.number[6])),
        height(cone.number[6]),
        base_radius(cone.number[7]),
        apex_radius(cone.number[8]) {}
  Vec3d support(Vec3d n) const {
    const Vec3d radial = across(n, axis);
    return dot(n, axis) * height + dot(n, radial) * (apex_radius - base_radius) > 0
               ? apex + radial * apex_radius
               : base + radial * base_radius;
  }
};

/// Calls f with the record's hull.
template <typename F>
auto with_hull(const Record& record, F&& f) {
  switch (record.kind) {
    case ShapeKind::sphere: return f(PointHull(record));
    case ShapeKind::cone: return f(ConeHull(record));
    case ShapeKind::ring: return f(DiskHull(record));
    case ShapeKind::triangle: break;
  }
  return f(FlatHull({record.vector(0), record.vector(3), record.vector(6)}));
}

/// Length within which hits of rays from p lie to the record's hull (intersect-inl.h, whose bounds
/// this states: ulps of the farthest coordinate of the shape's box from p). NaN where any number is
/// not finite.
double hit_bound(const Record& record, Vec3f p);

}  // namespace penumbra
