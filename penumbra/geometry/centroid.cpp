// SPDX-License-Identifier: MIT
#include "penumbra/geometry/centroid.h"

#include <cmath>

#include "penumbra/geometry/polygon.h"

namespace penumbra {
namespace {

/// Everything is relative to the first corner, so that what is far from the origin keeps digits.
struct Weighted {
  Vec3d sum;
  double weight = 0;
  void add(Vec3d middle, double of_it) { sum += middle * of_it, weight += of_it; }
};

Vec3f middle_of(std::span<const Vec3f> corners, const Weighted& parts) {
  if (corners.empty()) return {};
  const Vec3d first(corners[0]);
  const Vec3d middle = parts.sum / parts.weight;
  if (parts.weight > 0 && is_finite(middle)) return Vec3f(first + middle);
  Vec3d sum;
  for (const Vec3f corner : corners) sum += Vec3d(corner) - first;
  return Vec3f(first + sum / static_cast<double>(corners.size()));
}

}  // namespace

Vec3f area_centroid(std::span<const Vec3f> corners) {
  const Vec3d n = normalize(polygon_normal(corners));
  Weighted parts;
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    const Vec3d a = Vec3d(corners[i]) - Vec3d(corners[0]);
    const Vec3d b = Vec3d(corners[i + 1]) - Vec3d(corners[0]);
    parts.add((a + b) / 3.0, dot(cross(a, b), n));
  }
  return middle_of(corners, parts);
}

Vec3f volume_centroid(std::span<const Vec3f> corners, std::span<const Triangle> triangles) {
  Weighted parts;
  for (const Triangle& t : triangles) {
    const Vec3d a = Vec3d(corners[t[0]]) - Vec3d(corners[0]);
    const Vec3d b = Vec3d(corners[t[1]]) - Vec3d(corners[0]);
    const Vec3d c = Vec3d(corners[t[2]]) - Vec3d(corners[0]);
    parts.add((a + b + c) / 4.0, dot(a, cross(b, c)));
  }
  return middle_of(corners, parts);
}

double six_volumes(std::span<const Vec3f> corners, std::span<const Triangle> triangles) {
  double sum = 0;
  for (const Triangle& t : triangles) {
    const Vec3d a = Vec3d(corners[t[0]]) - Vec3d(corners[0]);
    const Vec3d b = Vec3d(corners[t[1]]) - Vec3d(corners[0]);
    const Vec3d c = Vec3d(corners[t[2]]) - Vec3d(corners[0]);
    sum += dot(a, cross(b, c));
  }
  return sum;
}

}  // namespace penumbra
