// SPDX-License-Identifier: MIT
#include "penumbra/geometry/polygon.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace penumbra {
namespace {

using Corners = std::vector<Vec3f>;

/// Twice the areas of the triangles, signed by their orientation against the polygon's.
struct Cover {
  double signed_area = 0, absolute_area = 0;
};

Cover cover(const Corners& corners, const std::vector<Triangle>& triangles) {
  const Vec3d normal = normalize(polygon_normal(corners));
  Cover result;
  for (const Triangle& t : triangles) {
    const Vec3d a(corners[t[0]]), b(corners[t[1]]), c(corners[t[2]]);
    const double area = dot(cross(b - a, c - a), normal);
    result.signed_area += area;
    result.absolute_area += std::abs(area);
  }
  return result;
}

/// n - 2 triangles of the polygon's orientation whose areas add up to its own cover it once.
void expect_covered(const Corners& corners) {
  const std::vector<Triangle> triangles = triangulate(corners);
  ASSERT_EQ(triangles.size(), corners.size() - 2);
  const double area = length(polygon_normal(corners));
  const Cover covered = cover(corners, triangles);
  EXPECT_NEAR(covered.signed_area, area, 1e-5 * area);
  EXPECT_NEAR(covered.absolute_area, area, 1e-5 * area);
}

/// Places points of the plane on a random plane of space.
Corners in_space(const std::vector<Vec3d>& flat, std::mt19937& random) {
  std::normal_distribution<double> normal;
  const auto f = frame_around(normalize(Vec3d(normal(random), normal(random), normal(random))));
  const Vec3d offset(normal(random), normal(random), normal(random));
  Corners corners;
  for (const Vec3d& p : flat) corners.push_back(Vec3f(f.u * p.x + f.v * p.y + offset));
  return corners;
}

TEST(Polygon, NormalIsTwiceTheArea) {
  const Corners square{{0, 0, 5}, {2, 0, 5}, {2, 2, 5}, {0, 2, 5}};
  EXPECT_EQ(polygon_normal(square), Vec3d(0, 0, 8));
  EXPECT_EQ(polygon_normal({}), Vec3d());
}

TEST(Polygon, ConvexOnesAreFanned) {
  const Corners square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  EXPECT_EQ(triangulate(square), (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));
}

TEST(Polygon, RandomStarsAreCoveredOnce) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit;
  for (int round = 0; round < 10'000; ++round) {
    const int n = 4 + static_cast<int>(unit(random) * 30);
    std::vector<Vec3d> flat;
    for (int i = 0; i < n; ++i) {
      const double angle = 2 * std::numbers::pi * i / n, r = 0.05 + unit(random);
      flat.push_back({r * std::cos(angle), r * std::sin(angle), 0});
    }
    expect_covered(in_space(flat, random));
    if (HasFailure()) FAIL() << "round " << round;
  }
}

TEST(Polygon, SpiralsAreCoveredOnce) {
  std::mt19937 random(2);
  for (int n : {5, 20, 200, 2000}) {
    std::vector<Vec3d> flat;
    for (int i = 0; i < 2 * n; ++i) {  // out along one arm, back along another inside it
      const double k = i < n ? i : 2 * n - 1 - i;
      const double angle = 0.3 * k, r = (i < n ? 1.0 : 0.9) * (1 + 0.2 * angle);
      flat.push_back({r * std::cos(angle), r * std::sin(angle), 0});
    }
    expect_covered(in_space(flat, random));
  }
}

TEST(Polygon, GearsAndCombsAreCoveredOnce) {
  std::mt19937 random(3);
  std::vector<Vec3d> gear, comb;
  for (int i = 0; i < 144; ++i) {
    const double angle = 2 * std::numbers::pi * i / 144, r = i / 2 % 2 ? 1 : 0.8;
    gear.push_back({r * std::cos(angle), r * std::sin(angle), 0});
  }
  for (int i = 0; i < 20'000; ++i) comb.push_back({i * 0.01, i % 2 ? 10.0 : 0.5, 0});
  comb.push_back({200, 0, 0});
  comb.push_back({0, 0, 0});
  expect_covered(in_space(gear, random));
  std::reverse(gear.begin(), gear.end());
  expect_covered(in_space(gear, random));
  expect_covered(in_space(comb, random));
}

TEST(Polygon, CornersOnEdgesGetTrianglesWithArea) {
  const Corners corners{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {3, 1, 0},
                        {3, 2, 0}, {1, 2, 0}, {0, 2, 0}, {0, 1, 0}};
  expect_covered(corners);
  for (const Triangle& t : triangulate(corners)) {
    const Corners triangle{corners[t[0]], corners[t[1]], corners[t[2]]};
    EXPECT_GT(length(polygon_normal(triangle)), 0);
  }
}

TEST(Polygon, HolesOnABridgeStayOpen) {
  // A square with two square holes, each reached over an edge that is walked twice.
  const Corners corners{{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}, {0, 0, 0}, {1, 1, 0},
                        {1, 3, 0}, {3, 3, 0}, {5, 5, 0}, {5, 7, 0}, {7, 7, 0}, {7, 5, 0},
                        {5, 5, 0}, {3, 3, 0}, {3, 1, 0}, {1, 1, 0}};
  expect_covered(corners);
}

TEST(Polygon, RepeatedCornersCountOnce) {
  const Corners corners{{0, 0, 0}, {0, 0, 0}, {2, 0, 0}, {1, 0.5f, 0}, {1, 0.5f, 0},
                        {2, 2, 0}, {0, 2, 0}, {0, 2, 0}, {0, 0, 0}};
  const std::vector<Triangle> triangles = triangulate(corners);
  EXPECT_EQ(triangles.size(), 3u);
  EXPECT_NEAR(cover(corners, triangles).absolute_area, length(polygon_normal(corners)), 1e-12);
}

TEST(Polygon, NonsenseEnds) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  std::mt19937 random(4);
  std::uniform_real_distribution<float> unit;
  std::vector<Corners> nonsense{{},
                                {{1, 2, 3}},
                                {{1, 2, 3}, {4, 5, 6}},
                                Corners(50, Vec3f(1, 1, 1)),
                                {{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}},
                                {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {1, 0, 0}},
                                {{0, 0, 0}, {nan, 0, 0}, {1, 1, 0}, {0, 1, 0}},
                                {{0, 0, 0}, {infinity, 0, 0}, {1, 1, 0}, {0, 1, 0}},
                                {{-3e38f, 0, 0}, {3e38f, 1, 0}, {1, 3e38f, 0}, {0, 5, 3e38f}}};
  for (int n : {5, 50, 500, 5000}) {
    Corners tangle, lattice;
    for (int i = 0; i < n; ++i) {
      tangle.push_back({unit(random), unit(random), unit(random)});
      lattice.push_back({std::floor(unit(random) * 4), std::floor(unit(random) * 4), 0});
    }
    nonsense.push_back(tangle);
    nonsense.push_back(lattice);
  }
  for (const Corners& corners : nonsense) {
    const std::vector<Triangle> triangles = triangulate(corners);
    EXPECT_LE(triangles.size() + 2, std::max<std::size_t>(corners.size(), 2));
    for (const Triangle& t : triangles)
      for (std::uint32_t corner : t) ASSERT_LT(corner, corners.size());
  }
}

}  // namespace
}  // namespace penumbra
