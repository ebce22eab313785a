// SPDX-License-Identifier: MIT
// Are two convex sets apart? A plane between them is the proof; where to look for one is found by
// E. Gilbert, D. Johnson, S. Keerthi, A Fast Procedure for Computing the Distance Between Complex
// Objects in Three-Dimensional Space, IEEE J. Robotics and Automation 4 (1988).
#pragma once

#include <concepts>
#include <limits>

#include "penumbra/geometry/vec.h"

namespace penumbra {

/// A compact convex set, known by its farthest point along any direction (of any length; along 0
/// some point of it).
template <typename T>
concept ConvexSet = requires(const T& set, Vec3d n) {
  { set.support(n) } -> std::convertible_to<Vec3d>;
};

/// At most four points; their hull is what is known so far of the set of all differences.
struct Simplex {
  Vec3d point[4];
  int count = 0;
};

/// Adds a point (to at most three), drops those that the hull's point nearest to the origin does
/// not need, and returns that nearest point: zero where the hull holds the origin.
Vec3d extend(Simplex& simplex, Vec3d point);

/// True only if a plane parts a from b by more than `margin` (>= 0, a length):
///   (1) proven with the support functions alone, whatever the search does, and with the rounding
///   of all that is computed here. What `support` itself loses to rounding belongs in the margin.
///   (2) For polytopes true wherever their distance exceeds the margin by 1e-9 of the sets'
///   coordinates; for curved sets, by 1e-4 of their size.
///   (3) NaN in the margin or the points gives false.
/// `hint_axis` points from b to a; one that parts them costs one evaluation.
template <ConvexSet A, ConvexSet B>
bool surely_apart(const A& a, const B& b, Vec3d hint_axis, double margin) {
  constexpr int most_steps = 32;
  constexpr double rounding = 0x1p-48, no_progress = 1e-13;
  Simplex differences;
  Vec3d axis = hint_axis;
  double square = std::numeric_limits<double>::infinity();
  for (int step = 0; step < most_steps; ++step) {
    const Vec3d x = a.support(-axis), y = b.support(axis), difference = x - y;
    const double gap = dot(axis, difference);
    if (gap > length(axis) * (margin + rounding * (max_abs(x) + max_abs(y)))) return true;
    // `axis` is a difference too, so that the distance is at most its length; where no other
    // is nearer along it, that is the distance.
    if (step > 0 && square - gap <= no_progress * square) return false;
    axis = extend(differences, difference);
    const double last = square;
    square = length_squared(axis);
    if (!(square > margin * margin && square < last)) return false;
  }
  return false;
}

}  // namespace penumbra
