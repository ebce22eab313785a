// SPDX-License-Identifier: MIT
#include "penumbra/trace/bake_objects.h"

#include <gtest/gtest.h>

#include "penumbra/scene/error.h"
#include "tests/trace/uv_meshes.h"

namespace penumbra {
namespace {

Mesh named(std::string name, bool has_second = false) {
  Mesh mesh = floor_mesh();
  mesh.name = std::move(name);
  if (has_second) mesh.lightmap_uvs = mesh.uvs;
  return mesh;
}

std::string problem_of(const Scene& scene, UvChoice choice = UvChoice::automatic) {
  try {
    bake_objects(scene, choice);
  } catch (const Error& error) {
    return error.problem + "; " + error.hint;
  }
  return "";
}

TEST(BakeObjects, AreNeighboursOfOneName) {
  Scene scene;
  for (const char* name : {"a", "a", "b", "", "", "a"}) scene.shapes.meshes.push_back(named(name));
  const BakeObjects found = bake_objects(scene);
  ASSERT_EQ(found.objects.size(), 5u);
  EXPECT_EQ(found.objects[0].meshes, (std::vector<std::uint32_t>{0, 1}));
  EXPECT_EQ(found.objects[4].meshes, (std::vector<std::uint32_t>{5}));
  EXPECT_EQ(found.set, UvSet::first);
}

TEST(BakeObjects, HaveTheSecondSetWhereAnyHas) {
  Scene scene;
  scene.shapes.meshes = {named("a"), named("b", true), named("c")};
  const BakeObjects found = bake_objects(scene);
  ASSERT_EQ(found.objects.size(), 1u);
  EXPECT_EQ(found.objects[0].name, "b");
  EXPECT_EQ(found.set, UvSet::second);
  EXPECT_EQ(found.without_uvs, 2u);
  EXPECT_EQ(bake_objects(scene, UvChoice::first).objects.size(), 3u);
}

TEST(BakeObjects, AreRefusedWithoutCoordinatesAndTheToolsAreNamed) {
  Scene scene;
  scene.shapes.meshes.push_back(named("a"));
  EXPECT_NE(problem_of(scene, UvChoice::second).find("second set"), std::string::npos);
  scene.shapes.meshes[0].uvs.clear();
  for (const char* tool : {"Lightmap Pack", "Smart UV Project", "xatlas"})
    EXPECT_NE(problem_of(scene).find(tool), std::string::npos) << problem_of(scene);
  scene.shapes.meshes.clear();
  EXPECT_NE(problem_of(scene).find("no triangle mesh"), std::string::npos);
}

TEST(BakeObjects, StandOnce) {
  Scene scene;
  scene.shapes.groups.emplace_back().meshes.push_back(named("chair"));
  scene.shapes.instances = {{0, {}}, {0, {}}};
  EXPECT_NE(problem_of(scene).find("several places"), std::string::npos);
  scene.shapes.meshes.push_back(named("room"));
  EXPECT_EQ(bake_objects(scene).objects.size(), 1u);
  EXPECT_EQ(bake_objects(scene).instanced, 1u);
}

}  // namespace
}  // namespace penumbra
