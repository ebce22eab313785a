// SPDX-License-Identifier: MIT
#include "penumbra/geometry/planar_hull.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace penumbra {
namespace {

std::vector<PlanePoint> circle(int corners) {
  std::vector<PlanePoint> ring;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    ring.push_back({std::cos(angle), std::sin(angle)});
  }
  return ring;
}

TEST(PlanarHull, has_corners_only_where_the_outline_turns) {
  const std::vector<PlanePoint> ring =
      planar_hull({{0, 0}, {1, 0}, {2, 0}, {2, 2}, {1, 1}, {0, 2}, {0, 1}, {2, 0}});
  const std::vector<PlanePoint> square{{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  EXPECT_EQ(ring, square);
  EXPECT_EQ(area(ring), 4);
}

TEST(PlanarHull, does_not_depend_on_the_order_of_points) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  std::vector<PlanePoint> points(100);
  for (PlanePoint& p : points) p = {normal(random), normal(random)};
  const std::vector<PlanePoint> ring = planar_hull(points);
  for (int i = 0; i < 10; ++i) {
    std::shuffle(points.begin(), points.end(), random);
    EXPECT_EQ(planar_hull(points), ring);
  }
  for (const PlanePoint p : points)
    for (std::size_t i = 0; i < ring.size(); ++i)
      EXPECT_GE(twice_area(ring[i], ring[(i + 1) % ring.size()], p), 0);
}

TEST(PlanarHull, of_points_in_a_row_has_no_area) {
  EXPECT_LT(planar_hull({{0, 0}, {1, 1}, {2, 2}, {3, 3}}).size(), 3u);
  EXPECT_EQ(area(planar_hull({{1, 1}, {1, 1}})), 0);
}

TEST(FewerCorners, keep_the_area) {
  const std::vector<PlanePoint> ring = fewer_corners(circle(100), 16, 0);
  EXPECT_EQ(ring.size(), 16u);
  EXPECT_NEAR(area(ring), area(circle(100)), 1e-12);
}

TEST(FewerCorners, drop_what_does_not_stand_out) {
  std::vector<PlanePoint> ring{{0, 0}, {1, -1e-9}, {2, 0}, {2, 2}, {0, 2}};
  const std::vector<PlanePoint> square{{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  EXPECT_EQ(fewer_corners(ring, 10, 1e-6), square);
  EXPECT_EQ(fewer_corners(ring, 10, 0), ring);
}

}  // namespace
}  // namespace penumbra
