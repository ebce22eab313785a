// SPDX-License-Identifier: MIT
#include "penumbra/geometry/surface_parity.h"

#include <gtest/gtest.h>

#include <cmath>

#include "penumbra/geometry/triangle_tree.h"
#include "tests/geometry/solid_meshes.h"

namespace penumbra {
namespace {

std::vector<FlatTriangle> flat(const Mesh& mesh) {
  std::vector<FlatTriangle> triangles;
  for (const Triangle& t : mesh.triangles)
    triangles.push_back({mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]});
  return triangles;
}

TEST(SurfaceParity, LinesThroughCornersAndEdgesCountRight) {
  const auto box = flat(solid_meshes::box());
  for (double z = -2.5; z < 3; ++z)
    for (double y = -1.5; y < 2; y += 0.5)
      for (double x = -1.5; x < 2; x += 0.5) {
        const bool is_within = std::abs(x) < 1 && std::abs(y) < 1 && std::abs(z) < 1;
        const bool is_on = std::max({std::abs(x), std::abs(y), std::abs(z)}) == 1;
        EXPECT_TRUE(is_on || is_inside(box, {x, y, z}) == is_within) << x << ' ' << y << ' ' << z;
      }
}

TEST(SurfaceParity, PointsInsideAreInside) {
  const auto torus = flat(solid_meshes::torus(24, 12));
  const std::vector<Vec3d> points = inside_points(torus, 16);
  EXPECT_GT(points.size(), 500u);
  for (const Vec3d& p : points) {
    EXPECT_TRUE(is_inside(torus, p));
    EXPECT_LT(std::hypot(std::hypot(p.x, p.y) - 2, p.z), 0.71);
  }
  EXPECT_TRUE(inside_points({}, 8).empty());
}

TEST(TriangleTree, FindsWhatATestOfAllFinds) {
  const auto torus = flat(solid_meshes::torus(37, 19));
  const TriangleTree tree(torus);
  for (const Vec3d& p : inside_points(torus, 9)) {
    double nearest = 9;
    for (const FlatTriangle& t : torus)
      nearest = std::min(nearest, nearest_point(t, p).distance_squared);
    EXPECT_EQ(tree.nearest(p, 3, 0).distance_squared, nearest);
    EXPECT_EQ(tree.nearest(p, 1e-9, 0).distance_squared, 1e-18);
    EXPECT_LE(tree.nearest(p, 3, 0.1).distance_squared, nearest * 1.21);
  }
  EXPECT_EQ(TriangleTree({}).nearest({}, 2, 0).distance_squared, 4);
}

}  // namespace
}  // namespace penumbra
