// SPDX-License-Identifier: MIT
#include "penumbra/geometry/light_shape.h"

#include "penumbra/geometry/light_sampling.h"
#include "tests/geometry/light_shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <utility>

namespace penumbra {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr double pi = std::numbers::pi;

const LightShape point = PointLight{{1, 2, 3}};
const LightShape ball = BallLight{{1, 2, 3}, 0.5f};
const LightShape skew = ParallelogramLight{{1, 2, 3}, {1, 0.25f, 0}, {0.5f, 0, 2}};
const LightShape disk = DiskLight{{1, 2, 3}, {0.6f, 0, 0.8f}, 2};
const LightShape line = LineLight{{1, 2, 3}, {0.5f, 0, 2}};
const LightShape pentagon = polygon_around({1, 2, 3}, {1, 0.25f, 0}, {0, 0.5f, 2}, 5);
const LightShape box = box_around({1, 2, 3}, {1, 0.5f, 2});
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
  for (const LightShape& light : {point, ball, skew, disk, line, pentagon, box})
    for (std::uint64_t key = 0; key < 200; ++key) {
      const Vec3d direction(normal(random), normal(random), normal(random));
      const Vec3f p(Vec3d(normal(random), normal(random), normal(random)));
      sample_light(light, p, pattern, key, samples);
      const Vec3d farthest = *support(light, direction);
      const Box around = *bounds(light);
      for (int i = 0; i < 64; ++i) {
        const Vec3d l = Vec3d(p) + Vec3d(samples.x[i], samples.y[i], samples.z[i]);
        EXPECT_LE(dot(l, direction), dot(farthest, direction) + 1e-5);
        for (int axis = 0; axis < 3; ++axis) {
          EXPECT_GE(l[axis], around.lo[axis] - 1e-5);
          EXPECT_LE(l[axis], around.hi[axis] + 1e-5);
        }
      }
      // The support lies on the light itself: growing by it is tight.
      for (int axis = 0; axis < 3; ++axis) {
        EXPECT_GE(farthest[axis], static_cast<double>(around.lo[axis]));
        EXPECT_LE(farthest[axis], static_cast<double>(around.hi[axis]));
      }
    }
  EXPECT_EQ(*support(ball, {0, 0, 9}), Vec3d(1, 2, 3.5));
  EXPECT_EQ(*support(ball, {0, 0, 0}), Vec3d(1, 2, 3));
  EXPECT_EQ(*support(skew, {1, 0, -1}), Vec3d(1.5, 2.25, 1));
  EXPECT_EQ(*support(line, {-1, 0, 0}), Vec3d(0.5, 2, 1));
  EXPECT_EQ(*support(box, {-1, 1, 1}), Vec3d(0, 2.5, 5));
  EXPECT_EQ(*support(disk, {0, 7, 0}), Vec3d(1, 4, 3));
  const DiskLight skew_disk{{0, 0, 0}, normalize(Vec3f{1, 2, 3}), 1};
  for (const double sign : {1.0, -1.0}) {
    const Vec3d n = normalize(Vec3d(skew_disk.normal));
    EXPECT_NEAR(dot(*support(skew_disk, n * sign + Vec3d{1e-17, 0, 0}), n), 0, 1e-12);
  }
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
  EXPECT_TRUE(contains(disk, {1, 4, 3}));
  EXPECT_TRUE(contains(disk, {1, 4, std::nextafter(3.0f, 4.0f)}));
  EXPECT_FALSE(contains(disk, {1, 4.001f, 3}));
  EXPECT_FALSE(contains(disk, {1, 3, 3.001f}));
  EXPECT_TRUE(contains(line, {1.25f, 2, 4}));
  EXPECT_TRUE(contains(line, {1.5f, 2, 5}));
  EXPECT_FALSE(contains(line, {1.25f, 2.001f, 4}));
  EXPECT_FALSE(contains(line, {1.501f, 2, 5.004f}));
  EXPECT_TRUE(contains(pentagon, {1, 2, 3}));
  EXPECT_TRUE(contains(pentagon, {2, 2.25f, 3}));
  EXPECT_FALSE(contains(pentagon, {2.001f, 2.25025f, 3}));
  EXPECT_FALSE(contains(pentagon, {1, 2.001f, 3}));
  EXPECT_TRUE(contains(box, {1.5f, 2.25f, 2}));
  EXPECT_TRUE(contains(box, {2, 2.5f, 5}));
  EXPECT_TRUE(contains(box, {2, 2, std::nextafter(5.0f, 6.0f)}));
  EXPECT_FALSE(contains(box, {2.001f, 2, 3}));
  EXPECT_FALSE(contains(point, {1, 2, 3}));
  EXPECT_FALSE(contains(sun, {1, 2, 3}));
}

TEST(LightShape, ContainsWhatSpansIt) {
  // Random points of the hull of the corners, which are off the plane in their last digits.
  std::mt19937 random(2);
  std::exponential_distribution<double> weight;
  const auto check = [&](const LightShape& light) {
    const std::vector<Vec3d> hull = corners(light);
    for (int i = 0; i < 2000; ++i) {
      Vec3d sum;
      double all = 0;
      for (const Vec3d corner : hull) {
        const double w = std::pow(weight(random), 4);
        sum += corner * w, all += w;
      }
      EXPECT_TRUE(contains(light, Vec3f(sum / all)));
    }
  };
  check(line);
  check(skew);
  check(pentagon);
  check(box);
  check(polygon_around({1e4f, 3, -2e5f}, {100, 30, 7}, {-3, 80, 11}, 9));
  check(polygon_around({1e4f, 3, -2e5f}, {0.5f, 0.1f, 0}, {0, 0.25f, 0.5f}, 12));
}

TEST(LightShape, CornersSpanTheLight) {
  EXPECT_EQ(corners(point), std::vector<Vec3d>({{1, 2, 3}}));
  EXPECT_EQ(corners(line), std::vector<Vec3d>({{0.5, 2, 1}, {1.5, 2, 5}}));
  EXPECT_EQ(corners(skew).size(), 4u);
  EXPECT_EQ(corners(pentagon).size(), 5u);
  EXPECT_EQ(corners(box).size(), 8u);
  for (const LightShape& round : {ball, disk, sun}) EXPECT_TRUE(corners(round).empty());
}

TEST(LightShape, NaNIsInside) {
  for (const LightShape& light : {ball, skew, disk, line, pentagon, box}) {
    EXPECT_TRUE(contains(light, {nan, 0, 0}));
    EXPECT_TRUE(contains(light, {0, 0, nan}));
  }
  EXPECT_TRUE(contains(BallLight{{0, 0, nan}, 1}, {9, 9, 9}));
  EXPECT_TRUE(contains(DiskLight{{0, 0, 1}, {nan, 0, 0}, 1}, {9, 9, 1}));
  EXPECT_TRUE(contains(LineLight{{0, 0, 1}, {nan, 0, 0}}, {9, 9, 9}));
  PolygonLight broken = std::get<PolygonLight>(pentagon);
  for (Vec3f& corner : broken.corners) {
    const Vec3f whole = std::exchange(corner, {0, nan, 0});
    EXPECT_TRUE(contains(broken, {9, 9, 9}));
    corner = whole;
  }
  MeshLight dented = std::get<MeshLight>(box);
  dented.corners[5].y = nan;
  EXPECT_TRUE(contains(dented, {9, 9, 9}));
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

TEST(LightShape, SolidAnglesOfPolygonsAndMeshesAreThoseOfTheirParts) {
  // The face of a cube around p; a cube of which p sees one face; p on and inside a cube.
  const PolygonLight face{{0, 0, 1}, {{-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}};
  EXPECT_NEAR(solid_angle(face, {}), 4 * pi / 6, 1e-14);
  EXPECT_NEAR(solid_angle(face, {0, 0, 2}), 4 * pi / 6, 1e-14);
  EXPECT_EQ(solid_angle(face, {5, 0, 1}), 0);
  EXPECT_EQ(solid_angle(face, {0.5f, 0, 1}), 2 * pi);
  const MeshLight cube = box_around({0, 0, 2}, {1, 1, 1});
  EXPECT_NEAR(solid_angle(cube, {}), 4 * pi / 6, 1e-14);
  EXPECT_EQ(solid_angle(cube, {0, 0, 2.5f}), 4 * pi);
  EXPECT_EQ(solid_angle(line, {}), 0);
  // From a corner of the octant: three faces, which together are the octant seen from its corner.
  EXPECT_NEAR(solid_angle(box_around({5, 5, 5}, {4.9999f, 4.9999f, 4.9999f}), {}), pi / 2, 1e-3);
}

TEST(LightShape, TinySolidAnglesKeepTheirDigits) {
  const double ball_expected = pi * 1e-16;
  EXPECT_NEAR(solid_angle(BallLight{{0, 1e4f, 0}, 1e-4f}, {}) / ball_expected, 1, 1e-7);
  EXPECT_NEAR(solid_angle(SunLight{{0, 0, 1}, 1e-6f}, {}) / (pi * 1e-12), 1, 1e-6);
  const ParallelogramLight speck{{0, 1e4f, 0}, {1e-4f, 0, 0}, {0, 0, 1e-4f}};
  EXPECT_NEAR(solid_angle(speck, {}) / 4e-16, 1, 1e-7);
  EXPECT_NEAR(
      solid_angle(polygon_around({0, 1e4f, 0}, {1e-4f, 0, 0}, {0, 0, 1e-4f}, 4), {}) / 2e-16, 1,
      1e-7);
  EXPECT_NEAR(solid_angle(box_around({0, 0, 1e4f}, {1, 1, 1}), {}) / 4e-8, 1, 1e-3);
}

}  // namespace
}  // namespace penumbra
