// SPDX-License-Identifier: MIT
// Ball: the projected area of a cone of directions cut by the horizon, as in J. Snyder, Area Light
// Sources for Real-Time Graphics, 1996. Parallelogram: J. H. Lambert's sum over the edges of a
// polygon (Photometria, 1760), after cutting it at the horizon.
#include "penumbra/geometry/irradiance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "penumbra/geometry/parallelogram.h"
#include "penumbra/geometry/parallelogram_sampling.h"

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

/// As if all light came from the centre.
double seen_by(const auto& light, Vec3f p, Vec3d n) {
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

/// A polygon of at most five corners: what is left of a parallelogram above the horizon.
struct ClippedPolygon {
  std::array<Vec3d, 8> corners;
  int count = 0;
  void add(Vec3d corner) { corners[count++] = corner; }
};

ClippedPolygon above_horizon(const SeenParallelogram& seen, Vec3d n) {
  const std::array<Vec3d, 4> corners = seen.corners();
  ClippedPolygon result;
  for (int i = 0; i < 4; ++i) {
    const Vec3d a = corners[i], b = corners[(i + 1) % 4];
    const double a_height = dot(n, a), b_height = dot(n, b);
    if (a_height >= 0) result.add(a);
    if ((a_height >= 0) != (b_height >= 0))
      result.add(a + (b - a) * (a_height / (a_height - b_height)));
  }
  return result;
}

/// Angle that the edge subtends, along the normal of the plane through it and p.
Vec3d edge_vector(Vec3d a, Vec3d b) {
  const Vec3d across = cross(a, b - a);  // not b: no digits cancel where the edge is short
  const double sine = length(across);
  return sine > 0 ? across * (std::atan2(sine, dot(a, b)) / sine) : Vec3d{};
}

double seen_by(const ParallelogramLight& light, Vec3f p, Vec3d n) {
  const SeenParallelogram seen = seen_from(light, p);
  const double angle = solid_angle(seen);
  if (angle == 0) return 0;
  // So small that all its directions are one.
  if (angle < least_solid_angle) return std::max(0.0, dot(n, normalize(seen.center)));
  const ClippedPolygon polygon = above_horizon(seen, n);
  Vec3d sum;
  for (int i = 0; i < polygon.count; ++i)
    sum += edge_vector(polygon.corners[i], polygon.corners[(i + 1) % polygon.count]);
  // Which side p is on decides the sign; the light shines both ways.
  return std::min(1.0, 0.5 * std::abs(dot(n, sum)) / angle);
}

double factor_of(const auto& light, Vec3f p) {
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

double factor_of(const SunLight&, Vec3f) { return 1; }

}  // namespace

double irradiance(const LightShape& light, Vec3f p, Vec3f n) {
  return std::visit([&](const auto& shape) { return seen_by(shape, p, Vec3d(n)); }, light);
}

double inverse_square_factor(const LightShape& light, Vec3f p) {
  return std::visit([&](const auto& shape) { return factor_of(shape, p); }, light);
}

}  // namespace penumbra
