// SPDX-License-Identifier: MIT
#include "penumbra/geometry/light_shape.h"

#include <cmath>
#include <limits>
#include <span>

namespace penumbra {
namespace {

/// Box around `middle` with these half extents, proof against the rounding of the sums.
Box box_around(Vec3d middle, Vec3d half) {
  const Vec3d size = max(middle, -middle) + half;
  const Vec3d grown = half + size * (2 * std::numeric_limits<double>::epsilon());
  return outward(middle - grown, middle + grown);
}

/// Of the centre too: rounding may have put it outside.
Box box_around(Vec3f center, std::span<const Vec3f> corners) {
  Box box{center, center};
  for (const Vec3f corner : corners) box.add(corner);
  return box;
}

Vec3d center_of(const auto& light) { return Vec3d(light.center); }

Vec3d support_of(const PointLight& light, Vec3d) { return center_of(light); }

Vec3d support_of(const BallLight& light, Vec3d direction) {
  return center_of(light) + normalize(direction) * static_cast<double>(light.radius);
}

Vec3d support_of(const ParallelogramLight& light, Vec3d direction) {
  const Vec3d u(light.u), v(light.v);
  return center_of(light) + (dot(u, direction) < 0 ? -u : u) + (dot(v, direction) < 0 ? -v : v);
}

Vec3d support_of(const DiskLight& light, Vec3d direction) {
  const Vec3d n = normalize(Vec3d(light.normal)), d = normalize(direction);
  // Where the direction is the normal's, what is left of it is noise, off the plane.
  const Vec3d across = normalize(d - n * dot(n, d));
  return center_of(light) + (across - n * dot(n, across)) * static_cast<double>(light.radius);
}

Vec3d support_of(const LineLight& light, Vec3d direction) {
  const Vec3d half(light.half);
  return center_of(light) + (dot(half, direction) < 0 ? -half : half);
}

Vec3d farthest(Vec3f center, std::span<const Vec3f> corners, Vec3d direction) {
  Vec3d best(center);
  double most = dot(best, direction);
  for (const Vec3f corner : corners) {
    const double along = dot(Vec3d(corner), direction);
    if (along > most) best = Vec3d(corner), most = along;
  }
  return best;
}

Vec3d support_of(const PolygonLight& light, Vec3d direction) {
  return farthest(light.center, light.corners, direction);
}

Vec3d support_of(const MeshLight& light, Vec3d direction) {
  return farthest(light.center, light.corners, direction);
}

Box bounds_of(const PointLight& light) { return {light.center, light.center}; }

Box bounds_of(const BallLight& light) {
  const double r = light.radius;
  return box_around(center_of(light), {r, r, r});
}

Box bounds_of(const ParallelogramLight& light) {
  const Vec3d u(light.u), v(light.v);
  return box_around(center_of(light), max(u, -u) + max(v, -v));
}

Box bounds_of(const DiskLight& light) {
  const Vec3d n = normalize(Vec3d(light.normal));
  const Vec3d half(std::hypot(n.y, n.z), std::hypot(n.z, n.x), std::hypot(n.x, n.y));
  return box_around(center_of(light), half * static_cast<double>(light.radius));
}

Box bounds_of(const LineLight& light) {
  const Vec3d half(light.half);
  return box_around(center_of(light), max(half, -half));
}

Box bounds_of(const PolygonLight& light) { return box_around(light.center, light.corners); }
Box bounds_of(const MeshLight& light) { return box_around(light.center, light.corners); }

std::vector<Vec3d> corners_of(const PointLight& light) { return {center_of(light)}; }

std::vector<Vec3d> corners_of(const ParallelogramLight& light) {
  const Vec3d c(light.center), u(light.u), v(light.v);
  return {c - u - v, c + u - v, c + u + v, c - u + v};
}

std::vector<Vec3d> corners_of(const LineLight& light) {
  const Vec3d c(light.center), half(light.half);
  return {c - half, c + half};
}

std::vector<Vec3d> in_double(std::span<const Vec3f> corners) {
  std::vector<Vec3d> result;
  for (const Vec3f corner : corners) result.emplace_back(corner);
  return result;
}

std::vector<Vec3d> corners_of(const PolygonLight& light) { return in_double(light.corners); }
std::vector<Vec3d> corners_of(const MeshLight& light) { return in_double(light.corners); }

std::vector<Vec3d> corners_of(const BallLight&) { return {}; }
std::vector<Vec3d> corners_of(const DiskLight&) { return {}; }
std::vector<Vec3d> corners_of(const SunLight&) { return {}; }

}  // namespace

bool is_point(const LightShape& light) {
  const auto* sun = std::get_if<SunLight>(&light);
  return std::holds_alternative<PointLight>(light) || (sun && sun->half_angle_rad == 0);
}

std::optional<Vec3f> center(const LightShape& light) {
  return std::visit(
      [](const auto& shape) -> std::optional<Vec3f> {
        if constexpr (requires { shape.center; }) return shape.center;
        return std::nullopt;
      },
      light);
}

Vec3f towards_center(const LightShape& light, Vec3f p) {
  if (const auto* sun = std::get_if<SunLight>(&light)) return sun->direction;
  return Vec3f(Vec3d(*center(light)) - Vec3d(p));
}

std::optional<Vec3d> support(const LightShape& light, Vec3d direction) {
  return std::visit(
      [&](const auto& shape) -> std::optional<Vec3d> {
        if constexpr (requires { shape.center; }) return support_of(shape, direction);
        return std::nullopt;
      },
      light);
}

std::optional<Box> bounds(const LightShape& light) {
  return std::visit(
      [](const auto& shape) -> std::optional<Box> {
        if constexpr (requires { shape.center; }) return bounds_of(shape);
        return std::nullopt;
      },
      light);
}

std::vector<Vec3d> corners(const LightShape& light) {
  return std::visit([](const auto& shape) { return corners_of(shape); }, light);
}

}  // namespace penumbra
