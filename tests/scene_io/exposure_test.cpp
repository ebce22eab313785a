// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/exposure.h"

#include <gtest/gtest.h>

namespace penumbra {
namespace {

/// A square of side 2 at the origin, seen from above, under a lamp.
Scene lamp_over_floor(float height) {
  Scene scene;
  scene.materials.emplace_back();
  Mesh floor;
  floor.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  floor.triangles = {{0, 1, 2}, {0, 2, 3}};
  scene.shapes.meshes.push_back(floor);
  scene.lights.push_back({PointLight{{0, 0, height}}, {700, 350, 70}, Falloff::inverse_square, {}});
  return scene;
}

double brightest(const Scene& scene) { return double(max_abs(scene.lights[0].intensity)); }

TEST(Exposure, ALampShowsWhiteOnTheFloorWhateverItsPower) {
  Scene scene = lamp_over_floor(100);
  EXPECT_NEAR(balance_lights(scene), 1e4 / 700, 0.01);
  EXPECT_NEAR(brightest(scene), 1e4, 5);
  EXPECT_NEAR(scene.lights[0].intensity.z / scene.lights[0].intensity.x, 0.1, 1e-6);
  EXPECT_NEAR(balance_lights(scene), 1, 1e-5);
}

TEST(Exposure, FewPointsMayBeBrighterThanWhite) {
  Scene scene = lamp_over_floor(0.2f);
  balance_lights(scene);
  const std::vector<double> values = irradiances(scene);
  EXPECT_NEAR(values[values.size() * 9 / 10], 1, 1e-5);
  EXPECT_GT(values.back(), 1);
}

/// A wide dark plain around a lit room says nothing about the room's picture.
TEST(Exposure, WhatTheCameraDoesNotSeeDoesNotCount) {
  Scene room = lamp_over_floor(2);
  room.camera = Camera{.from = {0, 0, 1.5}, .at = {0, 0, 0}, .up = {0, 1, 0}, .fov_deg = 60};
  Scene plain = room;
  Mesh far = plain.shapes.meshes[0];
  for (Vec3f& p : far.positions) p = p * 1000.0f + Vec3f{5000, 0, 0};
  plain.shapes.meshes.push_back(far);
  balance_lights(room), balance_lights(plain);
  EXPECT_NEAR(brightest(plain) / brightest(room), 1, 0.05);
}

TEST(Exposure, ASpotCountsWhereItsBeamGoes) {
  Scene scene = lamp_over_floor(2);
  scene.lights[0].beam = Beam{{0, 0, 1}, 0.9f, 0.8f};  // away from the floor
  EXPECT_TRUE(irradiances(scene).empty());
  EXPECT_EQ(balance_lights(scene), 1);
  EXPECT_EQ(scene.lights[0].intensity.x, 700);
}

TEST(Exposure, InstancesAreLitWhereTheyStand) {
  Scene scene = lamp_over_floor(100);
  Scene placed = scene;
  placed.shapes.groups = {ShapeSet{}};
  placed.shapes.groups[0].meshes = std::move(placed.shapes.meshes);
  placed.shapes.meshes.clear();
  placed.shapes.instances = {{0, {}}};
  EXPECT_EQ(irradiances(placed), irradiances(scene));
}

TEST(Exposure, NothingIsAskedOfWhatIsBroken) {
  Scene scene = lamp_over_floor(1);
  scene.shapes.meshes[0].triangles.push_back({0, 1, 99});
  scene.shapes.meshes[0].positions[3].x = std::numeric_limits<float>::quiet_NaN();
  scene.shapes.instances.push_back({7, {}});
  EXPECT_FALSE(irradiances(scene).empty());
  scene.lights.clear();
  EXPECT_TRUE(irradiances(scene).empty());
}

}  // namespace
}  // namespace penumbra
