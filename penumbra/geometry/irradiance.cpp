// SPDX-License-Identifier: MIT
// Ball: the projected area of a cone of directions cut by the horizon, as in J. Snyder, Area Light
// Sources for Real-Time Graphics, 1996. The others: see projected_solid_angle.h.
#include "penumbra/geometry/irradiance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "penumbra/geometry/least_solid_angle.h"
#include "penumbra/geometry/line_sampling.h"
#include "penumbra/geometry/parallelogram.h"
#include "penumbra/geometry/polygon.h"
#include "penumbra/geometry/projected_solid_angle.h"
#include "penumbra/geometry/seen_disk.h"
#include "penumbra/geometry/seen_triangles.h"

namespace penumbra {
namespace {

/// atan(x) - x, to all digits where x is small.
double atan_minus_self(double x) {
  if (x > 0.1) return std::atan(x) - x;
  const double x2 = x * x;
  return x * x2 * (-1.0 / 3 + x2 * (1.0 / 5 + x2 * (-1.0 / 7 + x2 * (1.0 / 9 - x2 / 11))));
}

/// E / (pi sin²) for a cone with these sine and cosine (> 0) of its half angle, whose axis makes
/// the cosine `elevation` with the normal. Projected onto the surface the cone's rim is an ellipse
/// and the horizon a circle; where they cross, the areas of both segments add up to
///   elevation sin² acos(-elevation cot / sqrt(1 - elevation²)) - cos² x + atan(x),
/// x = sqrt(sin² - elevation²) / cos, times 1 / (pi sin²).
double cone_irradiance(double elevation, double sine, double cosine) {
  if (elevation >= sine) return std::min(elevation, 1.0);
  if (!(elevation > -sine)) return 0;
  const double x = std::sqrt((sine - elevation) * (sine + elevation)) / cosine;
  const double tilt = elevation / sine * cosine / std::sqrt((1 - elevation) * (1 + elevation));
  const double segment = elevation * std::acos(std::clamp(-tilt, -1.0, 1.0));
  return (segment + x + atan_minus_self(x) / (sine * sine)) * std::numbers::inv_pi;
}

double seen_by(const PointLight& light, Vec3f p, Vec3d n) {
  return std::max(0.0, dot(n, normalize(Vec3d(light.center) - Vec3d(p))));
}

double seen_by(const BallLight& light, Vec3f p, Vec3d n) {
  if (contains(light, p)) return 1;
  const Vec3d way = Vec3d(light.center) - Vec3d(p);
  const double distance = length(way), radius = light.radius;
  const double cosine = std::sqrt((distance - radius) * (distance + radius)) / distance;
  return cone_irradiance(dot(n, way) / distance, radius / distance, cosine);
}

double seen_by(const SunLight& sun, Vec3f, Vec3d n) {
  const double angle = sun.half_angle_rad;
  const double elevation = dot(n, normalize(Vec3d(sun.direction)));
  return cone_irradiance(elevation, std::sin(angle), std::cos(angle));
}

double seen_by(const ParallelogramLight& light, Vec3f p, Vec3d n) {
  const SeenParallelogram seen = seen_from(light, p);
  const double angle = solid_angle(seen);
  if (angle == 0) return 0;
  // So small that all its directions are one.
  if (angle < least_solid_angle) return std::max(0.0, dot(n, normalize(seen.center)));
  return std::min(1.0, projected_solid_angle(seen.corners(), n) / angle);
}

double seen_by(const DiskLight& light, Vec3f p, Vec3d n) {
  if (contains(light, p)) return 0;
  const SeenDisk seen = seen_from(light, p);
  const double angle = solid_angle(seen);
  if (angle == 0) return 0;
  if (angle < least_solid_angle) return std::max(0.0, dot(n, normalize(seen.center)));
  return std::clamp(projected_solid_angle(seen, n) / angle, 0.0, 1.0);
}

double seen_by(const LineLight& light, Vec3f p, Vec3d n) {
  return contains(light, p) ? 0 : mean_cosine(seen_from(light, p), n);
}

/// Of the triangles that `is_wanted` lets pass.
double seen_by_triangles(const auto& light, Vec3f p, Vec3d n, const auto& is_wanted) {
  double angle = 0, projected = 0;
  for (std::size_t i = 0; i < triangle_count(light); ++i) {
    const SeenTriangle seen = seen_triangle(light, i, p);
    if (!is_wanted(seen)) continue;
    angle += solid_angle(seen);
    projected += projected_solid_angle(seen.corners(), n);
  }
  if (angle == 0) return 0;
  if (angle < least_solid_angle)
    return std::max(0.0, dot(n, normalize(Vec3d(light.center) - Vec3d(p))));
  return std::min(1.0, projected / angle);
}

double seen_by(const PolygonLight& light, Vec3f p, Vec3d n) {
  return seen_by_triangles(light, p, n, [](const SeenTriangle&) { return true; });
}

double seen_by(const MeshLight& light, Vec3f p, Vec3d n) {
  if (contains(light, p)) return 0.5;
  return seen_by_triangles(light, p, n, [](const SeenTriangle& t) { return t.volume() < 0; });
}

double factor_of(const PointLight& light, Vec3f p) {
  const double square = length_squared(Vec3d(light.center) - Vec3d(p));
  return square > 0 ? 1 / square : 0;
}

double factor_of(const BallLight& light, Vec3f p) {
  const double distance = length(Vec3d(light.center) - Vec3d(p));
  const double clamped =
      std::max({distance, static_cast<double>(light.radius), std::numeric_limits<double>::min()});
  return 1 / (clamped * clamped);
}

double factor_of(const ParallelogramLight& light, Vec3f p) {
  const double area = 4 * length(cross(Vec3d(light.u), Vec3d(light.v)));
  return solid_angle(light, p) / area;
}

double factor_of(const DiskLight& light, Vec3f p) {
  const double r = light.radius;
  return solid_angle(light, p) / (std::numbers::pi * r * r);
}

double factor_of(const LineLight& light, Vec3f p) {
  return contains(light, p) ? 0 : mean_inverse_square(seen_from(light, p));
}

double factor_of(const PolygonLight& light, Vec3f p) {
  return solid_angle(light, p) / (0.5 * length(polygon_normal(light.corners)));
}

double factor_of(const MeshLight& light, Vec3f p) {
  double twice_surface = 0;
  for (std::size_t i = 0; i < triangle_count(light); ++i) {
    const SeenTriangle t = seen_triangle(light, i, p);
    twice_surface += length(cross(t.to_second, t.to_third));
  }
  return std::min(solid_angle(light, p), 2 * std::numbers::pi) / (twice_surface / 8);
}

double factor_of(const SunLight&, Vec3f) { return 1; }

}  // namespace

double irradiance(const LightShape& light, Vec3f p, Vec3f n) {
  return std::visit([&](const auto& shape) { return seen_by(shape, p, Vec3d(n)); }, light);
}

double inverse_square_factor(const LightShape& light, Vec3f p) {
  return std::visit([&](const auto& shape) { return factor_of(shape, p); }, light);
}

}  // namespace penumbra
