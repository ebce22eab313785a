// SPDX-License-Identifier: MIT
// C. Urena, M. Fajardo, A. King, An Area-Preserving Parametrization for Spherical Rectangles, EGSR
// 2013; J. Arvo, Stratified Sampling of Spherical Triangles, SIGGRAPH 1995.
#include "penumbra/geometry/parallelogram_sampling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "penumbra/geometry/parallelogram.h"

namespace penumbra {
namespace {

AreaSampling by_area(const SeenParallelogram& seen) {
  return {Vec3f(seen.center), Vec3f(seen.u), Vec3f(seen.v)};
}

/// Perpendicular to what float edges can express.
bool is_rectangle(const SeenParallelogram& seen) {
  constexpr double rounding = 1e-6;
  return std::abs(dot(seen.u, seen.v)) <= rounding * length(seen.u) * length(seen.v);
}

/// Inner angle of the spherical rectangle at a corner (x, y), one of x and y with its sign changed
/// for the corners at x0: that between the planes through p and the two edges there. By its
/// tangent, since a cosine near 1 says little.
double inner_angle(double x, double y, double z) {
  return std::atan2(z * std::sqrt(x * x + y * y + z * z), x * y);
}

RectangleSampling rectangle_sampling(const SeenParallelogram& seen, double angle) {
  const double u_length = length(seen.u), v_length = length(seen.v);
  const Vec3d x_axis = seen.u / u_length, y_axis = seen.v / v_length;
  const double x = dot(seen.center, x_axis), y = dot(seen.center, y_axis);
  RectangleSampling r;
  r.area = by_area(seen);
  r.x0 = x - u_length, r.x1 = x + u_length;
  r.y0 = y - v_length, r.y1 = y + v_length;
  r.z0 = std::abs(dot(seen.center, normalize(cross(x_axis, y_axis))));
  const double y0_z = std::hypot(r.y0, r.z0), y1_z = std::hypot(r.y1, r.z0);
  r.b0 = -r.y0 / y0_z;
  r.b1 = r.y1 / y1_z;
  r.one_minus_b0_squared = (r.z0 / y0_z) * (r.z0 / y0_z);
  r.k = 2 * std::numbers::pi - inner_angle(r.x0, r.y1, r.z0) - inner_angle(-r.x0, r.y0, r.z0);
  r.solid_angle = angle;
  return r;
}

/// What Arvo's method needs of a spherical triangle with unit corners a, b, c.
struct SphericalTriangle {
  double solid_angle = 0;
  double sine = 0, cosine = 0, angle = 0;  // at a
  double cos_ab = 0;
  Vec3d a, toward_c, b;  // toward_c: unit, perpendicular to a, in the plane of a and c
};

SphericalTriangle spherical_triangle(Vec3d a, Vec3d b, Vec3d c, double solid_angle) {
  SphericalTriangle t;
  t.solid_angle = solid_angle;
  t.a = normalize(a), t.b = normalize(b);
  // Edges instead of corners: their cross products lose no digits where the triangle is small.
  const Vec3d across_ab = cross(t.a, b - a), across_ac = cross(t.a, c - a);
  t.toward_c = normalize(cross(across_ac, t.a));
  t.angle = std::atan2(length(cross(across_ab, across_ac)), dot(across_ab, across_ac));
  t.sine = std::sin(t.angle), t.cosine = std::cos(t.angle);
  t.cos_ab = dot(t.a, t.b);
  return t;
}

/// Arvo's algorithm: the sub-triangle a b c' has u of the area; v goes along the arc from b to c'.
Vec3d direction_in(const SphericalTriangle& tri, double u, double v) {
  const double phi = u * tri.solid_angle - tri.angle;
  const double s = std::sin(phi), t = std::cos(phi);
  const double p = t - tri.cosine, q = s + tri.sine * tri.cos_ab;
  const double below = (q * s + p * t) * tri.sine;
  const double cos_ac =
      below == 0 ? 1 : std::clamp(((q * t - p * s) * tri.cosine - q) / below, -1.0, 1.0);
  const Vec3d c = tri.a * cos_ac + tri.toward_c * std::sqrt((1 - cos_ac) * (1 + cos_ac));
  const Vec3d across = c - tri.b * dot(c, tri.b);
  const double h = v * 0.5 * length_squared(c - tri.b);  // 1 - cos of the arc from b
  return tri.b * (1 - h) + normalize(across) * std::sqrt(std::max(0.0, h * (2 - h)));
}

void sample_skew(const SeenParallelogram& seen, std::array<double, 2> angles, SampleArrays to) {
  const std::array<Vec3d, 4> corner = seen.corners();
  const std::array<SphericalTriangle, 2> triangles = {
      spherical_triangle(corner[1], corner[0], corner[2], angles[0]),
      spherical_triangle(corner[3], corner[0], corner[2], angles[1])};
  const double share = angles[0] / (angles[0] + angles[1]);
  const Vec3d n = cross(seen.u, seen.v);
  const Vec3d for_a = cross(seen.v, n) / length_squared(n);
  const Vec3d for_b = cross(n, seen.u) / length_squared(n);
  const AreaSampling area = by_area(seen);
  double last_u = -1, last_v = -1;
  for (std::size_t i = 0; i < to.count; ++i) {
    const double u = to.x[i], v = to.y[i];
    if (u == last_u && v == last_v) {  // padding
      to.x[i] = to.x[i - 1], to.y[i] = to.y[i - 1], to.z[i] = to.z[i - 1];
      continue;
    }
    last_u = u, last_v = v;
    const bool is_first = u < share;
    const double within = is_first ? u / share : (u - share) / (1 - share);
    const Vec3d direction = direction_in(triangles[is_first ? 0 : 1], within, v);
    // Back to the plane, and by its own coordinates onto the light, so that rounding cannot leave
    // it.
    const Vec3d offset = direction * (dot(seen.center, n) / dot(direction, n)) - seen.center;
    const float a = static_cast<float>(std::clamp(dot(offset, for_a), -1.0, 1.0));
    const float b = static_cast<float>(std::clamp(dot(offset, for_b), -1.0, 1.0));
    const Vec3f sample = area.center + (area.u * a + area.v * b);
    to.x[i] = sample.x, to.y[i] = sample.y, to.z[i] = sample.z;
  }
}

}  // namespace

void sample_parallelogram(const ParallelogramLight& light, Vec3f p, SampleArrays samples) {
  const SeenParallelogram seen = seen_from(light, p);
  const std::array<double, 2> angles = triangle_solid_angles(seen);
  const double angle = angles[0] + angles[1];
  // NaN goes by area too.
  if (!(angle > least_solid_angle) || contains(light, p))
    sample_area(by_area(seen), samples);
  else if (is_rectangle(seen))
    sample_rectangle(rectangle_sampling(seen, angle), samples);
  else
    sample_skew(seen, angles, samples);
}

}  // namespace penumbra
