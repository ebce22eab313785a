// SPDX-License-Identifier: MIT
#include "penumbra/shadow/record_hull.h"

#include <algorithm>

#include "penumbra/shadow/light_hull.h"

namespace penumbra {

namespace {

/// Largest |coordinate - p| of the box of a disk around a unit normal.
double farthest_of_disk(Vec3d center, Vec3d normal, double radius, Vec3d p) {
  const Vec3d d = center - p;
  const auto along = [&](double distance, double n) {
    return std::abs(distance) + radius * std::sqrt(std::max(0.0, 1 - n * n));
  };
  return std::max({along(d.x, normal.x), along(d.y, normal.y), along(d.z, normal.z)});
}

double farthest_of_corners(const Record& triangle, Vec3d p) {
  return std::max({max_abs(Vec3d(triangle.vector(0)) - p), max_abs(Vec3d(triangle.vector(3)) - p),
                   max_abs(Vec3d(triangle.vector(6)) - p)});
}

/// The bound in units of the reach, which is that coordinate.
struct Bound {
  double ulps, reach;
};

Bound bound_of(const Record& record, Vec3d p) {
  const Vec3d first(record.vector(0));
  switch (record.kind) {
    case ShapeKind::sphere: return {16, max_abs(first - p) + record.number[3]};
    case ShapeKind::ring:
      return {16, farthest_of_disk(first, Vec3d(record.vector(3)), record.number[6], p)};
    case ShapeKind::cone: {
      const Vec3d axis(record.vector(3)), apex = first + axis * double(record.number[6]);
      return {32, std::max(farthest_of_disk(first, axis, record.number[7], p),
                           farthest_of_disk(apex, axis, record.number[8], p))};
    }
    case ShapeKind::triangle: break;
  }
  return {64, farthest_of_corners(record, p)};
}

}  // namespace

double hit_bound(const Record& record, Vec3f p) {
  const Bound bound = bound_of(record, Vec3d(p));
  double sum = 0;  // maxima and minima may lose what is no number, sums don't
  for (float number : record.number) sum += number;
  return bound.ulps * 0x1p-24 * bound.reach + underflow_bound + 0 * sum;
}

}  // namespace penumbra
