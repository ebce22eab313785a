// SPDX-License-Identifier: MIT
#include "penumbra/scene/settle_instances.h"

#include <gtest/gtest.h>

#include <limits>

#include "penumbra/geometry/placed_shape.h"
#include "penumbra/geometry/tessellation.h"
#include "penumbra/scene/error.h"
#include "penumbra/scene/framing.h"
#include "penumbra/scene/scene.h"

namespace penumbra {
namespace {

ShapeSet egg() {
  ShapeSet group;
  group.meshes.push_back(tessellated(Sphere{{0, 0, 0}, 1, 0}, 8));
  return group;
}

ShapeSet pearls() {
  ShapeSet group;
  for (int i = 0; i < 10; ++i) group.spheres.push_back({{float(i), 0, 0}, 0.5f, 0});
  return group;
}

Transform moved(double x) { return {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {x, 0, 0}}; }

TEST(SettleInstances, GroupsPlacedOnceBecomeShapesOfTheirOwn) {
  ShapeSet shapes;
  shapes.groups = {egg(), pearls()};
  shapes.instances = {{0, moved(5)}, {1, moved(0)}, {1, moved(20)}};
  EXPECT_EQ(settle_instances(shapes).expanded, 1u);
  EXPECT_EQ(shapes.meshes.size(), 1u);
  ASSERT_EQ(shapes.groups.size(), 1u);
  EXPECT_EQ(shapes.groups[0].spheres.size(), 10u);
  ASSERT_EQ(shapes.instances.size(), 2u);
  EXPECT_EQ(shapes.instances[1].group, 0u);
}

TEST(SettleInstances, AFewPrimitivesAreNoGroup) {
  ShapeSet shapes;
  ShapeSet one;
  one.spheres.push_back({});
  shapes.groups = {one};
  for (int i = 0; i < 50; ++i) shapes.instances.push_back({0, moved(3 * i)});
  settle_instances(shapes);
  EXPECT_EQ(shapes.spheres.size(), 50u);
  EXPECT_TRUE(shapes.groups.empty());
}

TEST(SettleInstances, StretchedSpheresAreMeshesOnceForAGroup) {
  ShapeSet shapes;
  shapes.groups = {pearls()};
  Transform stretched = moved(0);
  stretched.z_axis = {0, 0, 2};
  shapes.instances = {{0, moved(0)}, {0, moved(9)}, {0, stretched}, {0, stretched}};
  EXPECT_EQ(settle_instances(shapes).stretched, 10u);
  ASSERT_EQ(shapes.groups.size(), 2u);
  EXPECT_EQ(shapes.groups[0].spheres.size(), 10u);
  EXPECT_EQ(shapes.groups[1].meshes.size(), 10u);
  EXPECT_NEAR(bounds(shapes).hi.z, 1, 1e-3);
}

TEST(SettleInstances, AMapThatTextHasRoundedKeepsSpheres) {
  ShapeSet shapes;
  shapes.groups = {pearls()};
  const Transform rounded{{0.866025, 0.5, 0}, {-0.5, 0.866025, 0}, {0, 0, 1}, {}};
  shapes.instances = {{0, rounded}, {0, moved(1)}};
  EXPECT_EQ(settle_instances(shapes).stretched, 0u);
  EXPECT_GT(similarity_scale(shapes.instances[0].placement), 0);
}

TEST(SettleInstances, WhatRoundingLeavesOfATurnIsNoMatter) {
  Transform turned = moved(0);
  turned.x_axis = {6e-17, 1, 0}, turned.y_axis = {-1, 6e-17, 0};
  EXPECT_TRUE(can_place(turned));
  turned.z_axis = {0, 0, 1e-16};
  EXPECT_FALSE(can_place(turned));
  turned.z_axis = {0, 0, std::nan("")};
  EXPECT_FALSE(can_place(turned));
}

TEST(SettleInstances, WhatIsFlattenedIsNoInstance) {
  ShapeSet shapes;
  shapes.groups = {egg()};
  Transform flat = moved(0);
  flat.z_axis = {};
  shapes.instances = {{0, flat}, {0, moved(3)}, {0, moved(6)}};
  settle_instances(shapes);
  EXPECT_EQ(shapes.meshes.size(), 1u);
  EXPECT_EQ(shapes.instances.size(), 2u);
  Scene scene;
  scene.shapes = shapes;
  EXPECT_NO_THROW(validate(scene));
}

TEST(SettleInstances, WhatIsFlattenedToAPointVanishes) {
  Scene scene;
  scene.shapes.groups = {pearls()};
  Transform point = moved(0), tiny = moved(0);
  point.x_axis = point.y_axis = point.z_axis = {};
  tiny.x_axis = {1e-40, 0, 0}, tiny.y_axis = {0, 1e-40, 0}, tiny.z_axis = {0, 0, 1e-40};
  tiny.offset = {9, 9, 9};
  scene.shapes.instances = {{0, point}, {0, moved(3)}, {0, moved(6)}, {0, tiny}};
  settle_instances(scene.shapes);
  EXPECT_NO_THROW(validate(scene));
  EXPECT_EQ(primitive_count(scene.shapes), 20u);
}

/// A triangle among vertices that it does not use is no small group.
TEST(SettleInstances, GroupsOfManyVerticesAreNotCopied) {
  ShapeSet shapes;
  shapes.groups.resize(1);
  Mesh mesh;
  mesh.positions.resize(10000);
  mesh.positions[1] = {1, 0, 0}, mesh.positions[2] = {0, 1, 0}, mesh.triangles = {{0, 1, 2}};
  shapes.groups[0].meshes = {mesh};
  for (int i = 0; i < 5000; ++i) shapes.instances.push_back({0, moved(i)});
  ShapeSet flattened = shapes;
  EXPECT_EQ(settle_instances(shapes).expanded, 0u);
  for (Instance& instance : flattened.instances) instance.placement.z_axis = {};
  EXPECT_THROW(settle_instances(flattened), Error);
}

TEST(SettleInstances, TheMoreIsStretchedTheCoarserItIs) {
  ShapeSet shapes;
  shapes.groups = {pearls(), pearls()};
  for (int i = 0; i < 40000; ++i) shapes.groups[0].spheres.push_back({{}, 1, 0});
  Transform stretched = moved(0);
  stretched.z_axis = {0, 0, 2};
  shapes.instances = {{0, stretched}, {1, stretched}, {1, moved(5)}};
  settle_instances(shapes);
  EXPECT_LT(own_primitive_count(shapes), std::size_t{1} << 23);
  shapes.groups = {pearls()};
  shapes.groups[0].spheres.resize(500000);
  shapes.instances = {{0, stretched}};
  EXPECT_THROW(settle_instances(shapes), Error);
}

Scene scene_of(std::uint32_t group, const Transform& map) {
  Scene scene;
  scene.shapes.groups = {pearls()};
  scene.shapes.instances = {{group, map}};
  return scene;
}

TEST(ValidateInstances, RefusesWhatTheKernelCannotPlace) {
  Scene good = scene_of(0, moved(1));
  EXPECT_NO_THROW(validate(good));
  Transform stretched = moved(0), flat = moved(0), far = moved(2e15), none = moved(0);
  stretched.x_axis = {2, 0, 0}, flat.y_axis = {}, none.x_axis.y = std::nan("");
  for (Scene bad : {scene_of(1, moved(0)), scene_of(0, stretched), scene_of(0, flat),
                    scene_of(0, far), scene_of(0, none)})
    EXPECT_THROW(validate(bad), Error);
  Scene nested = scene_of(0, moved(0));
  nested.shapes.groups[0].groups = {egg()};
  EXPECT_THROW(validate(nested), Error);
  Scene outside = scene_of(0, {{1e14, 0, 0}, {0, 1e14, 0}, {0, 0, 1e14}, {9.9e14, 0, 0}});
  EXPECT_THROW(validate(outside), Error);
}

TEST(ValidateInstances, DropsPlacementsOfNothing) {
  Scene scene = scene_of(0, moved(1));
  scene.shapes.groups.emplace_back();
  scene.shapes.instances.push_back({1, {}});
  validate(scene);
  EXPECT_EQ(scene.shapes.instances.size(), 1u);
}

/// A crowd in one place, each turned so that its box says little: beyond some millions of triangles
/// boxes are all that is asked.
TEST(FramingInstances, ACrowdIsFramedInTime) {
  ShapeSet shapes;
  shapes.groups.resize(1);
  shapes.groups[0].meshes = {tessellated(Sphere{{0, 0, 0}, 1, 0}, 100)};
  const double s = std::sqrt(0.5);
  for (int i = 0; i < 5000; ++i)
    shapes.instances.push_back({0, {{s, s, 0}, {-s, s, 0}, {0, 0, 1}, {}}});
  EXPECT_NEAR(bounds(shapes).hi.x, 2 * s, 1e-5);
  EXPECT_NEAR(bounds(shapes).hi.z, 1, 1e-5);
  EXPECT_NEAR(detail::reach(shapes, {1, 0, 0}), 2 * s, 1e-5);
}

TEST(FramingInstances, ReachesWhereTheFlattenedSetReaches) {
  ShapeSet shapes;
  shapes.groups = {egg(), pearls()};
  shapes.instances = {{0, {{1, 0.5, 0}, {0, 2, 0}, {0.3, 0, 1}, {4, 0, 0}}},
                      {1, {{0, 3, 0}, {-3, 0, 0}, {0, 0, 3}, {0, 0, 7}}}};
  const ShapeSet flat = flattened(shapes);
  for (const Vec3d direction : {Vec3d{1, 0, 0}, Vec3d{0, -1, 0.2}, Vec3d{0.3, 0.4, 2}})
    EXPECT_NEAR(detail::reach(shapes, direction), detail::reach(flat, direction), 1e-5);
}

}  // namespace
}  // namespace penumbra
