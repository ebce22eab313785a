// SPDX-License-Identifier: MIT
#include "penumbra/geometry/surface_parity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

namespace penumbra {
namespace {

/// The axes are turned so that lines run along z.
Vec3d turned(Vec3f p, int axis) {
  const Vec3d q(p);
  return {q[(axis + 1) % 3], q[(axis + 2) % 3], q[axis]};
}
Vec3d turned_back(Vec3d p, int axis) {
  Vec3d q;
  q[(axis + 1) % 3] = p.x, q[(axis + 2) % 3] = p.y, q[axis] = p.z;
  return q;
}

/// Where a triangle meets the plane of this y: two points, or nothing. A function of the edge
/// alone, whatever triangle it is of.
struct Cut {
  Vec3d left, right;  // by x
  bool is_cut = false;
};

Cut cut(const std::array<Vec3d, 3>& corners, double y) {
  Cut result;
  int found = 0;
  for (int k = 0; k < 3; ++k) {
    Vec3d a = corners[k], b = corners[(k + 1) % 3];
    if ((a.y > y) == (b.y > y)) continue;
    if (b.y < a.y) std::swap(a, b);
    const double t = (y - a.y) / (b.y - a.y);
    (found++ == 0 ? result.left : result.right) = {a.x + (b.x - a.x) * t, y, a.z + (b.z - a.z) * t};
  }
  result.is_cut = found == 2;
  if (result.right.x < result.left.x) std::swap(result.left, result.right);
  return result;
}

/// z of the cut at x, which lies in [left, right); never beyond its ends.
double height(const Cut& c, double x) {
  const double t = std::clamp((x - c.left.x) / (c.right.x - c.left.x), 0.0, 1.0);
  return c.left.z + (c.right.z - c.left.z) * t;
}

std::array<Vec3d, 3> turned(const FlatTriangle& t, int axis) {
  return {turned(t.a, axis), turned(t.b, axis), turned(t.c, axis)};
}

/// Evenly spaced places across an interval, none at its ends.
struct Places {
  double first, step;
  std::size_t count;
  Places(double lo, double hi, std::size_t n)
      : first(lo + (hi - lo) / static_cast<double>(2 * n)),
        step((hi - lo) / static_cast<double>(n)),
        count(n) {}
  double operator[](std::size_t i) const { return first + static_cast<double>(i) * step; }
  /// The first place that is >= x: decided by the places themselves, so that equal x agree.
  std::size_t from(double x) const {
    if (!(step > 0)) return first >= x ? 0 : count;
    const double guess = std::clamp((x - first) / step, 0.0, static_cast<double>(count));
    auto i = static_cast<std::size_t>(guess);
    while (i > 0 && (*this)[i - 1] >= x) --i;
    while (i < count && (*this)[i] < x) ++i;
    return i;
  }
};

struct Crossing {
  std::size_t line;
  double z;
  bool operator<(const Crossing& c) const { return std::tie(line, z) < std::tie(c.line, c.z); }
};

std::vector<Crossing> crossings(std::span<const FlatTriangle> surface, int axis, const Places& xs,
                                const Places& ys) {
  std::vector<Crossing> result;
  for (const FlatTriangle& triangle : surface) {
    const std::array<Vec3d, 3> corners = turned(triangle, axis);
    const auto [low, high] = std::minmax({corners[0].y, corners[1].y, corners[2].y});
    for (std::size_t j = ys.from(low); j < ys.count && ys[j] <= high; ++j) {
      const Cut c = cut(corners, ys[j]);
      if (!c.is_cut) continue;
      for (std::size_t i = xs.from(c.left.x); i < xs.count && xs[i] < c.right.x; ++i)
        result.push_back({j * xs.count + i, height(c, xs[i])});
    }
  }
  std::sort(result.begin(), result.end());
  return result;
}

void add_points(std::span<const FlatTriangle> surface, const Box& box, int axis, std::size_t lines,
                std::vector<Vec3d>& points) {
  const Vec3d lo = turned(box.lo, axis), hi = turned(box.hi, axis);
  const Places xs(lo.x, hi.x, lines), ys(lo.y, hi.y, lines), zs(lo.z, hi.z, lines);
  const std::vector<Crossing> all = crossings(surface, axis, xs, ys);
  for (std::size_t i = 0; i + 1 < all.size(); i += 2) {
    const double x = xs[all[i].line % lines], y = ys[all[i].line / lines];
    const double enter = all[i].z, leave = all[i + 1].z;
    points.push_back(turned_back({x, y, enter * 0.5 + leave * 0.5}, axis));
    if (axis != 2) continue;
    for (std::size_t k = zs.from(enter); k < lines && zs[k] < leave; ++k)
      points.push_back(turned_back({x, y, zs[k]}, axis));
  }
}

}  // namespace

bool is_inside(std::span<const FlatTriangle> surface, Vec3d p) {
  bool inside = false;
  for (const FlatTriangle& triangle : surface) {
    const Cut c = cut(turned(triangle, 2), p.y);
    if (c.is_cut && c.left.x <= p.x && p.x < c.right.x && height(c, p.x) > p.z) inside = !inside;
  }
  return inside;
}

std::vector<Vec3d> inside_points(std::span<const FlatTriangle> surface, std::size_t lines) {
  std::vector<Vec3d> points;
  const Box box = bounds(surface);
  for (int axis = 0; axis < 3; ++axis) add_points(surface, box, axis, lines, points);
  return points;
}

}  // namespace penumbra
