// SPDX-License-Identifier: MIT
// What of a surface lies under a square of its texture.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "penumbra/geometry/vec.h"

namespace penumbra {

/// A point of a texture, in texels from the upper left corner, y downwards, and the point of the
/// surface that has it there.
struct TexelPoint {
  double x = 0, y = 0;
  Vec3d position;
};

/// A triangle of a surface in its texture.
using TexelTriangle = std::array<TexelPoint, 3>;

/// The square [x, x + edge] x [y, y + edge] of a texture.
struct TexelSquare {
  double x = 0, y = 0, edge = 1;
};

/// What a triangle and a square have in common: a convex polygon.
class Footprint {
 public:
  Footprint(const TexelTriangle& triangle, const TexelSquare& square);

  /// In order around it, turned as the triangle is; their positions are in the triangle, to what
  /// double can say.
  std::span<const TexelPoint> corners() const { return {corner_.data(), count_}; }
  bool is_empty() const { return count_ < 3; }

 private:
  /// Seven, were coordinates exact. Where rounding bends the outline, an edge may cut it often: of
  /// n corners i are kept and at most 2 min(i, n - i) new, so four edges make of 3 at most 4, 6,
  /// 9, 13.
  static constexpr std::size_t most_corners = 13;
  std::array<TexelPoint, most_corners> corner_;
  std::size_t count_ = 3;
};

/// Of a triangle in its texture, in texels; never negative.
double texel_area(const TexelPoint& a, const TexelPoint& b, const TexelPoint& c);
double texel_area(const Footprint& footprint);

/// Whether a triangle and a rectangle have a point in common; in doubt, true.
bool may_meet(const TexelTriangle& triangle, double x_lo, double x_hi, double y_lo, double y_hi);

/// Whether the point is in the triangle, farther than rounding goes from its edges.
bool is_inside(const TexelTriangle& triangle, double x, double y);

}  // namespace penumbra
