// SPDX-License-Identifier: MIT
#include "penumbra/geometry/reduced_hull.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>

#include "penumbra/geometry/centroid.h"
#include "penumbra/geometry/convex_hull.h"

namespace penumbra {
namespace {

/// Hulls of more points are taken of their extreme ones.
constexpr std::size_t most_points = 2000, thinned = 400;

std::vector<Vec3f> sorted_once(std::span<const Vec3f> points) {
  std::vector<Vec3f> sorted(points.begin(), points.end());
  std::sort(sorted.begin(), sorted.end(),
            [](Vec3f a, Vec3f b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); });
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  return sorted;
}

/// How far p is above the highest of the planes that it is above; not above 0 inside.
double height_over(std::span<const HalfSpace> planes, Vec3f p) {
  double height = -std::numeric_limits<double>::infinity();
  for (const HalfSpace& plane : planes)
    height = std::max(height, dot(plane.normal, Vec3d(p)) - plane.offset);
  return height;
}

void widen(MeshLight& hull, double factor) {
  const Vec3d center(hull.center);
  for (Vec3f& corner : hull.corners) corner = Vec3f(center + (Vec3d(corner) - center) * factor);
}

}  // namespace

std::vector<Vec3d> spread_directions(std::size_t count) {
  constexpr double golden_angle = std::numbers::pi * (3 - 2.2360679774997896964);
  std::vector<Vec3d> directions;
  for (std::size_t i = 0; i < count; ++i) {
    const double z = 1 - (2 * static_cast<double>(i) + 1) / static_cast<double>(count);
    const double r = std::sqrt(1 - z * z), angle = golden_angle * static_cast<double>(i);
    directions.emplace_back(r * std::cos(angle), r * std::sin(angle), z);
  }
  return directions;
}

std::vector<Vec3f> extreme_points(std::span<const Vec3f> points, std::size_t count) {
  if (points.size() <= count) return sorted_once(points);
  std::vector<Vec3f> chosen;
  for (const Vec3d direction : spread_directions(count)) {
    Vec3f best = points[0];
    double farthest = dot(Vec3d(best), direction);
    for (const Vec3f p : points)
      if (const double reach = dot(Vec3d(p), direction); reach > farthest)
        best = p, farthest = reach;
    chosen.push_back(best);
  }
  return sorted_once(chosen);
}

std::vector<HalfSpace> face_planes(const MeshLight& light) {
  std::vector<HalfSpace> planes;
  for (const Triangle& t : light.triangles) {
    const Vec3d a(light.corners[t[0]]), b(light.corners[t[1]]), c(light.corners[t[2]]);
    const Vec3d normal = normalize(cross(b - a, c - a));
    planes.push_back({normal, dot(normal, a)});
  }
  return planes;
}

double surface_area(const MeshLight& light) {
  double twice = 0;
  for (const Triangle& t : light.triangles) {
    const Vec3d a(light.corners[t[0]]), b(light.corners[t[1]]), c(light.corners[t[2]]);
    twice += length(cross(b - a, c - a));
  }
  return 0.5 * twice;
}

std::optional<MeshLight> reduced_hull(std::span<const Vec3f> points, std::size_t most) {
  const std::vector<Vec3f> few =
      points.size() > most_points ? extreme_points(points, thinned) : sorted_once(points);
  std::optional<MeshLight> full = convex_hull(few);
  if (!full || full->corners.size() <= most) return full;
  // The six extremes along the axes, or the first ones where these are in one plane.
  std::vector<Vec3f> chosen = extreme_points(full->corners, 6);
  std::optional<MeshLight> hull = convex_hull(chosen);
  for (std::size_t i = 0; !hull && i < full->corners.size(); ++i) {
    chosen.push_back(full->corners[i]);
    hull = convex_hull(chosen);
  }
  while (hull && chosen.size() < most) {
    const std::vector<HalfSpace> planes = face_planes(*hull);
    Vec3f best;
    double highest = 0;
    for (const Vec3f p : full->corners)
      if (const double height = height_over(planes, p); height > highest)
        best = p, highest = height;
    if (!(highest > 0)) break;
    chosen.push_back(best);
    hull = convex_hull(chosen);
  }
  if (!hull) return full;
  widen(*hull, std::sqrt(surface_area(*full) / surface_area(*hull)));
  return hull;
}

}  // namespace penumbra
