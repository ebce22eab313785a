// SPDX-License-Identifier: MIT
#include "penumbra/geometry/seen_disk.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace penumbra {

SeenDisk seen_from(const DiskLight& light, Vec3f p) {
  SeenDisk seen;
  seen.center = Vec3d(light.center) - Vec3d(p);
  seen.radius = light.radius;
  seen.normal = normalize(Vec3d(light.normal));
  const double along = dot(seen.center, seen.normal);
  if (along < 0) seen.normal = -seen.normal;
  const Vec3d to_center = seen.center - seen.normal * std::abs(along);
  seen.height = std::abs(along);
  seen.aside = length(to_center);
  // Straight above the centre any direction will do.
  const Frame<double> frame = frame_around(seen.normal);
  const bool is_aside = seen.aside > 1e-12 * seen.height;
  seen.inward =
      is_aside ? normalize(to_center - seen.normal * dot(to_center, seen.normal)) : frame.u;

  const double r = seen.radius, h = seen.height, l = seen.aside;
  const double d1 = seen.nearest = std::hypot(l - r, h), d2 = seen.farthest = std::hypot(l + r, h);
  // The two rays to the rim in the plane of symmetry enclose 2b, and the axis halves that angle:
  // cos 2b = (h² + l² - r²) / (d1 d2), sin 2b = 2 r h / (d1 d2).
  const double product = d1 * d2, excess = h * h + (l - r) * (l + r);
  const double smaller = excess > 0 ? 2 * (r * h) * (r * h) / (product * (product + excess))
                                    : 2 * (r * h) * (r * h) / (product * (product - excess));
  const double larger = (product + std::abs(excess)) / (2 * product);
  seen.cos_b = std::sqrt(excess > 0 ? larger : smaller);
  seen.sin_b = std::sqrt(excess > 0 ? smaller : larger);
  // By the theorem on the bisector it meets the disk at l - 4 l r² / (d1 + d2)² and has the length
  // 2 d1 d2 cos b / (d1 + d2) there; the chord across gives the other half angle.
  const double sum = d1 + d2;
  seen.sin_a = std::min(1.0, 2 * r / sum);
  seen.cos_a = seen.cos_b * std::min(1.0, 2 * std::sqrt(product) / sum);
  const double foot = l * (4 * product * seen.cos_b * seen.cos_b / (sum * sum));
  const double slant = std::hypot(foot, h);
  seen.z = (seen.inward * foot + seen.normal * h) / slant;
  seen.y = (seen.inward * h - seen.normal * foot) / slant;
  seen.x = cross(seen.inward, seen.normal);
  return seen;
}

double solid_angle(const SeenDisk& seen) {
  if (!(seen.height > 0)) return 0;
  // The trapezoid rule over a quarter of a period, which converges geometrically once tan(chi) =
  // sqrt(ratio) tan(xi) has spread the bend that c has where p is near the rim.
  const double ratio =
      2 * std::sqrt(seen.nearest) * std::sqrt(seen.farthest) / (seen.nearest + seen.farthest);
  const int steps = 4 + static_cast<int>(std::min(1e3, std::ceil(9 / std::sqrt(ratio))));
  const double b2 = seen.cos_b * seen.cos_b * ratio;
  double sum = 0;
  for (int i = 0; i <= steps; ++i) {
    const double xi = 0.5 * std::numbers::pi * i / steps;
    const double sine = std::sin(xi), cosine = std::cos(xi);
    const double s2 = sine * sine, c2 = cosine * cosine, stretch = c2 + ratio * s2;
    const double c = std::sqrt(b2 * (ratio * c2 + s2) / stretch);
    sum += (i % steps == 0 ? 0.5 : 1) / (stretch * (1 + c));
  }
  return 2 * std::numbers::pi / steps * std::sqrt(ratio) * seen.sin_a * seen.sin_b * sum;
}

}  // namespace penumbra
