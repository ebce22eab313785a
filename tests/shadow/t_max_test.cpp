// SPDX-License-Identifier: MIT
#include "penumbra/shadow/t_max.h"

#include <gtest/gtest.h>

#include "tests/shadow/light_kinds.h"

namespace penumbra {
namespace {

using nasty::Random;

const Box room{{-10, -10, 0}, {10, 10, 10}};
const Box block{{-1, -1, 4}, {1, 1, 5}};

double over(const Box& occluder, const LightShape& light, const Box& receivers) {
  return t_max(occluder, LightHull(light, room), receivers);
}

TEST(TMax, OnAFloorIsTheOccludersHeightOverTheLights) {
  EXPECT_NEAR(over(block, PointLight{{0, 0, 9}}, room), 5.0 / 9, 1e-4);
  EXPECT_NEAR(over(block, BallLight{{0, 0, 9}, 1}, room), 5.0 / 8, 1e-4);
  EXPECT_NEAR(over(block, ParallelogramLight{{0, 0, 9}, {1, 0, 0}, {0, 1, 0}}, room), 5.0 / 9,
              1e-4);
}

TEST(TMax, OfASunIsTheFarthestWayOverTheReach) {
  const LightHull sun(SunLight{{0, 0, 1}, 0.01f}, room);
  EXPECT_NEAR(t_max(block, sun, room) * sun.center({}).z, 5, 1e-3);
}

TEST(TMax, ReceiversBesideTheShadowDoNotCount) {
  // The light stands beside the block: its shadow ends at the wall, not at the floor.
  const Box low{{-10, -10, -1000}, {10, 10, 10}};
  const double s = over(block, BallLight{{9, 0, 5}, 0.5f}, low);
  EXPECT_LT(s, 0.6);
  EXPECT_GT(s, 11 / 19.5 - 1e-4);
}

TEST(TMax, IsZeroWhereTheShadowHasNoReceiver) {
  EXPECT_EQ(over(block, BallLight{{0, 0, 9}, 1}, {{-10, -10, 6}, {10, 10, 10}}), 0);
  const LightHull sun(SunLight{{0, 0, 1}, 0.01f}, room);
  EXPECT_EQ(t_max(block, sun, {{-10, -10, 6}, {10, 10, 10}}), 0);
}

TEST(TMax, IsOneWhereNothingBoundsIt) {
  EXPECT_EQ(over(block, BallLight{{0, 0, 4.5f}, 1}, room), 1);
  EXPECT_EQ(over(block, BallLight{{0, 0, 4.5f}, 5}, room), 1);
  EXPECT_EQ(over(block, BallLight{{1.5f, 0, 4.5f}, 0.6f}, room), 1);
  EXPECT_EQ(over(block, BallLight{{0, 0, 9}, 1}, Box{}), 1);
  EXPECT_EQ(over(Box{}, BallLight{{0, 0, 9}, 1}, room), 1);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(over(block, BallLight{{nan, 0, 9}, 1}, room), 1);
}

/// Random q, l and v, wherever that gives a receiver of the box.
TEST(TMax, BoundsEveryShadow) {
  std::vector<double> found(light_kinds.size()), bound(light_kinds.size());
  for (std::uint64_t seed = 0; seed < 20'000; ++seed) {
    Random random(seed);
    const std::size_t which = seed % light_kinds.size();
    const nasty::Place place = nasty::random_place(random);
    const auto random_box = [&] {
      Box box;
      const float size = random.power(-2, 0);
      const Vec3f middle = nasty::random_point(random);
      for (int i = 0; i < 2; ++i) box.add(place(middle + random.in_cube() * size));
      return box;
    };
    const Box occluder = random_box();
    Box receivers = random_box();
    if (random.one_in(2)) receivers.add(occluder);
    Box scene = receivers;
    scene.add(occluder);
    const LightHull light(
        make_light(light_kinds[which], random_figure(random), Vec3d(place(random.in_cube() * 5.0f)),
                   double(place.scale * random.power(-2, 0) / 2), place({})),
        scene);
    const double s_max = t_max(occluder, light, receivers);
    double farthest = 0;
    for (int i = 0; i < 200; ++i) {
      const auto in_box = [&](const Box& box, int axis) {
        const double share = random.one_in(2) ? random.below(2) : random.uniform(0, 1);
        return double(box.lo[axis]) * (1 - share) + double(box.hi[axis]) * share;
      };
      const Vec3d q{in_box(occluder, 0), in_box(occluder, 1), in_box(occluder, 2)};
      const Vec3d spread = light.spread(Vec3d(random.in_cube())), l = light.center({}) + spread;
      const double s = random.uniform(0, 1) * (random.one_in(2) ? 1 : s_max);
      const Vec3d p = light.is_sun() ? q - l * s : q + (q - l) * (s / (1 - s));
      const bool is_receiver = p.x >= receivers.lo.x && p.y >= receivers.lo.y &&
                               p.z >= receivers.lo.z && p.x <= receivers.hi.x &&
                               p.y <= receivers.hi.y && p.z <= receivers.hi.z;
      if (is_receiver) farthest = std::max(farthest, s);
    }
    ASSERT_LE(farthest, s_max) << "seed " << seed;
    if (farthest > 0) found[which] += farthest, bound[which] += s_max;
  }
  for (std::size_t i = 0; i < found.size(); ++i)
    EXPECT_GT(found[i], 0.3 * bound[i]) << light_kinds[i];
}

}  // namespace
}  // namespace penumbra
