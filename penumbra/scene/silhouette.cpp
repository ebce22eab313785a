// SPDX-License-Identifier: MIT
#include "penumbra/scene/silhouette.h"

#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>
#include <cstddef>
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
    const auto [left, right] = std::minmax({t[0].x, t[1].x, t[2].x});
    const auto [bottom, top] = std::minmax({t[0].y, t[1].y, t[2].y});
    for (int y = first_after(bottom); y < cells && y + 0.5 <= top; ++y)
      for (int x = first_after(left); x < cells && x + 0.5 <= right; ++x)
        if (holds(t, {x + 0.5, y + 0.5})) filled_.set(static_cast<std::size_t>(y * cells + x));
  }

  std::size_t filled() const { return filled_.count(); }

 private:
  PlanePoint flat(Vec3f p) const {
    const Vec3d q = Vec3d(p) - origin_;
    return {dot(q, frame_.u), dot(q, frame_.v)};
  }

  /// The first point of a row that is not before x; 0 for what is no number.
  static int first_after(double x) {
    return x > 0 ? static_cast<int>(std::min(std::ceil(x - 0.5), 1.0 * cells)) : 0;
  }

  static bool holds(const Corners& t, PlanePoint p) {
    const double a = twice_area(t[0], t[1], p), b = twice_area(t[1], t[2], p),
                 c = twice_area(t[2], t[0], p);
    return (a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0);
  }

  Frame<double> frame_;
  Vec3d origin_;
  PlanePoint low_{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  PlanePoint high_{-std::numeric_limits<double>::infinity(),
                   -std::numeric_limits<double>::infinity()};
  std::bitset<cells * cells> filled_;
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
    const auto hull_count = static_cast<double>(of_hull.filled());
    const auto surface_count = static_cast<double>(of_surface.filled());
    empty += weight * std::max(0.0, hull_count - surface_count);
    all += weight * hull_count;
  }
  return all > 0 ? empty / all : 0;
}

}  // namespace penumbra
