// SPDX-License-Identifier: MIT
#include "penumbra/scene/silhouette.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "penumbra/geometry/polygon_ears.h"
#include "penumbra/geometry/reduced_hull.h"

namespace penumbra {
namespace {

constexpr std::size_t directions = 9;
constexpr int cells = 24;  ///< along each side of the picture

using Corners = std::array<PlanePoint, 3>;

/// A picture of 24 x 24 points that the hull just fits in.
class Silhouette {
 public:
  Silhouette(const MeshLight& hull, Vec3d direction)
      : frame_(frame_around(direction)), origin_(hull.corners[0]) {
    for (const Vec3f corner : hull.corners) {
      const PlanePoint p = flat(corner);
      low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
      high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y)};
    }
  }

  double area() const { return (high_.x - low_.x) * (high_.y - low_.y); }

  void add(const GlowingTriangle& triangle) {
    Corners t;
    for (std::size_t i = 0; i < 3; ++i) {
      const PlanePoint p = flat(triangle[i]);
      t[i] = {(p.x - low_.x) / (high_.x - low_.x) * cells,
              (p.y - low_.y) / (high_.y - low_.y) * cells};
    }
    const auto [bottom, top] = std::minmax({t[0].y, t[1].y, t[2].y});
    for (int y = first_after(bottom); y < cells && y + 0.5 <= top; ++y) {
      double left = std::numeric_limits<double>::infinity(), right = -left;
      for (std::size_t i = 0; i < 3; ++i) {
        const PlanePoint a = t[i], b = t[(i + 1) % 3];
        if ((a.y <= y + 0.5) == (b.y <= y + 0.5)) continue;
        const double x = a.x + (b.x - a.x) * ((y + 0.5 - a.y) / (b.y - a.y));
        left = std::min(left, x), right = std::max(right, x);
      }
      const int begin = first_after(left), end = first_after(right);
      if (begin < end) rows_[static_cast<std::size_t>(y)] |= (1u << end) - (1u << begin);
    }
  }

  int filled() const {
    int sum = 0;
    for (const std::uint32_t row : rows_) sum += std::popcount(row);
    return sum;
  }

 private:
  PlanePoint flat(Vec3f p) const {
    const Vec3d q = Vec3d(p) - origin_;
    return {dot(q, frame_.u), dot(q, frame_.v)};
  }

  /// The first point of a row that is not before x, at most their number; 0 for what is no number.
  static int first_after(double x) {
    return x > 0 ? static_cast<int>(std::min(std::ceil(x - 0.5), 1.0 * cells)) : 0;
  }

  Frame<double> frame_;
  Vec3d origin_;
  PlanePoint low_{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  PlanePoint high_{-std::numeric_limits<double>::infinity(),
                   -std::numeric_limits<double>::infinity()};
  std::array<std::uint32_t, cells> rows_{};  ///< a bit a point
};

}  // namespace

double empty_part(std::span<const GlowingTriangle> triangles, const MeshLight& hull, Vec3d axis) {
  double empty = 0, all = 0;
  for (const Vec3d direction : spread_directions(directions)) {
    Silhouette of_hull(hull, direction), of_surface(hull, direction);
    for (const Triangle& t : hull.triangles)
      of_hull.add({hull.corners[t[0]], hull.corners[t[1]], hull.corners[t[2]]});
    for (const GlowingTriangle& t : triangles) of_surface.add(t);
    const double weight = of_hull.area() * (axis == Vec3d{} ? 1 : std::abs(dot(axis, direction)));
    empty += weight * std::max(0, of_hull.filled() - of_surface.filled());
    all += weight * of_hull.filled();
  }
  return all > 0 ? empty / all : 0;
}

}  // namespace penumbra
