// SPDX-License-Identifier: MIT
#include "penumbra/geometry/placed_shape.h"

#include <gtest/gtest.h>

#include <random>

#include "penumbra/geometry/tessellation.h"

namespace penumbra {
namespace {

const Transform quarter_turn{{0, 2, 0}, {-2, 0, 0}, {0, 0, 2}, {1, 0, 0}};

TEST(PlacedShape, ASimilarityHasOneScale) {
  EXPECT_DOUBLE_EQ(similarity_scale({}), 1);
  EXPECT_DOUBLE_EQ(similarity_scale(quarter_turn), 2);
  EXPECT_DOUBLE_EQ(similarity_scale({{-3, 0, 0}, {0, 3, 0}, {0, 0, 3}, {}}), 3);  // mirrors
  EXPECT_EQ(similarity_scale({{1, 0, 0}, {0, 1, 0}, {0, 0, 1.001}, {}}), 0);
  EXPECT_EQ(similarity_scale({{1, 0, 0}, {0.001, 1, 0}, {0, 0, 1}, {}}), 0);
  EXPECT_EQ(similarity_scale({{}, {}, {}, {}}), 0);
  EXPECT_EQ(similarity_scale({{NAN, 0, 0}, {0, 1, 0}, {0, 0, 1}, {}}), 0);
}

TEST(PlacedShape, AMapRoundedByTextIsNextToItsSimilarity) {
  const Transform rounded{{0.866025, 0.5, 0}, {-0.5, 0.866025, 0}, {0, 0, -1.000001}, {4, 5, 6}};
  const Transform near = nearest_similarity(rounded);
  EXPECT_NEAR(similarity_scale(near), 1, 1e-6);
  EXPECT_LT(determinant(near), 0);
  EXPECT_LT(length(near.y_axis - rounded.y_axis), 1e-5);
  EXPECT_EQ(near.offset, rounded.offset);
}

TEST(PlacedShape, RoundShapesTurnAndGrow) {
  const Sphere sphere = placed(Sphere{{1, 0, 0}, 0.5f, 7}, quarter_turn, 2);
  EXPECT_EQ(sphere.center, (Vec3f{1, 2, 0}));
  EXPECT_EQ(sphere.radius, 1);
  EXPECT_EQ(sphere.surface, 7u);
  const Cone cone = placed(Cone{{0, 0, 0}, {1, 0, 0}, 1, 0, Caps::capped, 3}, quarter_turn, 2);
  EXPECT_EQ(cone.apex, (Vec3f{1, 2, 0}));
  EXPECT_EQ(cone.base_radius, 2);
  EXPECT_EQ(cone.caps, Caps::capped);
  const Ring ring = placed(Ring{{0, 0, 0}, {1, 0, 0}, 1, 0.5f, 0}, quarter_turn, 2);
  EXPECT_EQ(ring.normal, (Vec3f{0, 1, 0}));
  EXPECT_EQ(ring.inner_radius, 1);
}

TEST(PlacedShape, MirroredTrianglesKeepTheirOutside) {
  ShapeSet shapes;
  shapes.groups.resize(1);
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}};  // seen from +z
  shapes.groups[0].meshes = {mesh};
  shapes.instances = {{0, {{-1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {}}}};
  const auto corner = corners(shapes, {ShapeKind::triangle, 0, 0, 1});
  EXPECT_GT(cross(corner[1] - corner[0], corner[2] - corner[0]).z, 0);
  const Mesh flat = flattened(shapes).meshes[0];
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(flat.positions[flat.triangles[0][i]], corner[i]);
}

/// Boxes of many groups in many places are those of the shapes that stand there.
TEST(PlacedShape, BoundsAreThoseOfTheFlattenedSet) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(-1, 1);
  const auto vector = [&] { return Vec3d{number(random), number(random), number(random)}; };
  for (int trial = 0; trial < 100; ++trial) {
    ShapeSet shapes;
    shapes.groups.resize(2);
    shapes.groups[0].meshes.push_back(tessellated(Sphere{Vec3f(vector()), 1, 0}, 8));
    shapes.groups[1].spheres = {{Vec3f(vector()), 0.3f, 0}};
    shapes.groups[1].cones = {{Vec3f(vector()), Vec3f(vector()), 0.2f, 0.1f, Caps::open, 0}};
    shapes.groups[1].meshes = shapes.groups[0].meshes;
    shapes.groups[1].meshes[0].is_backdrop = true;
    for (int i = 0; i < 10; ++i) {
      Transform map{vector(), vector(), vector(), vector() * 5.0};
      if (i % 2) map = nearest_similarity(map);
      shapes.instances.push_back({static_cast<std::uint32_t>(i % 2), map});
    }
    const ShapeSet flat = flattened(shapes);
    EXPECT_EQ(primitive_count(shapes), own_primitive_count(flat));
    EXPECT_EQ(bounds(shapes).lo, bounds(flat).lo);
    EXPECT_EQ(bounds(shapes).hi, bounds(flat).hi);
    EXPECT_EQ(object_bounds(shapes).lo, object_bounds(flat).lo);
    EXPECT_EQ(object_bounds(shapes).hi, object_bounds(flat).hi);
    for (const Instance& instance : shapes.instances)
      EXPECT_TRUE(placed(bounds(shapes.groups[instance.group]), instance.placement)
                      .contains(bounds(flattened({{}, {}, {}, {}, shapes.groups, {instance}}))));
  }
}

}  // namespace
}  // namespace penumbra
