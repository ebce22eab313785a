// SPDX-License-Identifier: MIT
#include "penumbra/scene/cut_triangles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

#include "penumbra/geometry/box.h"

namespace penumbra {
namespace {

constexpr double tolerance = 1e-5;

/// The same from either end.
Vec3f crossing(Vec3f a, Vec3f b, double height_a, double height_b) {
  if (std::tie(b.x, b.y, b.z) < std::tie(a.x, a.y, a.z))
    std::swap(a, b), std::swap(height_a, height_b);
  const double s = height_a / (height_a - height_b);
  return Vec3f(Vec3d(a) + (Vec3d(b) - Vec3d(a)) * s);
}

/// What of a triangle is on one side, as a fan.
void add_side(const GlowingTriangle& t, const std::array<double, 3>& height, double side,
              std::vector<GlowingTriangle>& to) {
  std::vector<Vec3f> ring;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    if (height[i] * side >= 0) ring.push_back(t[i]);
    if (height[i] * height[j] < 0) ring.push_back(crossing(t[i], t[j], height[i], height[j]));
  }
  for (std::size_t i = 2; i < ring.size(); ++i) {
    const GlowingTriangle part{ring[0], ring[i - 1], ring[i]};
    if (area_of(part) > 0) to.push_back(part);
  }
}

}  // namespace

Halves cut(std::span<const GlowingTriangle> triangles, const HalfSpace& plane) {
  Box box;
  for (const GlowingTriangle& t : triangles)
    for (const Vec3f p : t) box.add(p);
  const double slack = tolerance * length(Vec3d(box.hi) - Vec3d(box.lo));
  Halves halves;
  for (const GlowingTriangle& t : triangles) {
    std::array<double, 3> height;
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double h = dot(plane.normal, Vec3d(t[i])) - plane.offset;
      sum += h;
      height[i] = std::abs(h) <= slack ? 0 : h;
    }
    const auto [low, high] = std::minmax({height[0], height[1], height[2]});
    if (low < 0 && high > 0) {
      add_side(t, height, -1, halves.below);
      add_side(t, height, 1, halves.above);
    } else {
      (sum > 0 ? halves.above : halves.below).push_back(t);
    }
  }
  return halves;
}

}  // namespace penumbra
