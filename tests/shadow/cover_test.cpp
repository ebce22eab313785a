// SPDX-License-Identifier: MIT
#include "penumbra/shadow/cover.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/shadow/shape_forms.h"

namespace penumbra {
namespace {

Box scene_box(const ShapeSet& shapes, Vec3f p) {
  Box box = bounds(shapes);
  box.add(p);
  return box;
}

bool covers(const ShapeSet& shapes, const LightShape& light, Vec3f p) {
  return surely_covers(only_record(shapes), LightHull(light, scene_box(shapes, p)), p);
}

ShapeSet sphere(Vec3f center, float radius) {
  ShapeSet shapes;
  shapes.spheres.push_back({center, radius, 0});
  return shapes;
}

ShapeSet cone(const Cone& c) {
  ShapeSet shapes;
  shapes.cones.push_back(c);
  return shapes;
}

ShapeSet ring(const Ring& r) {
  ShapeSet shapes;
  shapes.rings.push_back(r);
  return shapes;
}

ShapeSet triangle(Vec3f a, Vec3f b, Vec3f c) {
  ShapeSet shapes;
  Mesh& mesh = shapes.meshes.emplace_back();
  mesh.positions = {a, b, c}, mesh.triangles = {{0, 1, 2}};
  return shapes;
}

/// Ball of radius 3 at distance 12 from one of radius 1: the umbra is a cone of length 6 and half
/// angle asin(1/6) behind it.
TEST(Cover, ABallEclipsesABallExactlyInItsUmbraCone) {
  const ShapeSet shapes = sphere({0, 0, 0}, 1);
  const BallLight light{{0, 0, 12}, 3};
  const double sine = 1.0 / 6;
  EXPECT_TRUE(covers(shapes, light, {0, 0, -5.999f}));
  EXPECT_FALSE(covers(shapes, light, {0, 0, -6.001f}));
  for (double z = 0.5; z < 6; z += 0.5) {
    const double radius = (6 - z) * sine / std::sqrt(1 - sine * sine);
    if (z * z + radius * radius < 1) continue;  // in the ball
    EXPECT_TRUE(covers(shapes, light, Vec3f(Vec3d{radius * 0.999, 0, -z}))) << z;
    EXPECT_FALSE(covers(shapes, light, Vec3f(Vec3d{0, radius * 1.001, -z}))) << z;
  }
}

TEST(Cover, ABallHidesTheSunUpToItsOwnAngle) {
  const ShapeSet shapes = sphere({0, 0, 10}, 1);
  const double angle = std::asin(0.1);
  EXPECT_TRUE(covers(shapes, SunLight{{0, 0, 1}, float(angle * 0.98)}, {0, 0, 0}));
  EXPECT_FALSE(covers(shapes, SunLight{{0, 0, 1}, float(angle * 1.001)}, {0, 0, 0}));
  EXPECT_FALSE(covers(shapes, SunLight{{0, 0, -1}, float(angle * 0.5)}, {0, 0, 0}));
}

TEST(Cover, ALongCylinderHidesWhatItsTwoTangentPlanesHold) {
  const BallLight light{{0, 0, 10}, 0.5f};  // half angle asin(0.05) seen from 0
  for (Caps caps : {Caps::open, Caps::capped}) {
    const auto covered = [&](float radius) {
      return covers(cone({{-50, 0, 5}, {50, 0, 5}, radius, radius, caps, 0}), light, {0, 0, 0});
    };
    EXPECT_TRUE(covered(0.251f));
    EXPECT_FALSE(covered(0.249f));
  }
}

TEST(Cover, ATubeHidesNothingBehindItsOpenEnds) {
  const BallLight light{{0, 0, 10}, 0.5f};
  const Cone along{{0, 0, 3}, {0, 0, 5}, 1, 1, Caps::open, 0};
  Cone closed = along;
  closed.caps = Caps::capped;
  EXPECT_FALSE(covers(cone(along), light, {0, 0, 0}));
  EXPECT_TRUE(covers(cone(closed), light, {0, 0, 0}));
  // In through the side, out through an end: blocked on the way in.
  EXPECT_TRUE(covers(cone({{0, 0, -20}, {0, 0, 8}, 3, 3, Caps::open, 0}), light, {-9, 0, 0}));
  // The other way round; and from inside.
  EXPECT_TRUE(covers(cone({{0, 0, 5}, {0, 0, 50}, 3, 3, Caps::open, 0}),
                     BallLight{{9, 0, 20}, 0.5f}, {0, 0, 0}));
  EXPECT_TRUE(covers(cone({{-50, 0, 0}, {50, 0, 0}, 1, 1, Caps::open, 0}), light, {0, 0, 0}));
  EXPECT_FALSE(covers(cone({{0, 0, -5}, {0, 0, 5}, 1, 1, Caps::open, 0}), light, {0, 0, 0}));
}

TEST(Cover, AFullConeHasOneOpenEnd) {
  const BallLight light{{0, 0, 10}, 0.5f};
  EXPECT_TRUE(covers(cone({{0, 3, 4}, {0, -9, 4}, 2, 0, Caps::open, 0}), light, {0, 0, 0}));
  EXPECT_FALSE(covers(cone({{0, 0, 4}, {0, 0, 50}, 2, 1, Caps::open, 0}), light, {0, 0, 0}));
}

TEST(Cover, ADiskAndARing) {
  const BallLight light{{0, 0, 10}, 1};
  const double tangent = 1 / std::sqrt(99.0);
  EXPECT_TRUE(covers(ring({{0, 0, 5}, {0, 0, 1}, float(5 * tangent * 1.02), 0, 0}), light, {}));
  EXPECT_FALSE(covers(ring({{0, 0, 5}, {0, 0, 1}, float(5 * tangent * 0.999), 0, 0}), light, {}));
  const Ring wide{{4, 0, 5}, {0, 0, 1}, 6, 3.4f, 0};  // the light is seen 0.5 around x = -4 of it
  EXPECT_TRUE(covers(ring(wide), light, {}));
  Ring wider_hole = wide;
  wider_hole.inner_radius = 3.6f;
  EXPECT_FALSE(covers(ring(wider_hole), light, {}));
}

TEST(Cover, ATriangleHidesWhatItsThreePlanesHold) {
  const double tangent = 1 / std::sqrt(99.0);  // of the light's half angle
  for (double scale : {0.999, 1.001}) {
    const double inner = 5 * tangent * scale, far = inner * std::sqrt(3.0);
    const ShapeSet shapes = triangle(Vec3f(Vec3d{-far, -inner, 5}), Vec3f(Vec3d{far, -inner, 5}),
                                     Vec3f(Vec3d{0, 2 * inner, 5}));
    EXPECT_EQ(covers(shapes, BallLight{{0, 0, 10}, 1}, {}), scale > 1);
    EXPECT_FALSE(covers(shapes, BallLight{{0, 0, 5.9f}, 1}, {}));  // through the light
    EXPECT_FALSE(covers(shapes, BallLight{{0, 0, -10}, 1}, {}));   // behind p
    EXPECT_FALSE(covers(shapes, BallLight{{0, 0, 3}, 0.1f}, {}));  // before it
  }
}

TEST(Cover, TheLightMustBeOutside) {
  const ShapeSet room = sphere({0, 0, 0}, 10);
  EXPECT_FALSE(covers(room, BallLight{{0, 0, 5}, 1}, {0, 0, -20}));
  EXPECT_FALSE(covers(room, BallLight{{0, 0, 5}, 1}, {0, 0, 0}));
  EXPECT_FALSE(covers(room, BallLight{{0, 0, 10}, 1}, {0, 0, -20}));
  EXPECT_TRUE(covers(room, BallLight{{0, 0, 11.1f}, 1}, {0, 0, -20}));
  EXPECT_TRUE(covers(room, BallLight{{0, 0, 11.1f}, 1}, {0, 0, 3}));
}

TEST(Cover, WhatCastsNoShadowAndWhatIsNoNumberProvesNothing) {
  const ShapeSet shapes = sphere({0, 0, 0}, 1);
  const BallLight light{{0, 0, 12}, 1};
  const Vec3f p{0, 0, -2};
  ASSERT_TRUE(covers(shapes, light, p));
  Record record = only_record(shapes);
  const LightHull hull(light, scene_box(shapes, p));
  record.casts_shadow = false;
  EXPECT_FALSE(surely_covers(record, hull, p));
  const float nan = std::numeric_limits<float>::quiet_NaN(),
              infinity = std::numeric_limits<float>::infinity();
  for (float bad : {nan, infinity, -infinity}) {
    for (const ShapeForm& form : shape_forms) {
      nasty::Random random(31);
      const ShapeSet occluder = random_shape(form, {}, random);
      for (std::size_t i = 0; i < record.number.size(); ++i) {
        Record broken = only_record(occluder);
        EXPECT_FALSE(surely_covers(broken, hull, {0, bad, -2}));
        const bool is_used = broken.kind == ShapeKind::triangle ? i < 9
                             : broken.kind == ShapeKind::sphere ? i < 4
                             : broken.kind == ShapeKind::ring   ? i < 8
                                                                : i < 9;
        broken.number[i] = bad;
        EXPECT_FALSE(is_used && surely_covers(broken, hull, p)) << form.name << " " << i;
      }
    }
    EXPECT_FALSE(covers(shapes, BallLight{{bad, 0, 12}, 1}, p));
    EXPECT_FALSE(covers(shapes, BallLight{{0, 0, 12}, bad}, p));
    EXPECT_FALSE(covers(shapes, PointLight{{0, 0, bad}}, p));
  }
  EXPECT_FALSE(covers(sphere({0, 0, 0}, 0), light, p));
  EXPECT_FALSE(covers(sphere({0, 0, 0}, 1e-30f), light, p));
}

TEST(Cover, ABallIsCoveredByAPartOfASolid) {
  const BallLight light{{0, 0, 12}, 3};
  const Vec3f p{0, 0, -5};
  const LightHull hull(light, {{-10, -10, -10}, {10, 10, 20}});
  EXPECT_TRUE(ball_covers({0, 0, 0}, 1, hull, p, 0.01));
  EXPECT_FALSE(ball_covers({0, 0, 0}, 1, hull, p, 0.5));
  EXPECT_FALSE(ball_covers({0, 0, 40}, 30, hull, {0, 0, 0}, 0.01));  // behind the light
}

}  // namespace
}  // namespace penumbra
