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

/// chi by the share of a quarter's solid angle: cubic through the ends of intervals that grow
/// towards pi/2, since c bends at 0 where p is near the rim.
class QuarterTable {
 public:
  explicit QuarterTable(const SeenDisk& seen) : seen_(seen) {
    intervals_ = seen.cos_b - seen.cos_a < 1e-3 ? 2 : most_intervals;
    const double bend = std::asinh(seen.cos_b / std::max(seen.cos_a, 1e-6 * seen.cos_b));
    ends_[0] = {0, 0, slope(0)};
    for (int i = 1; i <= intervals_; ++i) {
      const double step = static_cast<double>(i) / intervals_;
      const double chi = 0.5 * std::numbers::pi * std::sinh(bend * step) / std::sinh(bend);
      ends_[i] = {chi, ends_[i - 1].sum + integral(ends_[i - 1].chi, chi), slope(chi)};
    }
  }

  /// c of the chi at hand, which all else needs too.
  double cosine(double chi) const {
    return std::hypot(seen_.cos_a * std::cos(chi), seen_.cos_b * std::sin(chi));
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

  double slope(double chi) const { return 1 + cosine(chi); }

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
  const double chi = table.chi(place.quarter), c = table.cosine(chi), m = place.radius_squared;
  const double k = m * (1 - c), across = std::sqrt(m * (2 - k) / (1 + c));
  return {place.x_sign * across * seen.sin_a * std::cos(chi),
          place.y_sign * across * seen.sin_b * std::sin(chi), 1 - k};
}

/// From the disk's centre, along x and `inward`.
struct InPlane {
  double x, inward;
};

/// Onto the disk, whatever rounding did; NaN goes to the centre.
Vec3f on_disk(const SeenDisk& seen, InPlane place) {
  const double distance = std::hypot(place.x, place.inward);
  const double shrink = distance > seen.radius ? seen.radius / distance : 1;
  if (!std::isfinite(distance)) return Vec3f(seen.center);
  return Vec3f(seen.center + (seen.x * place.x + seen.inward * place.inward) * shrink);
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
