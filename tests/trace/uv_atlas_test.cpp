// SPDX-License-Identifier: MIT
#include "penumbra/trace/uv_atlas.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

#include "penumbra/scene/error.h"
#include "penumbra/trace/render.h"
#include "tests/trace/uv_meshes.h"

namespace penumbra {
namespace {

Scene scene_of(Mesh mesh) {
  Scene scene;
  scene.shapes.meshes.push_back(std::move(mesh));
  return scene;
}

UvAtlas atlas_of(const Scene& scene, std::uint32_t size = 100) {
  const std::uint32_t meshes[] = {0};
  return make_atlas(scene, meshes, UvSet::first, size, size);
}

std::string problem_of(const Scene& scene) {
  try {
    atlas_of(scene);
  } catch (const Error& error) {
    return error.problem + "; " + error.hint;
  }
  return "";
}

/// As many triangles as wanted, all with these coordinates.
Mesh soup(std::size_t triangles, const std::vector<Vec2f>& uvs) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.uvs = uvs;
  mesh.triangles.assign(triangles, {0, 1, 2});
  return mesh;
}

TEST(UvAtlas, ListsATriangleInEveryBlockThatItCovers) {
  std::mt19937 generator(5);
  std::uniform_real_distribution<float> coordinate(-0.2f, 1.2f);
  for (int trial = 0; trial < 50; ++trial) {
    Mesh mesh = soup(1, {});
    for (int i = 0; i < 3; ++i) mesh.uvs.push_back({coordinate(generator), coordinate(generator)});
    const Scene scene = scene_of(mesh);
    UvAtlas atlas;
    try {
      atlas = atlas_of(scene);
    } catch (const Error&) {
      continue;  // all of it outside
    }
    const TexelTriangle t = texel_triangle(scene, atlas, {0, 0});
    ASSERT_EQ(atlas.block_count(), 49u);
    for (std::uint32_t i = 0; i < 49; ++i) {
      const Footprint footprint(
          t, {double(i % 7 * block_edge), double(i / 7 * block_edge), double(block_edge)});
      EXPECT_TRUE(texel_area(footprint) == 0 || atlas.block(i).size() == 1);
    }
  }
}

TEST(UvAtlas, PutsTheTopOfTheTextureAtVOne) {
  const Scene scene = scene_of(soup(1, {{0, 1}, {1, 1}, {0, 0.5f}}));
  const TexelTriangle t = texel_triangle(scene, atlas_of(scene), {0, 0});
  EXPECT_EQ(t[0].y, 0);
  EXPECT_EQ(t[1].x, 100);
  EXPECT_EQ(t[2].y, 50);
}

TEST(UvAtlas, CountsWhatCannotBeBaked) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  Mesh mesh = floor_mesh();
  mesh.positions.insert(mesh.positions.end(), 4, Vec3f{1, 2, 3});
  for (const Vec2f uv : {Vec2f{nan, 0}, Vec2f{2, 0}, Vec2f{0, 0}, Vec2f{0, 3e30f}})
    mesh.uvs.push_back(uv);
  mesh.triangles.push_back({0, 1, 4});  // no number
  mesh.triangles.push_back({0, 1, 7});  // too large
  mesh.triangles.push_back({0, 2, 5});  // outside
  mesh.triangles.push_back({0, 6, 1});  // flat
  mesh.triangles.push_back({0, 6, 2});  // flat
  const UvAtlas atlas = atlas_of(scene_of(mesh));
  EXPECT_EQ(atlas.triangle_count, 7u);
  EXPECT_EQ(atlas.faults.not_finite, 2u);
  EXPECT_EQ(atlas.faults.outside, 1u);
  EXPECT_EQ(atlas.faults.flat, 2u);
}

TEST(UvAtlas, RefusesWhatIsNoUnwrapping) {
  EXPECT_NE(
      problem_of(scene_of(soup(3, {{0.5f, 0.5f}, {0.5f, 0.5f}, {0.5f, 0.5f}}))).find("xatlas"),
      std::string::npos);
  EXPECT_NE(problem_of(scene_of(soup(1, {{2, 2}, {3, 2}, {2, 3}}))), "");
  EXPECT_NE(problem_of(scene_of(soup(200, {{0, 0}, {1, 0}, {0, 1}}))).find("64 times"),
            std::string::npos);
  EXPECT_EQ(problem_of(scene_of(soup(100, {{0, 0}, {1, 0}, {0, 1}}))), "");
}

TEST(UvAtlas, TakesATextureOfOneTexelAndAMillionTinyTriangles) {
  Mesh mesh = soup(1'000'000, {{0.5f, 0.5f}, {0.501f, 0.5f}, {0.5f, 0.501f}});
  const Scene scene = scene_of(mesh);
  EXPECT_EQ(atlas_of(scene, 100).triangles.size(), 1'000'000u);
  EXPECT_EQ(atlas_of(scene_of(floor_mesh()), 1).triangles.size(), 2u);
}

}  // namespace
}  // namespace penumbra
