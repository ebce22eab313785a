// SPDX-License-Identifier: MIT
#include "penumbra/geometry/triangle_tree.h"

#include <cmath>

namespace penumbra {
namespace {

/// The lowest 20 bits of x, two zeros between each.
std::uint64_t spread_bits(std::uint64_t x) {
  x = (x | x << 32) & 0x001f00000000ffffu;
  x = (x | x << 16) & 0x001f0000ff0000ffu;
  x = (x | x << 8) & 0x100f00f00f00f00fu;
  x = (x | x << 4) & 0x10c30c30c30c30c3u;
  return (x | x << 2) & 0x1249249249249249u;
}

/// Where the middle of the triangle lies along the curve through the box.
std::uint64_t place(const FlatTriangle& t, Vec3d lo, double scale) {
  const Vec3d middle = (Vec3d(t.a) + Vec3d(t.b) + Vec3d(t.c)) / 3.0;
  std::uint64_t code = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double x = std::clamp((middle[axis] - lo[axis]) * scale, 0.0, 1.0) * 0xfffff;
    code |= spread_bits(static_cast<std::uint64_t>(x)) << axis;
  }
  return code;
}

}  // namespace

TriangleTree::TriangleTree(std::span<const FlatTriangle> triangles) {
  if (triangles.empty()) return;
  const Box box = bounds(triangles);
  const double extent = max_abs(Vec3d(box.hi) - Vec3d(box.lo));
  std::vector<std::pair<std::uint64_t, std::uint32_t>> order;
  order.reserve(triangles.size());
  for (std::uint32_t i = 0; i < triangles.size(); ++i)
    order.emplace_back(place(triangles[i], Vec3d(box.lo), extent > 0 ? 1 / extent : 0), i);
  std::sort(order.begin(), order.end());
  triangles_.reserve(triangles.size());
  for (const auto& [code, i] : order) triangles_.push_back(triangles[i]);

  std::vector<Box> runs((triangles_.size() + fan - 1) / fan);
  for (std::size_t i = 0; i < triangles_.size(); ++i) runs[i / fan].add(bounds(triangles_[i]));
  levels_.push_back(std::move(runs));
  while (levels_.back().size() > 1) {
    const std::vector<Box>& below = levels_.back();
    std::vector<Box> above((below.size() + fan - 1) / fan);
    for (std::size_t i = 0; i < below.size(); ++i) above[i / fan].add(below[i]);
    levels_.push_back(std::move(above));
  }
}

TriangleTree::Children TriangleTree::children(const std::vector<Box>& boxes, std::size_t parent,
                                              Vec3d p) const {
  Children result;
  const std::size_t end = std::min(fan * parent + fan, boxes.size());
  for (std::size_t i = fan * parent; i < end; ++i) {
    const std::pair<double, std::size_t> child{distance_squared(boxes[i], p), i};
    std::size_t at = result.count++;
    for (; at > 0 && child < result.near[at - 1]; --at) result.near[at] = result.near[at - 1];
    result.near[at] = child;
  }
  return result;
}

NearestPoint TriangleTree::nearest(Vec3d p, double at_most, double slack) const {
  const double nearer = 1 / ((1 + slack) * (1 + slack));
  NearestPoint best{p, at_most * at_most};
  walk(
      p, [&](const Box& box) { return distance_squared(box, p) >= nearer * best.distance_squared; },
      [&](const FlatTriangle& triangle) {
        const NearestPoint other = nearest_point(triangle, p);
        if (other.distance_squared < best.distance_squared) best = other;
        return true;
      });
  return best;
}

}  // namespace penumbra
