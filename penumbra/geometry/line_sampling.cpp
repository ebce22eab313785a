// SPDX-License-Identifier: MIT
#include "penumbra/geometry/line_sampling.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "penumbra/geometry/replace_samples.h"

namespace penumbra {
namespace {

/// sin(x angle) / angle.
double scaled_sine(double x, double angle) { return angle > 0 ? std::sin(x * angle) / angle : x; }

/// Where on the line the direction u of the way through its angle meets it, from 0 to 1: by the law
/// of sines in the triangles with p, whose ratio has its limit where the angle vanishes.
double place_at(const SeenLine& seen, double u) {
  const double before = seen.near_length * scaled_sine(u, seen.angle);
  const double after = seen.far_length * scaled_sine(1 - u, seen.angle);
  return before / (before + after);
}

}  // namespace

SeenLine seen_from(const LineLight& light, Vec3f p) {
  SeenLine seen;
  seen.center = Vec3d(light.center) - Vec3d(p);
  seen.half = Vec3d(light.half);
  const Vec3d a = seen.center - seen.half, b = seen.center + seen.half;
  seen.near_length = length(a), seen.far_length = length(b);
  // Not a x b: no digits cancel where the line is short.
  seen.angle = std::atan2(2 * length(cross(seen.center, seen.half)), dot(a, b));
  return seen;
}

double mean_cosine(const SeenLine& seen, Vec3d n) {
  // So small that all its directions are one.
  if (!(seen.angle > 1e-9)) return std::max(0.0, dot(n, normalize(seen.center)));
  // At the angle t from the near end n·ω is proportional to cos(t - top).
  const Vec3d start = normalize(seen.center - seen.half);
  const Vec3d across = normalize(seen.half - start * dot(seen.half, start));
  const double along_start = dot(n, start), along_across = dot(n, across);
  constexpr double quarter = 0.5 * std::numbers::pi;
  double top = std::atan2(along_across, along_start);
  if (top < -quarter) top += 4 * quarter;
  const double from = std::max(0.0, top - quarter), to = std::min(seen.angle, top + quarter);
  if (!(from < to)) return 0;
  const double integral = 2 * std::hypot(along_start, along_across) * std::sin(0.5 * (to - from)) *
                          std::cos(0.5 * (from + to) - top);
  return std::clamp(integral / seen.angle, 0.0, 1.0);
}

double mean_inverse_square(const SeenLine& seen) {
  const double product = seen.near_length * seen.far_length;
  const double sine = 2 * length(cross(seen.center, seen.half)) / product;
  return (sine > 0 ? seen.angle / sine : 1) / product;
}

void sample_line(const LineLight& light, Vec3f p, SampleArrays samples) {
  const SeenLine seen = seen_from(light, p);
  const bool is_on_it = contains(light, p);
  replace_samples(samples, [&](float u, float) {
    const double place = is_on_it ? u : place_at(seen, u);
    return Vec3f(seen.center + seen.half * (2 * std::clamp(place, 0.0, 1.0) - 1));
  });
}

}  // namespace penumbra
