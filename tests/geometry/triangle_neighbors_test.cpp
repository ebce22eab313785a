// SPDX-License-Identifier: MIT
#include "penumbra/geometry/triangle_neighbors.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/shadow/sheet_meshes.h"

namespace penumbra {
namespace {

using Neighbors = std::vector<std::array<std::uint32_t, 3>>;

bool has_edge(const Mesh& mesh, std::uint32_t triangle, Vec3f a, Vec3f b) {
  for (int k = 0; k < 3; ++k) {
    const Vec3f from = mesh.positions[mesh.triangles[triangle][k]];
    const Vec3f to = mesh.positions[mesh.triangles[triangle][(k + 1) % 3]];
    if ((from == a && to == b) || (from == b && to == a)) return true;
  }
  return false;
}

/// Every edge against every triangle.
Neighbors neighbors_brute(const Mesh& mesh) {
  Neighbors result;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    result.push_back({no_triangle, no_triangle, no_triangle});
    for (int k = 0; k < 3; ++k) {
      const Vec3f a = mesh.positions[mesh.triangles[t][k]];
      const Vec3f b = mesh.positions[mesh.triangles[t][(k + 1) % 3]];
      std::uint32_t found = no_triangle, others = 0;
      for (std::uint32_t other = 0; other < mesh.triangles.size(); ++other)
        if (other != t && has_edge(mesh, other, a, b)) found = other, ++others;
      if (others == 1) result.back()[k] = found;
    }
  }
  return result;
}

TEST(TriangleNeighbors, OfABoxAreAllThere) {
  const Neighbors across = triangle_neighbors(solid_meshes::box());
  ASSERT_EQ(across.size(), 12u);
  for (std::uint32_t t = 0; t < 12; ++t)
    for (const std::uint32_t other : across[t]) {
      ASSERT_LT(other, 12u);
      EXPECT_EQ(std::count(across[other].begin(), across[other].end(), t), 1);
    }
}

TEST(TriangleNeighbors, LieAcrossTheEdgeFromCornerToNextCorner) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {-1, 1, 0}, {0, -1, 0}};
  mesh.triangles = {{0, 1, 2}, {1, 3, 2}, {0, 2, 4}, {1, 0, 5}};
  const Neighbors across = triangle_neighbors(mesh);
  EXPECT_EQ(across[0], (std::array<std::uint32_t, 3>{3, 1, 2}));
  EXPECT_EQ(across[1], (std::array<std::uint32_t, 3>{no_triangle, no_triangle, 0}));
  EXPECT_EQ(across[2], (std::array<std::uint32_t, 3>{0, no_triangle, no_triangle}));
  EXPECT_EQ(across[3], (std::array<std::uint32_t, 3>{0, no_triangle, no_triangle}));
}

TEST(TriangleNeighbors, PlacesCountAndNotIndices) {
  const Mesh welded = solid_meshes::globe(5);
  EXPECT_EQ(triangle_neighbors(welded), triangle_neighbors(nasty::unwelded(welded)));
  Mesh zeros;  // of either sign
  zeros.positions = {{0, 0, 0},     {1, 0, 0}, {0, 1, 0}, {-0.0f, -0.0f, -0.0f},
                     {1, -0.0f, 0}, {0, -1, 0}};
  zeros.triangles = {{0, 1, 2}, {3, 5, 4}};
  EXPECT_EQ(triangle_neighbors(zeros)[0][0], 1u);
}

TEST(TriangleNeighbors, NothingOfNothing) { EXPECT_TRUE(triangle_neighbors({}).empty()); }

TEST(TriangleNeighbors, AreThoseOfBruteForceForWholeAndBrokenMeshes) {
  nasty::Random random(9);
  for (int round = 0; round < 60; ++round) {
    Mesh mesh = nasty::random_sheet(random);
    for (std::uint32_t i = random.below(5); i > 0; --i) nasty::damage(mesh, random);
    if (random.one_in(2)) mesh = nasty::unwelded(mesh);
    drop_degenerate_triangles(mesh);
    ASSERT_EQ(triangle_neighbors(mesh), neighbors_brute(mesh)) << "round " << round;
  }
}

}  // namespace
}  // namespace penumbra
