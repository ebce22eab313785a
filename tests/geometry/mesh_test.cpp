// SPDX-License-Identifier: MIT
#include "penumbra/geometry/mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <set>

namespace penumbra {
namespace {

/// Vertex i of the unit cube has the bits of i as coordinates.
Mesh cube() {
  Mesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.positions.push_back(Vec3f(Vec3<int>(i & 1, i >> 1 & 1, i >> 2 & 1)));
  const auto quad = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
  };
  quad(0, 2, 3, 1), quad(4, 5, 7, 6), quad(0, 1, 5, 4);
  quad(2, 6, 7, 3), quad(0, 4, 6, 2), quad(1, 3, 7, 5);
  return mesh;
}

/// A ball with its poles on z, rows x 2 rows quads.
Mesh globe(std::uint32_t rows, Vec3f center) {
  Mesh mesh;
  const std::uint32_t columns = 2 * rows;
  for (std::uint32_t r = 0; r <= rows; ++r)
    for (std::uint32_t c = 0; c < columns; ++c) {
      const double polar = std::numbers::pi * r / rows, around = std::numbers::pi * c / rows;
      const double ring = r == 0 || r == rows ? 0 : std::sin(polar);
      mesh.positions.push_back(
          Vec3f(Vec3d(ring * std::cos(around), ring * std::sin(around), std::cos(polar))) + center);
    }
  for (std::uint32_t r = 0; r < rows; ++r)
    for (std::uint32_t c = 0; c < columns; ++c) {
      const std::uint32_t a = r * columns + c, b = r * columns + (c + 1) % columns;
      if (r > 0) mesh.triangles.push_back({a, b + columns, b});
      if (r + 1 < rows) mesh.triangles.push_back({a, a + columns, b + columns});
    }
  return mesh;
}

/// The same surface with three vertices of its own for each triangle, as STL has it.
Mesh soup(const Mesh& mesh) {
  Mesh result;
  for (const Triangle& t : mesh.triangles) {
    const auto n = static_cast<std::uint32_t>(result.positions.size());
    for (std::uint32_t corner : t) result.positions.push_back(mesh.positions[corner]);
    result.triangles.push_back({n, n + 1, n + 2});
  }
  return result;
}

TEST(Mesh, BoundsHoldUsedCornersOnly) {
  Mesh mesh = cube();
  mesh.positions.push_back({100, 100, 100});
  EXPECT_EQ(bounds(mesh).hi, Vec3f(1, 1, 1));
  EXPECT_TRUE(bounds(Mesh{}).is_empty());
}

TEST(Mesh, DegenerateTrianglesGoWithTheirSurfaces) {
  Mesh mesh;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  mesh.positions = {{0, 0, 0},   {1, 0, 0},          {0, 1, 0},
                    {0, 0, 0},   {3, 0, 0},          {1e-30f, 1e-30f, 0},
                    {nan, 0, 0}, {0.1f, 0.1f, 0.1f}, {0.3f, 0.3f, 0.3f}};
  mesh.triangles = {{0, 1, 2}, {0, 0, 1}, {0, 3, 1}, {0, 1, 4}, {0, 1, 5}, {0, 1, 6}, {0, 7, 8}};
  mesh.surfaces = {10, 11, 12, 13, 14, 15, 16};
  EXPECT_EQ(drop_degenerate_triangles(mesh), 4u);
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 1, 5}, {0, 1, 6}}));
  EXPECT_EQ(mesh.surfaces, (std::vector<std::uint32_t>{10, 14, 15}));
  EXPECT_EQ(mesh.positions.size(), 9u);
}

TEST(Mesh, WeldingFindsTheFirstVertexOfAPlace) {
  Mesh mesh;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  mesh.positions = {{1, 2, 3}, {0, 0, 0}, {-0.0f, 0, -0.0f}, {nan, 1, nan}, {1, 2, 3}, {nan, 0, 0}};
  EXPECT_EQ(welded_vertices(mesh), (std::vector<std::uint32_t>{0, 1, 1, 3, 0, 5}));
}

TEST(MeshTopology, CubeIsOneClosedComponent) {
  for (const Mesh& mesh : {cube(), soup(cube())}) {
    const MeshTopology t = topology(mesh);
    EXPECT_EQ(t.component, std::vector<std::uint32_t>(12, 0));
    EXPECT_EQ(t.is_closed, std::vector<bool>{true});
    EXPECT_EQ(t.boundary_edges, 0u);
    EXPECT_EQ(t.nonmanifold_edges, 0u);
  }
}

TEST(MeshTopology, BoxWithoutLidIsOpen) {
  Mesh mesh = cube();
  mesh.triangles.resize(10);
  const MeshTopology t = topology(mesh);
  EXPECT_EQ(t.is_closed, std::vector<bool>{false});
  EXPECT_EQ(t.boundary_edges, 4u);
}

TEST(MeshTopology, ComponentsAreClosedEachForItself) {
  Mesh mesh = cube();
  const Mesh other = cube();
  for (const Vec3f& p : other.positions) mesh.positions.push_back(p + Vec3f(5, 0, 0));
  for (std::size_t i = 0; i < 11; ++i) {
    const Triangle t = other.triangles[i];
    mesh.triangles.push_back({t[0] + 8, t[1] + 8, t[2] + 8});
  }
  const MeshTopology t = topology(mesh);
  EXPECT_EQ(t.is_closed, (std::vector<bool>{true, false}));
  EXPECT_EQ(t.component[3], 0u);
  EXPECT_EQ(t.component[20], 1u);
  EXPECT_EQ(t.boundary_edges, 3u);
}

TEST(MeshTopology, TJunctionIsNoSharedEdge) {
  Mesh mesh = cube();  // one half of a face is split at the middle of an edge, its neighbour not
  mesh.positions.push_back({0.5f, 0, 0});
  const auto split = std::find(mesh.triangles.begin(), mesh.triangles.end(), Triangle{0, 1, 5});
  ASSERT_NE(split, mesh.triangles.end());
  *split = {0, 8, 5};
  mesh.triangles.push_back({8, 1, 5});
  const MeshTopology t = topology(mesh);
  EXPECT_EQ(t.is_closed, std::vector<bool>{false});
  EXPECT_EQ(t.boundary_edges, 3u);
}

TEST(MeshTopology, CubesThatShareAnEdgeAreClosedByParity) {
  Mesh mesh = cube();
  const Mesh other = cube();
  for (const Vec3f& p : other.positions) mesh.positions.push_back(p + Vec3f(1, 1, 0));
  for (const Triangle& t : other.triangles)
    mesh.triangles.push_back({t[0] + 8, t[1] + 8, t[2] + 8});
  const MeshTopology t = topology(mesh);
  EXPECT_EQ(t.is_closed, std::vector<bool>{true});
  EXPECT_EQ(t.nonmanifold_edges, 1u);
  EXPECT_EQ(t.boundary_edges, 0u);
}

TEST(SmoothNormals, OfABallPointOutward) {
  const Vec3f center{3, -2, 1};
  for (Mesh mesh : {globe(48, center), soup(globe(48, center))}) {
    add_smooth_normals(mesh, 1);
    ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
    std::vector<bool> is_used(mesh.positions.size(), false);
    for (const Triangle& t : mesh.triangles)
      for (std::uint32_t corner : t) is_used[corner] = true;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      if (!is_used[i]) continue;
      EXPECT_GT(dot(mesh.normals[i], normalize(mesh.positions[i] - center)), 1 - 2e-5f);
      EXPECT_NEAR(length(mesh.normals[i]), 1, 1e-6f);
    }
  }
}

TEST(SmoothNormals, DoNotDependOnHowFacesAreCut) {
  Mesh mesh = cube();  // weighted by angle, a cube's corner is symmetric whatever the diagonals
  add_smooth_normals(mesh, 3);
  EXPECT_EQ(mesh.positions.size(), 8u);
  for (std::size_t i = 0; i < 8; ++i) {
    const Vec3f outward = normalize(mesh.positions[i] - Vec3f(0.5f, 0.5f, 0.5f));
    EXPECT_GT(dot(mesh.normals[i], outward), 1 - 1e-6f);
  }
}

TEST(SmoothNormals, SplitVerticesAtCreases) {
  Mesh mesh = cube();
  mesh.uvs.assign(8, {0.25f, 0.5f});
  mesh.uvs[7] = {7, 7};
  mesh.lightmap_uvs.assign(8, {});
  mesh.lightmap_uvs[7] = {8, 8};
  add_smooth_normals(mesh, 1);
  EXPECT_EQ(mesh.positions.size(), 24u);
  EXPECT_EQ(mesh.uvs.size(), 24u);
  EXPECT_EQ(mesh.lightmap_uvs.size(), 24u);
  for (const Triangle& t : mesh.triangles) {
    const Vec3f a = mesh.positions[t[0]];
    const Vec3f face = normalize(cross(mesh.positions[t[1]] - a, mesh.positions[t[2]] - a));
    for (std::uint32_t corner : t) {
      EXPECT_EQ(mesh.normals[corner], face);
      EXPECT_EQ(mesh.uvs[corner].u == 7, mesh.positions[corner] == Vec3f(1, 1, 1));
      EXPECT_EQ(mesh.lightmap_uvs[corner].v == 8, mesh.positions[corner] == Vec3f(1, 1, 1));
    }
  }
}

TEST(SmoothNormals, SurviveHostileMeshes) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {nan, 0, 0}, {0, 0, 1}};
  for (std::uint32_t i = 0; i < 2000; ++i) {
    mesh.positions.push_back({std::cos(i * 1.f), std::sin(i * 1.f), 0});
    mesh.triangles.push_back({0, 4, i + 5});
  }
  mesh.triangles.push_back({0, 1, 2});
  mesh.triangles.push_back({0, 3, 2});
  mesh.triangles.push_back({2, 2, 2});
  for (float crease : {0.f, 1.f, nan, 10.f}) {
    Mesh copy = mesh;
    add_smooth_normals(copy, crease);
    EXPECT_EQ(copy.normals.size(), copy.positions.size());
    EXPECT_EQ(copy.triangles.size(), mesh.triangles.size());
    for (const Triangle& t : copy.triangles)
      for (std::uint32_t corner : t) ASSERT_LT(corner, copy.positions.size());
  }
}

}  // namespace
}  // namespace penumbra
