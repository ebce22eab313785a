// SPDX-License-Identifier: MIT
// Many glowing surfaces, and placed ones.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <random>

#include "tests/scene/emitter_meshes.h"
#include "tests/scene/emitter_sums.h"

namespace penumbra {
namespace {

Mesh rows(int count, float gap) {
  Mesh mesh;
  for (int i = 0; i < count; ++i)
    append(mesh, rectangle(gap * static_cast<float>(i % 100), gap * static_cast<float>(i / 100),
                           0.5f, 0.5f));
  return mesh;
}

TEST(EmitterCrowds, share_lights) {
  Scene few = glowing(rows(20, 1)), many = glowing(rows(300, 1));
  const EmitterReport alone = add_emitter_lights(few), together = add_emitter_lights(many);
  EXPECT_EQ(alone.lights, 20u);
  EXPECT_EQ(alone.joined, 0u);
  EXPECT_EQ(together.surfaces, 300u);
  EXPECT_EQ(together.lights, 32u);
  EXPECT_GT(together.joined, 290u);
  EXPECT_EQ(together.dark, 0u);
  EXPECT_LT(together.misdirected, 1e-3);
  for (const Light& light : many.lights) EXPECT_TRUE(light.beam);  // still to the front
}

TEST(EmitterCrowds, are_as_many_lights_as_wanted) {
  for (const std::size_t most : {1, 4, 50}) {
    Scene scene = glowing(rows(100, 1));
    EXPECT_EQ(add_emitter_lights(scene, {.most_lights = most}).lights, most);
    EXPECT_NEAR(power_of_lights(scene.lights), power_of_triangles(scene), 1e-3);
  }
}

TEST(EmitterCrowds, join_what_is_near_and_of_like_color) {
  // Red ones on the left, blue ones on the right, one green lamp among the blue ones.
  Scene scene = glowing(rows(100, 1), {1, 0, 0});
  scene.materials.push_back(scene.materials[0]);
  scene.materials.push_back(scene.materials[0]);
  scene.materials[1].emission = {0, 0, 1};
  scene.materials[2].emission = {0, 5, 0};
  Mesh& mesh = scene.shapes.meshes[0];
  mesh.surfaces.assign(200, 0);
  for (std::size_t t = 100; t < 200; ++t) mesh.surfaces[t] = t / 2 == 75 ? 2 : 1;
  add_emitter_lights(scene, {.most_lights = 8});
  EXPECT_EQ(scene.lights.size(), 8u);
  for (const Light& light : scene.lights) {
    const Color c = light.intensity;
    EXPECT_EQ((c.x > 0) + (c.y > 0) + (c.z > 0), 1) << c.x << " " << c.y << " " << c.z;
    EXPECT_TRUE(c.x == 0 || center(light.shape)->x < 50);
  }
}

TEST(EmitterCrowds, turned_every_way_shine_every_way) {
  // A lantern: panes around an axis.
  Mesh mesh;
  for (int i = 0; i < 60; ++i) {
    const double angle = 2 * pi * i / 60;
    const Vec3d out(std::cos(angle), std::sin(angle), 0), side(-out.y, out.x, 0);
    append(mesh, transformed(rectangle(-0.04f, 0, 0.08f, 1), {side, {0, 0, 1}, out, out}));
  }
  Scene scene = glowing(mesh);
  add_emitter_lights(scene, {.most_lights = 1});
  ASSERT_EQ(scene.lights.size(), 1u);
  EXPECT_FALSE(scene.lights[0].beam);
  EXPECT_TRUE(std::holds_alternative<BallLight>(scene.lights[0].shape));
  EXPECT_LT(uncovered(scene), 0.04);
}

TEST(SlowEmitterCrowds, of_a_hundred_thousand_triangles_take_a_second) {
  const auto seconds = [](Mesh mesh) {
    Scene scene = glowing(std::move(mesh));
    const auto start = std::chrono::steady_clock::now();
    const EmitterReport report = add_emitter_lights(scene);
    EXPECT_GT(report.lights, 0u);
    EXPECT_LE(report.lights, 32u);
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  // Sanitizers and busy machines get their share.
  constexpr double enough = 10;
  EXPECT_LT(seconds(rows(50000, 1)), enough);
  EXPECT_LT(seconds(torus_mesh(250, 200, 3, 1)), enough);
  EXPECT_LT(seconds(ball_mesh(250, 200)), enough);
  EXPECT_LT(seconds(flat_ring(50000, 1, 2)), enough);
}

/// The scene with its mesh in a group, placed.
Scene placed(Scene scene, const std::vector<Transform>& placements) {
  scene.shapes.groups.emplace_back();
  scene.shapes.groups[0].meshes = std::move(scene.shapes.meshes);
  scene.shapes.meshes.clear();
  for (const Transform& placement : placements) scene.shapes.instances.push_back({0, placement});
  return scene;
}

const Transform stretched{{2, 0, 0}, {0, 0.5, 0}, {0, 0, 1}, {5, 0, 0}};
const Transform mirrored{{1, 0, 0}, {0, 1, 0}, {0, 0, -1}, {0, 7, 0}};
const Transform sheared{{1, 0, 0.3}, {0.5, 1, 0}, {0, -0.2, 1}, {0, 0, 9}};

TEST(PlacedEmitters, shine_where_they_are_placed) {
  for (const Transform& placement : {Transform{}, stretched, mirrored, sheared}) {
    for (const bool is_two_sided : {false, true}) {
      Scene scene = placed(glowing(letter_e(), {1, 2, 3}, is_two_sided), {placement});
      EXPECT_EQ(add_emitter_lights(scene).lights, 4u);
      const SumErrors errors = errors_of(scene);
      EXPECT_LT(errors.most, 1e-4);
      EXPECT_LT(uncovered(scene), 1e-5);
    }
    Scene solid = placed(glowing(box_mesh(1, 2, 3)), {placement});
    EXPECT_EQ(add_emitter_lights(solid).lights, 1u);
    EXPECT_LT(errors_of(solid).most, 1e-4);
  }
}

TEST(PlacedEmitters, shine_each_time_they_are_placed) {
  Scene scene = placed(glowing(rectangle(0, 0, 1, 1)), {Transform{}, stretched, mirrored});
  const EmitterReport report = add_emitter_lights(scene);
  EXPECT_EQ(report.surfaces, 3u);
  EXPECT_EQ(scene.lights.size(), 3u);
  EXPECT_LT(errors_of(scene).most, 1e-4);
  const Mesh& mesh = scene.shapes.groups[0].meshes[0];
  EXPECT_FALSE(scene.materials[surface_of(mesh, 0)].casts_shadow);
}

TEST(PlacedEmitters, that_are_nowhere_or_flattened_away_give_nothing) {
  Scene unplaced = placed(glowing(rectangle(0, 0, 1, 1)), {});
  EXPECT_EQ(add_emitter_lights(unplaced).surfaces, 0u);
  Scene gone = placed(glowing(rectangle(0, 0, 1, 1)), {{{0, 0, 0}, {0, 1, 0}, {0, 0, 1}, {}}});
  EXPECT_EQ(add_emitter_lights(gone).lights, 0u);
  Scene unknown = placed(glowing(rectangle(0, 0, 1, 1)), {});
  unknown.shapes.instances.push_back({7, {}});
  EXPECT_EQ(add_emitter_lights(unknown).lights, 0u);
}

TEST(PlacedEmitters, of_many_triangles_in_many_places_become_hulls) {
  std::mt19937 random(6);
  std::uniform_real_distribution<double> unit(0, 1000);
  std::vector<Transform> placements(20000);
  for (Transform& t : placements) t.offset = {unit(random), unit(random), unit(random)};
  Scene scene = placed(glowing(ball_mesh(20, 10)), placements);
  const double power = power_of_triangles(scene);
  const EmitterReport report = add_emitter_lights(scene);
  EXPECT_EQ(report.surfaces, 20000u);
  EXPECT_EQ(report.lights, 32u);
  EXPECT_NEAR(power_of_lights(scene.lights), power, 1e-3 * power);
}

}  // namespace
}  // namespace penumbra
