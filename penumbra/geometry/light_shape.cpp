// SPDX-License-Identifier: MIT
#include "penumbra/geometry/light_shape.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "penumbra/geometry/parallelogram.h"

namespace penumbra {
namespace {

/// Box around `middle` with these half extents, proof against the rounding of the sums.
Box box_around(Vec3d middle, Vec3d half) {
  const Vec3d size = max(middle, -middle) + half;
  const Vec3d grown = half + size * (2 * std::numeric_limits<double>::epsilon());
  return outward(middle - grown, middle + grown);
}

/// What float cannot tell of a distance between p and something of this size.
double float_doubt(Vec3f p, double size) {
  return (max_abs(Vec3d(p)) + size) * std::numeric_limits<float>::epsilon();
}

Vec3d center_of(const PointLight& light) { return Vec3d(light.center); }
Vec3d center_of(const BallLight& light) { return Vec3d(light.center); }
Vec3d center_of(const ParallelogramLight& light) { return Vec3d(light.center); }

Vec3d support_of(const PointLight& light, Vec3d) { return center_of(light); }

Vec3d support_of(const BallLight& light, Vec3d direction) {
  return center_of(light) + normalize(direction) * static_cast<double>(light.radius);
}

Vec3d support_of(const ParallelogramLight& light, Vec3d direction) {
  const Vec3d u(light.u), v(light.v);
  return center_of(light) + (dot(u, direction) < 0 ? -u : u) + (dot(v, direction) < 0 ? -v : v);
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

// Comparisons are written so that NaN means inside.
bool holds(const PointLight&, Vec3f) { return false; }
bool holds(const SunLight&, Vec3f) { return false; }

bool holds(const BallLight& light, Vec3f p) {
  const double distance = length(center_of(light) - Vec3d(p));
  return !(distance > light.radius + float_doubt(p, light.radius));
}

bool holds(const ParallelogramLight& light, Vec3f p) {
  const Vec3d u(light.u), v(light.v), w = Vec3d(p) - center_of(light);
  const Vec3d n = cross(u, v);
  const double doubt = float_doubt(p, length(u) + length(v)), area = length(n);
  // w = a u + b v + z n / |n|; a unit of a (of b) moves p by |n| / |v| (by |n| / |u|) off the edge.
  const double a = dot(cross(w, v), n) / (area * area), b = dot(cross(u, w), n) / (area * area);
  const double z = dot(w, n) / area;
  return !(std::abs(z) > doubt) && !((std::abs(a) - 1) * area > doubt * length(v)) &&
         !((std::abs(b) - 1) * area > doubt * length(u));
}

double angle_of(const PointLight&, Vec3f) { return 0; }

double angle_of(const BallLight& light, Vec3f p) {
  if (holds(light, p)) return 4 * std::numbers::pi;
  const double distance = length(center_of(light) - Vec3d(p)), r = light.radius;
  const double sine = r / distance;
  const double cosine = std::sqrt((distance - r) * (distance + r)) / distance;
  return 2 * std::numbers::pi * sine * sine / (1 + cosine);
}

double angle_of(const ParallelogramLight& light, Vec3f p) {
  return holds(light, p) ? 2 * std::numbers::pi : solid_angle(seen_from(light, p));
}

double angle_of(const SunLight& light, Vec3f) {
  const double s = std::sin(0.5 * light.half_angle_rad);
  return 4 * std::numbers::pi * s * s;
}

}  // namespace

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

bool contains(const LightShape& light, Vec3f p) {
  return std::visit([&](const auto& shape) { return holds(shape, p); }, light);
}

double solid_angle(const LightShape& light, Vec3f p) {
  return std::visit([&](const auto& shape) { return angle_of(shape, p); }, light);
}

}  // namespace penumbra
