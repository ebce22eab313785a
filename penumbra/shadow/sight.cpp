// SPDX-License-Identifier: MIT
#include "penumbra/shadow/sight.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace penumbra {
namespace {

struct Turn {
  double cosine, sine;
};

/// Sixteenths of a turn.
std::array<Turn, 16> make_turns() {
  std::array<Turn, 16> turns;
  for (int k = 0; k < 16; ++k) {
    const double angle = std::numbers::pi * k / 8;
    turns[k] = {std::cos(angle), std::sin(angle)};
  }
  return turns;
}

/// Not below the largest distance along an axis from p to the record's box, whose corners are
/// rounded to float.
double reach_of(const Record& record, Vec3d p) {
  const Vec3d first(record.vector(0));
  const double to_first = max_abs(first - p), rounding = 0x1p-22 * max_abs(first);
  switch (record.kind) {
    case ShapeKind::sphere: return to_first + rounding + record.number[3];
    case ShapeKind::cone:
      return to_first + rounding + record.number[6] + std::max(record.number[7], record.number[8]);
    case ShapeKind::ring: return to_first + rounding + record.number[6];
    case ShapeKind::triangle: break;
  }
  return std::max(
      {to_first, max_abs(Vec3d(record.vector(3)) - p), max_abs(Vec3d(record.vector(6)) - p)});
}

}  // namespace

bool is_in_range(const Record& record, const LightHull& light, Vec3f p) {
  const double distance = length(light.center(p) - Vec3d(p)) + light.size();
  return light.is_sun() || distance < greatest_ratio * reach_of(record, Vec3d(p));
}

double intersector_margin(const Record& record, const LightHull& light, Vec3f p) {
  const double reach = reach_of(record, Vec3d(p));
  const double distance = length(light.center(p) - Vec3d(p)) + light.size();
  // The intersector multiplies three lengths, and divides a chord by the ray's length. NaN fails.
  const bool is_in_range =
      reach > 1e-9 && reach < 1e9 && distance < greatest_ratio * reach && distance > 1e-15;
  return is_in_range ? 0x1p-18 * reach : std::numeric_limits<double>::quiet_NaN();
}

std::array<Vec3d, 16> outline_of_ball(const LightShaft& shaft) {
  static const std::array<Turn, 16> turns = make_turns();
  const Vec3d to = shaft.c - shaft.p;
  const double distance = length(to), radius = shaft.light.size(), near = distance - radius;
  const double tangent = radius / std::sqrt(near * (distance + radius));
  const double outer = near * tangent / std::cos(std::numbers::pi / 16) * (1 + 1e-12);
  const Frame<double> frame = frame_around(to / distance);
  std::array<Vec3d, 16> ways;
  for (int k = 0; k < 16; ++k)
    ways[k] =
        frame.n * near + frame.u * (outer * turns[k].cosine) + frame.v * (outer * turns[k].sine);
  return ways;
}

}  // namespace penumbra
