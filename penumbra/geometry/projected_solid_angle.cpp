// SPDX-License-Identifier: MIT
#include "penumbra/geometry/projected_solid_angle.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace penumbra {
namespace {

/// Angle that the edge subtends, along the normal of the plane through it and p.
Vec3d edge_vector(Vec3d a, Vec3d b) {
  const Vec3d across = cross(a, b - a);  // not b: no digits cancel where the edge is short
  const double sine = length(across);
  return sine > 0 ? across * (std::atan2(sine, dot(a, b)) / sine) : Vec3d{};
}

/// x for t = 0, without a jump towards it.
double scaled_asinh(double t, double x) { return t > 1e-9 ? std::asinh(t * x) / t : x; }
double scaled_asin(double t, double x) {
  return t > 1e-9 ? std::asin(std::clamp(t * x, -1.0, 1.0)) / t : x;
}

/// A point of the rim, as a direction, and the integral of direction x d direction up to it from
/// some other. With the direction as in SeenDisk, c = sqrt(cos_a² cos² chi + cos_b² sin² chi), and
/// t = sqrt(cos_b² - cos_a²), the integrand is d chi times
///   x: -cos_a² sin_b cos chi / c, so that x sums up to -cos_a² sin_b / t · asinh(t sin chi /
///   cos_a) y: -cos_b² sin_a sin chi / c, so that y sums up to  cos_b² sin_a / t · asin(t cos chi /
///   cos_b) z: sin_a sin_b.
struct RimPoint {
  Vec3d direction, sum;
};

/// psi is the angle around the ellipse that the cone cuts out of a plane z = 1. The angle chi has
/// cos_b tan chi = cos_a tan psi and follows psi through all turns.
RimPoint rim_point(const SeenDisk& seen, double psi) {
  const double sine = std::sin(psi), cosine = std::cos(psi), ratio = seen.cos_a / seen.cos_b;
  const double chi =
      psi + std::atan2((ratio - 1) * sine * cosine, cosine * cosine + ratio * sine * sine);
  const double s = std::sin(chi), c = std::cos(chi);
  // t / cos_b, which is sqrt(1 - ratio²) without the cancellation.
  const double t = (seen.farthest - seen.nearest) / (seen.farthest + seen.nearest);
  return {{seen.sin_a * c, seen.sin_b * s, std::hypot(seen.cos_a * c, seen.cos_b * s)},
          {-seen.cos_a * seen.sin_b * scaled_asinh(t / ratio, s),
           seen.cos_b * seen.sin_a * scaled_asin(t, c), seen.sin_a * seen.sin_b * chi}};
}

}  // namespace

double projected_solid_angle(std::span<const Vec3d> corners, Vec3d n) {
  Vec3d sum, leaving, entering;  // the horizon cuts a convex outline twice or not at all
  bool is_cut = false;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3d a = corners[i], b = corners[(i + 1) % corners.size()];
    const double a_height = dot(n, a), b_height = dot(n, b);
    if (a_height >= 0 && b_height >= 0) {
      sum += edge_vector(a, b);
    } else if (a_height >= 0 || b_height >= 0) {
      const Vec3d cut = a + (b - a) * (a_height / (a_height - b_height));
      is_cut = true;
      if (a_height >= 0)
        leaving = cut, sum += edge_vector(a, cut);
      else
        entering = cut, sum += edge_vector(cut, b);
    }
  }
  if (is_cut) sum += edge_vector(leaving, entering);
  // The side that p is on decides the sign.
  return 0.5 * std::abs(dot(n, sum));
}

double projected_solid_angle(const SeenDisk& seen, Vec3d normal) {
  const Vec3d n(dot(normal, seen.x), dot(normal, seen.y), dot(normal, seen.z));
  // The rim's height over the horizon is in proportion to level + along_x cos psi + along_y sin
  // psi.
  const double level = n.z * seen.cos_a * seen.cos_b;
  const double along_x = n.x * seen.sin_a * seen.cos_b, along_y = n.y * seen.sin_b * seen.cos_a;
  const double swing = std::hypot(along_x, along_y);
  // Projected along z the directions fill an ellipse.
  if (level >= swing) return std::numbers::pi * seen.sin_a * seen.sin_b * n.z;
  if (!(-level < swing)) return 0;
  const double top = std::atan2(along_y, along_x);
  const double reach = std::acos(std::clamp(-level / swing, -1.0, 1.0));
  const RimPoint from = rim_point(seen, top - reach), to = rim_point(seen, top + reach);
  // Back along the horizon.
  const Vec3d sum = to.sum - from.sum + edge_vector(to.direction, from.direction);
  return std::max(0.0, 0.5 * dot(n, sum));
}

}  // namespace penumbra
