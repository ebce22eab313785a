// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/light_emitters.h"

#include <gtest/gtest.h>

namespace penumbra {
namespace {

/// Triangles in a row, all glowing.
Scene triangles(int count, float size) {
  Scene scene;
  scene.materials.emplace_back();
  scene.materials[0].emission = {1, 1, 1};
  Mesh mesh;
  for (int i = 0; i < count; ++i) {
    const float x = 2 * static_cast<float>(i);
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const Vec3f p : {Vec3f{x, 0, 0}, Vec3f{x + 1, 0, 0}, Vec3f{x, size, 0}})
      mesh.positions.push_back(p);
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  scene.shapes.meshes.push_back(std::move(mesh));
  return scene;
}

std::vector<std::string> warnings_of(Scene scene) {
  Warnings warnings("a.obj");
  light_emitters(scene, warnings);
  return warnings.lines();
}

TEST(LightEmitters, says_nothing_where_lights_are_what_glows) {
  EXPECT_TRUE(warnings_of(triangles(32, 1)).empty());
  EXPECT_TRUE(warnings_of(triangles(0, 1)).empty());
}

TEST(LightEmitters, tells_that_surfaces_share_lights) {
  const std::vector<std::string> lines = warnings_of(triangles(412, 1));
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0], "a.obj: 412 glowing surfaces light the scene as 32 lights");
}

TEST(LightEmitters, tells_where_light_goes_astray) {
  // Two leaves of a folded sheet become one light at most.
  Scene bumpy;
  bumpy.materials.emplace_back();
  bumpy.materials[0].emission = {1, 1, 1};
  bumpy.materials[0].emits_from_back = false;
  Mesh mesh;
  constexpr std::uint32_t rows = 60;
  for (std::uint32_t i = 0; i < rows; ++i)
    for (std::uint32_t j = 0; j < rows; ++j)
      mesh.positions.emplace_back(static_cast<float>(i), static_cast<float>(j),
                                  2.0f * static_cast<float>((i + j) % 2));
  for (std::uint32_t i = 0; i + 1 < rows; ++i)
    for (std::uint32_t j = 0; j + 1 < rows; ++j) {
      const std::uint32_t a = i * rows + j, b = a + rows;
      mesh.triangles.push_back({a, b, b + 1});
      mesh.triangles.push_back({a, b + 1, a + 1});
    }
  bumpy.shapes.meshes.push_back(std::move(mesh));
  const std::vector<std::string> lines = warnings_of(bumpy);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_NE(lines[0].find("goes where it should not"), std::string::npos) << lines[0];
}

}  // namespace
}  // namespace penumbra
