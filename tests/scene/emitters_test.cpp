// SPDX-License-Identifier: MIT
#include "penumbra/scene/emitters.h"

#include <gtest/gtest.h>

namespace penumbra {
namespace {

/// Squares in a row, each of edge 1 with a gap, all of one glowing material.
Scene squares(int count) {
  Scene scene;
  scene.materials.push_back({});
  scene.materials[0].emission = {1, 2, 3};
  Mesh mesh;
  for (int i = 0; i < count; ++i) {
    const float x = 2 * static_cast<float>(i);
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (Vec3f p : {Vec3f{x, 0, 0}, Vec3f{x + 1, 0, 0}, Vec3f{x + 1, 1, 0}, Vec3f{x, 1, 0}})
      mesh.positions.push_back(p);
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.triangles.push_back({first + 2, first + 3, first});
  }
  scene.shapes.meshes.push_back(mesh);
  return scene;
}

TEST(Emitters, a_square_becomes_a_light_of_its_radiance) {
  Scene scene = squares(1);
  EXPECT_EQ(add_emitter_lights(scene).dark, 0u);
  ASSERT_EQ(scene.lights.size(), 1u);
  const auto& shape = std::get<ParallelogramLight>(scene.lights[0].shape);
  EXPECT_EQ(shape.center, (Vec3f{0.5f, 0.5f, 0}));
  EXPECT_FLOAT_EQ(4 * length(cross(shape.u, shape.v)), 1);
  EXPECT_EQ(scene.lights[0].intensity, (Color{1, 2, 3}));
  EXPECT_EQ(scene.lights[0].falloff, Falloff::inverse_square);
  const Mesh& mesh = scene.shapes.meshes[0];
  EXPECT_FALSE(scene.materials[surface_of(mesh, 0)].casts_shadow);
  EXPECT_FALSE(scene.materials[surface_of(mesh, 1)].casts_shadow);
}

TEST(Emitters, any_order_of_corners_will_do) {
  for (std::uint32_t a = 0; a < 3; ++a)
    for (std::uint32_t b = 0; b < 3; ++b) {
      Scene scene = squares(1);
      Mesh& mesh = scene.shapes.meshes[0];
      mesh.triangles = {{a, (a + 1) % 3, (a + 2) % 3}, {}};
      const Triangle other{2, 3, 0};
      mesh.triangles[1] = {other[b], other[(b + 1) % 3], other[(b + 2) % 3]};
      EXPECT_EQ(add_emitter_lights(scene).dark, 0u);
      ASSERT_EQ(scene.lights.size(), 1u);
      const auto& shape = std::get<ParallelogramLight>(scene.lights[0].shape);
      EXPECT_FLOAT_EQ(4 * length(cross(shape.u, shape.v)), 1);
    }
}

TEST(Emitters, split_vertices_count_as_one) {
  Scene scene = squares(1);
  Mesh& mesh = scene.shapes.meshes[0];
  mesh.positions.push_back(mesh.positions[2]);
  mesh.triangles[1][0] = 4;
  EXPECT_EQ(add_emitter_lights(scene).dark, 0u);
  EXPECT_EQ(scene.lights.size(), 1u);
}

TEST(Emitters, other_forms_are_counted_and_keep_their_shadow) {
  Scene scene = squares(1);
  Mesh& mesh = scene.shapes.meshes[0];
  mesh.positions[2] = {1, 1.5f, 0};
  EXPECT_EQ(add_emitter_lights(scene).dark, 1u);
  EXPECT_TRUE(scene.lights.empty());
  EXPECT_TRUE(scene.materials[surface_of(mesh, 0)].casts_shadow);

  Scene triangle = squares(1);
  triangle.shapes.meshes[0].triangles.pop_back();
  EXPECT_EQ(add_emitter_lights(triangle).dark, 1u);

  Scene joined = squares(2);
  for (Vec3f& p : joined.shapes.meshes[0].positions)
    if (p.x >= 2) p.x -= 1;
  EXPECT_EQ(add_emitter_lights(joined).dark, 1u);
}

TEST(Emitters, only_what_shines_stops_casting_shadows) {
  Scene scene = squares(2);
  scene.shapes.meshes[0].triangles.pop_back();
  EXPECT_EQ(add_emitter_lights(scene).dark, 1u);
  EXPECT_EQ(scene.lights.size(), 1u);
  const Mesh& mesh = scene.shapes.meshes[0];
  EXPECT_FALSE(scene.materials[surface_of(mesh, 1)].casts_shadow);
  EXPECT_TRUE(scene.materials[surface_of(mesh, 2)].casts_shadow);
}

TEST(Emitters, at_most_64) {
  Scene scene = squares(70);
  EXPECT_EQ(add_emitter_lights(scene).dark, 6u);
  EXPECT_EQ(scene.lights.size(), 64u);
}

TEST(Emitters, dark_scenes_stay_as_they_are) {
  Scene scene = squares(1);
  scene.materials[0].emission = {};
  EXPECT_EQ(add_emitter_lights(scene).dark, 0u);
  EXPECT_TRUE(scene.lights.empty());
  EXPECT_EQ(scene.materials.size(), 1u);
}

}  // namespace
}  // namespace penumbra
