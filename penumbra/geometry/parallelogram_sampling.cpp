// SPDX-License-Identifier: MIT
// C. Urena, M. Fajardo, A. King, An Area-Preserving Parametrization for Spherical Rectangles, EGSR
// 2013.
#include "penumbra/geometry/parallelogram_sampling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "penumbra/geometry/least_solid_angle.h"
#include "penumbra/geometry/parallelogram.h"
#include "penumbra/geometry/replace_samples.h"
#include "penumbra/geometry/spherical_triangle.h"

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
  replace_samples(to, [&](double u, double v) {
    const bool is_first = u < share;
    const double within = is_first ? u / share : (u - share) / (1 - share);
    const Vec3d direction = direction_in(triangles[is_first ? 0 : 1], within, v);
    // Back to the plane, and by its own coordinates onto the light, so that rounding cannot leave
    // it.
    const Vec3d offset = direction * (dot(seen.center, n) / dot(direction, n)) - seen.center;
    const float a = static_cast<float>(std::clamp(dot(offset, for_a), -1.0, 1.0));
    const float b = static_cast<float>(std::clamp(dot(offset, for_b), -1.0, 1.0));
    return area.center + (area.u * a + area.v * b);
  });
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
