// SPDX-License-Identifier: MIT
#include "penumbra/geometry/polygon.h"

#include <cmath>
#include <cstdint>
#include <utility>

#include "penumbra/geometry/polygon_ears.h"

namespace penumbra {
namespace {

/// Drops the coordinate along which the polygon's normal is longest; the two others are ordered so
/// that the polygon runs counter-clockwise.
std::vector<PlanePoint> projected(std::span<const Vec3f> corners, Vec3d normal) {
  const Vec3d size(std::abs(normal.x), std::abs(normal.y), std::abs(normal.z));
  const int drop = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  int right = (drop + 1) % 3, up = (drop + 2) % 3;
  if (normal[drop] < 0) std::swap(right, up);
  std::vector<PlanePoint> points;
  points.reserve(corners.size());
  for (const Vec3f& c : corners) points.push_back({c[right], c[up]});
  return points;
}

/// Indices of the corners that differ from the one before them.
std::vector<std::uint32_t> without_repeats(std::span<const Vec3f> corners) {
  std::vector<std::uint32_t> ring;
  ring.reserve(corners.size());
  for (std::uint32_t i = 0; i < corners.size(); ++i)
    if (ring.empty() || !(corners[i] == corners[ring.back()])) ring.push_back(i);
  while (ring.size() > 1 && corners[ring.back()] == corners[ring.front()]) ring.pop_back();
  return ring;
}

/// All corners turn left and the fan around the first one opens only once.
bool is_strictly_convex(std::span<const PlanePoint> points, std::span<const std::uint32_t> ring) {
  const std::size_t n = ring.size();
  const auto at = [&](std::size_t i) { return points[ring[i % n]]; };
  for (std::size_t i = 0; i < n; ++i)
    if (!(twice_area(at(i), at(i + 1), at(i + 2)) > 0)) return false;
  for (std::size_t i = 1; i + 1 < n; ++i)
    if (!(twice_area(at(0), at(i), at(i + 1)) > 0)) return false;
  return true;
}

std::vector<Triangle> fan(std::span<const std::uint32_t> ring) {
  std::vector<Triangle> triangles;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i)
    triangles.push_back({ring[0], ring[i], ring[i + 1]});
  return triangles;
}

}  // namespace

Vec3d polygon_normal(std::span<const Vec3f> corners) {
  // Newell's sum, relative to the first corner, so that polygons far from the origin keep digits.
  Vec3d sum;
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    const Vec3d first(corners[0]);
    sum += cross(Vec3d(corners[i]) - first, Vec3d(corners[i + 1]) - first);
  }
  return sum;
}

std::vector<Triangle> triangulate(std::span<const Vec3f> corners) {
  const std::vector<std::uint32_t> ring = without_repeats(corners);
  if (ring.size() <= 3) return fan(ring);
  const Vec3d normal = polygon_normal(corners);
  // Nothing encloses an area, or a corner is not finite: no plane to look at it in.
  if (!is_finite(normal) || normal == Vec3d{}) return fan(ring);
  const std::vector<PlanePoint> points = projected(corners, normal);
  return is_strictly_convex(points, ring) ? fan(ring) : clip_ears(points, ring);
}

}  // namespace penumbra
