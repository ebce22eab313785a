// SPDX-License-Identifier: MIT
// The radial map of Guillén et al. 2017 (see seen_disk.h), in another parameter: in chi the solid
// angle has a density between 1/2 and 1, so that a short table inverts its integral, and the
// distance from the axis has a closed form without a cancellation.
#include "penumbra/geometry/disk_sampling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "penumbra/geometry/least_solid_angle.h"
#include "penumbra/geometry/replace_samples.h"
#include "penumbra/geometry/seen_disk.h"

namespace penumbra {
namespace {

/// A place in the unit disk, areas in proportion (P. Shirley, K. Chiu, A Low Distortion Map Between
/// Disk and Square, Journal of Graphics Tools 1997).
struct Polar {
  double radius_squared;
  double quarter;         ///< angle from the x axis in units of a quarter turn, in [0, 1]
  double x_sign, y_sign;  ///< which quarter
};

Polar polar(float u, float v) {
  const double a = 2.0 * u - 1, b = 2.0 * v - 1;
  const double wide = std::abs(a), high = std::abs(b), major = std::max(wide, high);
  const double part = major > 0 ? 0.5 * std::min(wide, high) / major : 0;
  return {major * major, wide > high ? part : 1 - part, std::copysign(1, a), std::copysign(1, b)};
}

/// c of SeenDisk.
double rim_cosine(const SeenDisk& seen, double cos_chi, double sin_chi) {
  const double a = seen.cos_a * cos_chi, b = seen.cos_b * sin_chi;
  return std::sqrt(a * a + b * b);
}

/// chi by the share of a quarter's solid angle: cubic through the ends of intervals that grow
/// towards pi/2, since c bends at 0 where p is near the rim.
class QuarterTable {
 public:
  explicit QuarterTable(const SeenDisk& seen) : seen_(seen) {
    const double bent = seen.cos_b - seen.cos_a;
    intervals_ = bent < 1e-3                   ? 2
                 : bent < 0.05                 ? 4
                 : 2 * seen.cos_a > seen.cos_b ? 8
                                               : most_intervals;
    const double bend = std::asinh(seen.cos_b / std::max(seen.cos_a, 1e-6 * seen.cos_b));
    ends_[0] = {0, 0, slope(0)};
    for (int i = 1; i <= intervals_; ++i) {
      const double step = static_cast<double>(i) / intervals_;
      const double chi = 0.5 * std::numbers::pi * std::sinh(bend * step) / std::sinh(bend);
      ends_[i] = {chi, ends_[i - 1].sum + integral(ends_[i - 1].chi, chi), slope(chi)};
    }
  }

  double chi(double share) const {
    const double sum = share * ends_[intervals_].sum;
    int i = 0;
    for (int half = most_intervals / 2; half > 0; half /= 2)
      if (i + half < intervals_ && !(sum < ends_[i + half].sum)) i += half;
    const End &a = ends_[i], &b = ends_[i + 1];
    const double width = b.sum - a.sum, t = (sum - a.sum) / width, s = 1 - t;
    return s * s * ((1 + 2 * t) * a.chi + t * width * a.slope) +
           t * t * ((1 + 2 * s) * b.chi - s * width * b.slope);
  }

 private:
  struct End {
    double chi, sum;
    double slope;  ///< d chi / d sum
  };
  static constexpr int most_intervals = 16;

  double slope(double chi) const { return 1 + rim_cosine(seen_, std::cos(chi), std::sin(chi)); }

  /// Of 1 / (1 + c), by Gauss's rule of three points.
  double integral(double from, double to) const {
    const double middle = 0.5 * (from + to), size = to - from;
    const double reach = size * 0.38729833462074168852;  // sqrt(3/5) / 2
    return size / 18 * (5 / slope(middle - reach) + 8 / slope(middle) + 5 / slope(middle + reach));
  }

  const SeenDisk& seen_;
  int intervals_;
  std::array<End, most_intervals + 1> ends_;
};

/// Components along x, y and z of a unit direction: with m the place's radius_squared, the cosine
/// to the axis goes from 1 at m = 0 to c at m = 1 in proportion to m.
Vec3d direction_at(const Polar& place, const SeenDisk& seen, const QuarterTable& table) {
  const double chi = table.chi(place.quarter), cosine = std::cos(chi), sine = std::sin(chi);
  const double c = rim_cosine(seen, cosine, sine), m = place.radius_squared;
  const double k = m * (1 - c), across = std::sqrt(m * (2 - k) / (1 + c));
  return {place.x_sign * across * seen.sin_a * cosine, place.y_sign * across * seen.sin_b * sine,
          1 - k};
}

/// From the disk's centre, along x and `inward`.
struct InPlane {
  double x, inward;
};

/// Onto the disk, whatever rounding did; NaN goes to the centre.
Vec3f on_disk(const SeenDisk& seen, InPlane place) {
  const double square = place.x * place.x + place.inward * place.inward;
  if (!std::isfinite(square)) return Vec3f(seen.center);
  const double limit = seen.radius * seen.radius;
  const double scale = square > limit ? std::sqrt(limit / square) : 1;
  return Vec3f(seen.center + (seen.x * (place.x * scale) + seen.inward * (place.inward * scale)));
}

InPlane along(Vec3d direction, const SeenDisk& seen) {
  const double z_inward = dot(seen.z, seen.inward), z_normal = dot(seen.z, seen.normal);
  const double up = direction.z * z_normal - direction.y * z_inward;
  const double t = seen.height / up;
  return {t * direction.x, t * (direction.z * z_inward + direction.y * z_normal) - seen.aside};
}

InPlane by_area(const Polar& place, double radius) {
  const double angle = 0.5 * std::numbers::pi * place.quarter;
  const double r = radius * std::sqrt(place.radius_squared);
  return {place.x_sign * r * std::cos(angle), place.y_sign * r * std::sin(angle)};
}

}  // namespace

void sample_disk(const DiskLight& light, Vec3f p, SampleArrays samples) {
  const SeenDisk seen = seen_from(light, p);
  const double angle = std::numbers::pi * seen.sin_a * seen.sin_b;  // or up to twice as much
  // NaN goes by area too.
  if (!(angle > least_solid_angle) || contains(light, p))
    return replace_samples(samples, [&](float u, float v) {
      return on_disk(seen, by_area(polar(u, v), seen.radius));
    });
  const QuarterTable table(seen);
  replace_samples(samples, [&](float u, float v) {
    return on_disk(seen, along(direction_at(polar(u, v), seen, table), seen));
  });
}

}  // namespace penumbra
