// SPDX-License-Identifier: MIT
// Where along a line something holds: intervals of s, one for each constraint of a convex set.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "penumbra/geometry/vec.h"

namespace penumbra {

/// An interval of s; empty unless from <= to (NaN: empty).
struct Chord {
  double from = -std::numeric_limits<double>::infinity();
  double to = std::numeric_limits<double>::infinity();
  bool is_empty() const { return !(from <= to); }
};

inline constexpr Chord no_chord{1, 0};

inline Chord common(Chord a, Chord b) {
  if (a.is_empty() || b.is_empty()) return no_chord;
  return {std::max(a.from, b.from), std::min(a.to, b.to)};
}

/// Where value + s slope <= 0.
inline Chord chord_below(double value, double slope) {
  if (slope == 0) return value <= 0 ? Chord{} : no_chord;
  const double root = -value / slope;
  return slope > 0 ? Chord{.to = root} : Chord{.from = root};
}

/// Where |a + s b| <= radius + s growth: a line through a ball, a cylinder or one nappe of a cone.
/// Rounded: an answer that matters is to be checked at one of its points.
inline Chord chord_of_cone(Vec3d a, Vec3d b, double radius, double growth) {
  const double A = dot(b, b) - growth * growth, B = dot(a, b) - radius * growth,
               C = dot(a, a) - radius * radius;
  if (A == 0 && B == 0) return C <= 0 && radius >= 0 ? Chord{} : no_chord;
  const double discriminant = B * B - A * C;
  if (!(discriminant >= 0)) return no_chord;
  const double q = -(B + std::copysign(std::sqrt(discriminant), B));
  const double first = q / A, second = q != 0 ? C / q : 0;
  if (A > 0) {
    const Chord chord{std::min(first, second), std::max(first, second)};
    return radius + growth * (chord.from + chord.to) / 2 >= 0 ? chord : no_chord;
  }
  // The set opens faster than the line leaves its axis. Without A the first root is infinite.
  if (growth > 0) return {.from = A == 0 ? second : std::max(first, second)};
  return {.to = A == 0 ? second : std::min(first, second)};
}

}  // namespace penumbra
