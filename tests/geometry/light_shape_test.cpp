// SPDX-License-Identifier: MIT
#include "penumbra/geometry/light_shape.h"

#include "penumbra/geometry/light_sampling.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace penumbra {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr double pi = std::numbers::pi;

const LightShape point = PointLight{{1, 2, 3}};
const LightShape ball = BallLight{{1, 2, 3}, 0.5f};
const LightShape skew = ParallelogramLight{{1, 2, 3}, {1, 0.25f, 0}, {0.5f, 0, 2}};
const LightShape sun = SunLight{{0, 0.6f, 0.8f}, 0.01f};

TEST(LightShape, SunsHaveNoPlace) {
  EXPECT_FALSE(center(sun));
  EXPECT_FALSE(support(sun, {1, 0, 0}));
  EXPECT_FALSE(bounds(sun));
  EXPECT_EQ(towards_center(sun, {5, 5, 5}), Vec3f(0, 0.6f, 0.8f));
  EXPECT_EQ(*center(skew), Vec3f(1, 2, 3));
  EXPECT_EQ(towards_center(ball, {1, 1, 1}), Vec3f(0, 1, 2));
}

TEST(LightShape, SupportAndBoxHoldEverySample) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  LightSamples samples;
  const SamplePattern pattern(64);
  for (const LightShape& light : {point, ball, skew})
    for (std::uint64_t key = 0; key < 200; ++key) {
      const Vec3d direction(normal(random), normal(random), normal(random));
      const Vec3f p(Vec3d(normal(random), normal(random), normal(random)));
      sample_light(light, p, pattern, key, samples);
      const Vec3d farthest = *support(light, direction);
      const Box box = *bounds(light);
      for (int i = 0; i < 64; ++i) {
        const Vec3d l = Vec3d(p) + Vec3d(samples.x[i], samples.y[i], samples.z[i]);
        EXPECT_LE(dot(l, direction), dot(farthest, direction) + 1e-5);
        for (int axis = 0; axis < 3; ++axis) {
          EXPECT_GE(l[axis], box.lo[axis] - 1e-5);
          EXPECT_LE(l[axis], box.hi[axis] + 1e-5);
        }
      }
      // The support lies on the light itself: growing by it is tight.
      for (int axis = 0; axis < 3; ++axis) {
        EXPECT_GE(farthest[axis], static_cast<double>(box.lo[axis]));
        EXPECT_LE(farthest[axis], static_cast<double>(box.hi[axis]));
      }
    }
  EXPECT_EQ(*support(ball, {0, 0, 9}), Vec3d(1, 2, 3.5));
  EXPECT_EQ(*support(ball, {0, 0, 0}), Vec3d(1, 2, 3));
  EXPECT_EQ(*support(skew, {1, 0, -1}), Vec3d(1.5, 2.25, 1));
}

TEST(LightShape, BoxesAreTight) {
  EXPECT_EQ(bounds(point)->lo, bounds(point)->hi);
  EXPECT_NEAR(bounds(ball)->lo.x, 0.5, 1e-6);
  EXPECT_NEAR(bounds(skew)->hi.x, 2.5, 1e-6);
  EXPECT_NEAR(bounds(skew)->size().y, 0.5, 1e-6);
}

TEST(LightShape, ContainsItsInsideAndItsSkin) {
  EXPECT_TRUE(contains(ball, {1, 2, 3}));
  EXPECT_TRUE(contains(ball, {1.5f, 2, 3}));
  EXPECT_TRUE(contains(ball, {std::nextafter(1.5f, 2.0f), 2, 3}));
  EXPECT_FALSE(contains(ball, {1.501f, 2, 3}));
  EXPECT_TRUE(contains(skew, {2.5f, 2.25f, 5}));
  EXPECT_TRUE(contains(skew, {1, 2, 3}));
  EXPECT_FALSE(contains(skew, {1, 2.001f, 3}));
  EXPECT_FALSE(contains(skew, {2.51f, 2.2525f, 5}));
  EXPECT_FALSE(contains(point, {1, 2, 3}));
  EXPECT_FALSE(contains(sun, {1, 2, 3}));
}

TEST(LightShape, NaNIsInside) {
  for (const LightShape& light : {ball, skew}) {
    EXPECT_TRUE(contains(light, {nan, 0, 0}));
    EXPECT_TRUE(contains(light, {0, 0, nan}));
  }
  EXPECT_TRUE(contains(BallLight{{0, 0, nan}, 1}, {9, 9, 9}));
}

TEST(LightShape, SolidAnglesAreThoseOfTheBooks) {
  EXPECT_EQ(solid_angle(point, {}), 0);
  EXPECT_NEAR(solid_angle(BallLight{{0, 0, 2}, 1}, {}), 2 * pi * (1 - std::sqrt(0.75)), 1e-14);
  EXPECT_EQ(solid_angle(BallLight{{0, 0, 2}, 3}, {}), 4 * pi);
  EXPECT_NEAR(solid_angle(SunLight{{0, 0, 1}, 1}, {}), 2 * pi * (1 - std::cos(1.0)), 1e-14);
  // A face of the cube around p, and an eighth of such a face as a skew light has it too.
  EXPECT_NEAR(solid_angle(ParallelogramLight{{0, 0, -1}, {1, 0, 0}, {0, 1, 0}}, {}), 4 * pi / 6,
              1e-14);
  const ParallelogramLight rhombus{{0.5f, 0.5f, 1}, {0.5f, 0, 0}, {0.5f, 0.5f, 0}};
  const ParallelogramLight mirrored{{0.5f, 0.5f, 1}, {0, 0.5f, 0}, {0.5f, 0.5f, 0}};
  EXPECT_NEAR(solid_angle(rhombus, {}), solid_angle(mirrored, {}), 1e-15);
  EXPECT_EQ(solid_angle(ParallelogramLight{{3, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}), 0);
  EXPECT_EQ(solid_angle(ParallelogramLight{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}), 2 * pi);
}

TEST(LightShape, TinySolidAnglesKeepTheirDigits) {
  const double ball_expected = pi * 1e-16;
  EXPECT_NEAR(solid_angle(BallLight{{0, 1e4f, 0}, 1e-4f}, {}) / ball_expected, 1, 1e-7);
  EXPECT_NEAR(solid_angle(SunLight{{0, 0, 1}, 1e-6f}, {}) / (pi * 1e-12), 1, 1e-6);
  const ParallelogramLight speck{{0, 1e4f, 0}, {1e-4f, 0, 0}, {0, 0, 1e-4f}};
  EXPECT_NEAR(solid_angle(speck, {}) / 4e-16, 1, 1e-7);
}

}  // namespace
}  // namespace penumbra
