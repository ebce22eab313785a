// SPDX-License-Identifier: MIT
#include "penumbra/geometry/convex_polyhedron.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

namespace penumbra {
namespace {

std::vector<HalfSpace> cube_planes() {
  return {{{1, 0, 0}, 1},  {{-1, 0, 0}, 1}, {{0, 1, 0}, 1},
          {{0, -1, 0}, 2}, {{0, 0, 1}, 3},  {{0, 0, -1}, 1}};
}

TEST(ConvexPolyhedron, ABoxHasItsFacesAndEdges) {
  const ConvexPolyhedron box = intersection(cube_planes(), 10);
  EXPECT_EQ(box.faces.size(), 6u);
  EXPECT_EQ(box.edges.size(), 12u);
  EXPECT_EQ(box.inner, 1);
  EXPECT_NEAR(box.outer, std::sqrt(14.0), 1e-12);
  EXPECT_TRUE(box.holds({0.9, -1.9, 2.9}));
  EXPECT_FALSE(box.holds({0, -2.1, 0}));
}

TEST(ConvexPolyhedron, RedundantPlanesAreLeftOut) {
  std::vector<HalfSpace> planes = cube_planes();
  planes.push_back({{1, 0, 0}, 1.5});
  planes.push_back({normalize(Vec3d{1, 1, 1}), 10});
  EXPECT_EQ(intersection(planes, 10).faces.size(), 6u);
}

TEST(ConvexPolyhedron, WhatDoesNotFitTogetherIsEmpty) {
  std::vector<HalfSpace> planes = cube_planes();
  planes.push_back({normalize(Vec3d{1, 1, 0}), std::sqrt(2.0)});  // through an edge
  EXPECT_TRUE(intersection(planes, 10).is_empty());
  planes = cube_planes();
  planes[0].offset = 0;
  EXPECT_TRUE(intersection(planes, 10).is_empty());
  planes = cube_planes();
  planes.pop_back();  // open below
  EXPECT_TRUE(intersection(planes, 10).is_empty());
  EXPECT_TRUE(intersection(cube_planes(), 2).is_empty());
  planes = cube_planes();
  planes[0].offset = planes[1].offset = 1e-5;
  EXPECT_TRUE(intersection(planes, 10).is_empty());
  planes[0].offset = NAN;
  EXPECT_TRUE(intersection(planes, 10).is_empty());
  EXPECT_TRUE(intersection({}, 10).is_empty());
}

TEST(ConvexPolyhedron, FacesEdgesAndCornersObeyEuler) {
  std::mt19937_64 engine(5);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 300; ++i) {
    std::vector<HalfSpace> planes = cube_planes();
    for (int k = i % 50; k > 0; --k)
      planes.push_back({normalize(Vec3d{normal(engine), normal(engine), normal(engine)}),
                        0.5 + std::abs(normal(engine))});
    const ConvexPolyhedron body = intersection(planes, 20);
    ASSERT_FALSE(body.is_empty());
    // Three edges meet in each corner of what planes in general position bound.
    EXPECT_EQ(2 * body.edges.size() / 3 + body.faces.size(), body.edges.size() + 2);
    for (const ConvexPolyhedron::Edge& edge : body.edges)
      for (const Vec3d end : {edge.a, edge.b}) {
        EXPECT_TRUE(body.holds(end * (1 - 1e-9)));
        for (const std::uint32_t face : edge.face)
          EXPECT_NEAR(dot(body.faces[face].normal, end), body.faces[face].offset, 1e-9);
      }
  }
}

}  // namespace
}  // namespace penumbra
