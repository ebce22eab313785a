// SPDX-License-Identifier: MIT
// The judge's rules at the edges, which every method has to follow (docs/method.md, Edges).
#include <gtest/gtest.h>

#include <limits>

#include "penumbra/shadow/visibility.h"
#include "tests/shadow/light_kinds.h"

namespace penumbra {
namespace {

/// What one method says of light 0 at a point.
Visibility seen_by(Method method, const ShapeSet& shapes, const LightShape& light,
                   const Receiver& receiver, const KernelOptions& options = {},
                   ShadowCounters* counters = nullptr) {
  const Kernel kernel(shapes, options);
  const ShadowScene scene = prepare_shadows(kernel, shapes, options, {&light, 1}, method);
  VisibilityScratch scratch(64);
  OccluderQueue queue;
  ShadowCounters ignored;
  return visibility(scene, 0, receiver, 7, queue, scratch, counters ? *counters : ignored);
}

class EdgeRules : public testing::TestWithParam<Method> {
 protected:
  /// The judge's bits; returns the method's own answer.
  Visibility see(const ShapeSet& shapes, const LightShape& light, const Receiver& receiver,
                 const KernelOptions& options = {}) {
    const Visibility judge = seen_by(Method::stochastic, shapes, light, receiver, options);
    counters = {};
    const Visibility seen = seen_by(GetParam(), shapes, light, receiver, options, &counters);
    EXPECT_EQ(seen.fraction, judge.fraction);
    EXPECT_EQ(seen.cosine_weighted, judge.cosine_weighted);
    return seen;
  }
  ShadowCounters counters;
};

INSTANTIATE_TEST_SUITE_P(EachMethod, EdgeRules,
                         testing::Values(Method::offset, Method::reduced, Method::umbra,
                                         Method::shaft));

const Receiver up{{0, 0, 0}, {0, 0, 1}};

ShapeSet floor_and(const Sphere& sphere) {
  ShapeSet shapes;
  Mesh floor;
  floor.positions = {{-9, -9, -0.001f}, {9, -9, -0.001f}, {9, 9, -0.001f}, {-9, 9, -0.001f}};
  floor.triangles = {{0, 1, 2}, {0, 2, 3}};
  shapes.meshes.push_back(floor);
  shapes.spheres.push_back(sphere);
  return shapes;
}

TEST_P(EdgeRules, InsideALightNothingIsProven) {
  const ShapeSet shapes = floor_and({{0, 0, 5}, 1, 0});
  EXPECT_EQ(see(shapes, BallLight{{0, 0, 0.2f}, 1}, up).shadow_class, ShadowClass::penumbra);
  const LightShape mesh = light_of_kind("mesh", {0, 0, 0.1f}, 1, {0, 0, -5});
  EXPECT_EQ(see(shapes, mesh, up).shadow_class, ShadowClass::penumbra);
}

TEST_P(EdgeRules, OnAFlatLightNothingIsProven) {
  const ShapeSet shapes = floor_and({{0, 0, 5}, 1, 0});
  for (const char* kind : {"disk", "parallelogram", "polygon", "line"}) {
    const LightShape light = light_of_kind(kind, {0, 0, 0}, 1, {1, 0, 0});
    EXPECT_EQ(see(shapes, light, up).shadow_class, ShadowClass::penumbra) << kind;
  }
}

TEST_P(EdgeRules, InsideAnOccluderNothingIsFree) {
  const ShapeSet shapes = floor_and({{0, 0, 0}, 2, 0});
  const Visibility seen = see(shapes, BallLight{{0, 0, 6}, 1}, up);
  EXPECT_EQ(seen.fraction, 0);
  EXPECT_NE(seen.shadow_class, ShadowClass::lit);
}

TEST_P(EdgeRules, InsideAClosedRoomWithItsLightAllIsFree) {
  ShapeSet shapes;
  shapes.spheres.push_back({{0, 0, 0}, 20, 0});
  const Visibility seen = see(shapes, BallLight{{0, 0, 6}, 1}, up);
  EXPECT_EQ(seen.fraction, 1);
  EXPECT_NE(seen.shadow_class, ShadowClass::umbra);
}

TEST_P(EdgeRules, ALightInsideAnOccluderIsHiddenButNotByAnUmbraProof) {
  const ShapeSet shapes = floor_and({{0, 0, 6}, 2, 0});
  const Visibility seen = see(shapes, BallLight{{0, 0, 6}, 1}, up);
  EXPECT_EQ(seen.fraction, 0);
  EXPECT_EQ(seen.shadow_class, ShadowClass::penumbra);
}

TEST_P(EdgeRules, AnOccluderInsideTheLightDecidesByItsSamples) {
  const ShapeSet shapes = floor_and({{0, 0, 6}, 0.5f, 0});
  EXPECT_EQ(see(shapes, BallLight{{0, 0, 6}, 1}, up).shadow_class, ShadowClass::penumbra);
  // It touches the light's near side.
  EXPECT_EQ(see(floor_and({{0, 0, 4.5f}, 0.5f, 0}), BallLight{{0, 0, 6}, 1}, up).shadow_class,
            ShadowClass::penumbra);
}

TEST_P(EdgeRules, ALightPartlyBelowTheHorizonCountsItsUpperSamples) {
  const ShapeSet shapes = floor_and({{0, 0, 5}, 1, 0});
  const Visibility seen = see(shapes, BallLight{{6, 0, 0}, 1}, up);
  EXPECT_EQ(seen.cosine_weighted, 1);
  EXPECT_GT(seen.fraction, 0.2f);
  EXPECT_LT(seen.fraction, 0.8f);
}

TEST_P(EdgeRules, ALightWhollyBelowTheHorizonIsNoQuery) {
  const ShapeSet shapes = floor_and({{0, 0, 5}, 1, 0});
  EXPECT_EQ(see(shapes, BallLight{{0, 0, -6}, 1}, up).fraction, 0);
  EXPECT_EQ(counters.lit + counters.penumbra + counters.umbra, 0u);
  EXPECT_EQ(counters.rays, 0u);
}

TEST_P(EdgeRules, WhatCastsNoShadowProvesNothing) {
  ShapeSet shapes = floor_and({{0, 0, 3}, 2, 1});
  const KernelOptions clear{KernelKind::wide, {false, true}};
  EXPECT_EQ(see(shapes, BallLight{{0, 0, 7}, 0.5f}, up, clear).shadow_class, ShadowClass::lit);
  EXPECT_EQ(see(shapes, BallLight{{0, 0, 7}, 0.5f}, up).fraction, 0);
}

TEST_P(EdgeRules, APointLightCostsOneRay) {
  const ShapeSet shapes = floor_and({{3, 0, 3}, 1, 0});
  EXPECT_EQ(see(shapes, PointLight{{0, 0, 7}}, up).fraction, 1);
  EXPECT_EQ(counters.rays, 1u);
}

TEST_P(EdgeRules, OutsideTheScenesBoxNothingIsProven) {
  const ShapeSet shapes = floor_and({{0, 0, 5}, 1, 0});
  const Receiver far{{0, 0, -100}, {0, 0, 1}};
  EXPECT_EQ(see(shapes, BallLight{{0, 0, 8}, 0.5f}, far).shadow_class, ShadowClass::penumbra);
}

TEST_P(EdgeRules, NotANumberProvesNothing) {
  const ShapeSet shapes = floor_and({{0, 0, 5}, 1, 0});
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const LightShape light = BallLight{{0, 0, 8}, 0.5f};
  EXPECT_EQ(seen_by(GetParam(), shapes, light, {{nan, 0, 0}, {0, 0, 1}}).shadow_class,
            ShadowClass::penumbra);
}

TEST_P(EdgeRules, LitAndUmbraAreProvenWhereTheyAreClear) {
  const BallLight light{{0, 0, 8}, 0.5f};
  EXPECT_EQ(see(floor_and({{5, 0, 2}, 1, 0}), light, up).shadow_class, ShadowClass::lit);
  EXPECT_EQ(counters.rays, 0u);
  const ShapeSet hidden = floor_and({{0, 0, 3}, 2, 0});
  const bool proves_umbra = GetParam() == Method::umbra || GetParam() == Method::shaft;
  EXPECT_EQ(see(hidden, light, up).shadow_class,
            proves_umbra ? ShadowClass::umbra : ShadowClass::penumbra);
}

}  // namespace
}  // namespace penumbra
