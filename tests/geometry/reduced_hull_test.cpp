// SPDX-License-Identifier: MIT
#include "penumbra/geometry/reduced_hull.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace penumbra {
namespace {

std::vector<Vec3f> on_ellipsoid(std::size_t count) {
  std::vector<Vec3f> points;
  for (const Vec3d d : spread_directions(count))
    points.emplace_back(Vec3f(Vec3d(3 * d.x, d.y, 2 * d.z)));
  return points;
}

TEST(ReducedHull, is_the_hull_where_it_has_few_corners) {
  std::vector<Vec3f> cube;
  for (int i = 0; i < 8; ++i)
    cube.emplace_back(static_cast<float>(i & 1), static_cast<float>(i >> 1 & 1),
                      static_cast<float>(i >> 2));
  cube.emplace_back(0.5f, 0.5f, 0.5f);
  const auto hull = reduced_hull(cube, 16);
  ASSERT_TRUE(hull);
  EXPECT_EQ(hull->corners.size(), 8u);
  EXPECT_DOUBLE_EQ(surface_area(*hull), 6);
}

TEST(ReducedHull, keeps_surface_and_form) {
  const std::vector<Vec3f> points = on_ellipsoid(1000);
  const double surface = surface_area(*reduced_hull(points, 1000));
  for (const std::size_t most : {16, 32, 64}) {
    const auto hull = reduced_hull(points, most);
    ASSERT_TRUE(hull);
    EXPECT_EQ(hull->corners.size(), most);
    EXPECT_NEAR(surface_area(*hull), surface, 1e-4 * surface);
    const double error = most == 16 ? 0.25 : most == 32 ? 0.12 : 0.06;
    for (const Vec3d direction : spread_directions(100)) {
      double is = -100, wanted = -100;
      for (const Vec3f p : hull->corners) is = std::max(is, dot(Vec3d(p), direction));
      for (const Vec3f p : points) wanted = std::max(wanted, dot(Vec3d(p), direction));
      EXPECT_NEAR(is, wanted, error * wanted);
    }
  }
}

TEST(ReducedHull, does_not_depend_on_the_order_of_points) {
  std::vector<Vec3f> points = on_ellipsoid(300);
  const auto hull = reduced_hull(points, 24);
  std::mt19937 random(1);
  for (int i = 0; i < 3; ++i) {
    std::shuffle(points.begin(), points.end(), random);
    points.push_back(points[0]);
    const auto again = reduced_hull(points, 24);
    EXPECT_EQ(again->corners, hull->corners);
    EXPECT_EQ(again->triangles, hull->triangles);
  }
}

TEST(ReducedHull, needs_a_volume) {
  EXPECT_FALSE(reduced_hull(std::vector<Vec3f>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, 16));
  EXPECT_FALSE(reduced_hull(std::vector<Vec3f>{{0, 0, 0}}, 16));
}

TEST(ExtremePoints, hold_the_farthest) {
  const std::vector<Vec3f> points = on_ellipsoid(500), few = extreme_points(points, 64);
  EXPECT_LE(few.size(), 64u);
  for (const Vec3d direction : spread_directions(64)) {
    double is = -100, wanted = -100;
    for (const Vec3f p : few) is = std::max(is, dot(Vec3d(p), direction));
    for (const Vec3f p : points) wanted = std::max(wanted, dot(Vec3d(p), direction));
    EXPECT_EQ(is, wanted);
  }
}

}  // namespace
}  // namespace penumbra
