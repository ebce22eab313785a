// SPDX-License-Identifier: MIT
// Polygons are clipped edge by edge: I. E. Sutherland, G. W. Hodgman, Reentrant Polygon Clipping,
// CACM 1974. Positions are mixed along the way, never extrapolated, so that they stay on the
// triangle however thin its texture is.
#include "penumbra/trace/footprint.h"

#include <algorithm>
#include <cmath>

namespace penumbra {
namespace {

TexelPoint mix(const TexelPoint& a, const TexelPoint& b, double t) {
  return {a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t, a.position * (1 - t) + b.position * t};
}

/// Twice the signed area.
double turn(const TexelPoint& a, const TexelPoint& b, double x, double y) {
  return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
}

}  // namespace

Footprint::Footprint(const TexelTriangle& triangle, const TexelSquare& square) {
  std::copy(triangle.begin(), triangle.end(), corner_.begin());
  // How far a point is inside of each of the square's edges.
  const auto clip = [this](auto depth) {
    std::array<TexelPoint, most_corners> kept;
    std::size_t kept_count = 0;
    const auto keep = [&](const TexelPoint& p) { kept[kept_count++] = p; };
    for (std::size_t i = 0; i < count_; ++i) {
      const TexelPoint &a = corner_[i], &b = corner_[(i + 1) % count_];
      const double at_a = depth(a), at_b = depth(b);
      if (at_a >= 0) keep(a);
      if ((at_a < 0) != (at_b < 0)) keep(mix(a, b, std::clamp(at_a / (at_a - at_b), 0.0, 1.0)));
    }
    corner_ = kept, count_ = kept_count;
  };
  const double right = square.x + square.edge, bottom = square.y + square.edge;
  clip([&](const TexelPoint& p) { return p.x - square.x; });
  clip([&](const TexelPoint& p) { return right - p.x; });
  clip([&](const TexelPoint& p) { return p.y - square.y; });
  clip([&](const TexelPoint& p) { return bottom - p.y; });
}

double texel_area(const TexelPoint& a, const TexelPoint& b, const TexelPoint& c) {
  return std::abs(turn(a, b, c.x, c.y)) / 2;
}

double texel_area(const Footprint& footprint) {
  const std::span<const TexelPoint> corner = footprint.corners();
  double sum = 0;
  for (std::size_t i = 2; i < corner.size(); ++i)
    sum += texel_area(corner[0], corner[i - 1], corner[i]);
  return sum;
}

bool may_meet(const TexelTriangle& triangle, double x_lo, double x_hi, double y_lo, double y_hi) {
  const auto [left, right] = std::minmax({triangle[0].x, triangle[1].x, triangle[2].x});
  const auto [top, bottom] = std::minmax({triangle[0].y, triangle[1].y, triangle[2].y});
  if (left > x_hi || right < x_lo || top > y_hi || bottom < y_lo) return false;
  const double way = turn(triangle[0], triangle[1], triangle[2].x, triangle[2].y) < 0 ? -1 : 1;
  for (std::size_t i = 0; i < 3; ++i) {
    const TexelPoint &a = triangle[i], &b = triangle[(i + 1) % 3];
    // The rectangle's corner that is farthest inwards of the edge.
    const double dx = way * (b.x - a.x), dy = way * (b.y - a.y);
    const double inwards =
        dx * ((dx > 0 ? y_hi : y_lo) - a.y) - dy * ((dy > 0 ? x_lo : x_hi) - a.x);
    const double size = std::abs(dx) + std::abs(dy);
    if (inwards < -1e-9 * size * (1 + std::abs(a.x) + std::abs(a.y))) return false;
  }
  return true;
}

bool is_inside(const TexelTriangle& triangle, double x, double y) {
  constexpr double margin = 1e-3;  // texels; coordinates come in float
  const double way = turn(triangle[0], triangle[1], triangle[2].x, triangle[2].y) < 0 ? -1 : 1;
  for (std::size_t i = 0; i < 3; ++i) {
    const TexelPoint &a = triangle[i], &b = triangle[(i + 1) % 3];
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    if (!(way * turn(a, b, x, y) > margin * length)) return false;
  }
  return true;
}

}  // namespace penumbra
