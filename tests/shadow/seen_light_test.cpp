// SPDX-License-Identifier: MIT
#include "penumbra/shadow/seen_light.h"

#include <gtest/gtest.h>

#include <limits>

#include "penumbra/geometry/light_shape.h"
#include "tests/shadow/group_trials.h"
#include "tests/shadow/seeds.h"

namespace penumbra {
namespace {

using nasty::Random;

constexpr float infinite = std::numeric_limits<float>::infinity();
constexpr float nan = std::numeric_limits<float>::quiet_NaN();

struct Count {
  std::uint64_t receivers = 0, certain = 0, near = 0, above = 0, below = 0;
  std::uint64_t outside = 0, all_above = 0, none_above = 0;  // what is true
};

/// A light and up to 64 receivers near its horizon, near it, in it, or anywhere.
struct Trial {
  Trial(const char* light_kind, const nasty::Place& place, Random& random) {
    const Vec3d center(place(random.in_cube()));
    const double scale = double(place.scale), size = scale * double(random.power(-4, 1));
    const Vec3f seen_from = place(random.in_cube());
    light = make_light(light_kind, random_figure(random), center, size, seen_from);
    for (std::uint64_t i = 0, n = 1 + random.below(64); i < n; ++i)
      queries.push_back({receiver(center, size, scale, random), i});
    for (const ShadowQuery& query : queries) scene.add(query.receiver.position);
  }

  /// At such a height over or under the light's centre that it touches the horizon, or nearly.
  Receiver receiver(Vec3d center, double size, double scale, Random& random) const {
    const auto* sun = std::get_if<SunLight>(&light);
    const double off = (random.one_in(2) ? 1 : -1) * double(random.power(-7, 0));
    Vec3d normal = random.direction();
    if (sun && random.one_in(2)) {  // it touches the horizon, or nearly
      const double angle = (random.one_in(2) ? 1 : -1) * double(sun->half_angle_rad) * (1 + off);
      const Vec3d up(sun->direction), level = normalize(cross(up, random.direction()));
      normal = level * std::cos(angle) + up * std::sin(angle);
    }
    const Frame<double> frame = frame_around(normal);
    const double turn = double(random.uniform(0, 6.2831853f));
    const Vec3d across = frame.u * std::cos(turn) + frame.v * std::sin(turn);
    const double far = scale * double(random.power(-3, 1));
    double height = far * double(random.uniform(-1, 1));
    if (random.one_in(2)) {
      const double extent = sun ? 0 : dot(*support(light, normal) - center, normal);
      height = (random.one_in(2) ? 1 : -1) * (extent + size * off);
    }
    if (random.one_in(8)) return {Vec3f(center + random.direction() * size), Vec3f(normal)};
    return {Vec3f(center - across * far - normal * height), Vec3f(normal)};
  }

  LightShape light;
  std::vector<ShadowQuery> queries;
  Box scene;
};

void run(const Trial& trial, Random& random, Count& count) {
  static const SamplePattern pattern(128);
  const LightForm form(LightHull(trial.light, trial.scene));
  ReceiverRows rows;
  const ReceiverBits bits = see_light(form, trial.queries, trial.scene, rows);
  ASSERT_EQ(rows.count, trial.queries.size());
  ASSERT_EQ(bits.certain & bits.near, 0u);
  ASSERT_EQ((bits.above | bits.below) & ~(bits.certain | bits.near), 0u);
  for (std::size_t i = 0; i < trial.queries.size(); ++i) {
    const Receiver& receiver = trial.queries[i].receiver;
    const bool is_certain = bits.certain >> i & 1, is_above = bits.above >> i & 1,
               is_below = bits.below >> i & 1, is_in = contains(trial.light, receiver.position);
    ++count.receivers, count.certain += is_certain, count.outside += !is_in;
    ASSERT_FALSE(is_certain && is_in) << "receiver " << i;
    const bool is_near = (bits.near >> i & 1) && !is_in;
    count.near += is_near;
    if (!is_certain && !is_near) continue;
    const trials::Judgement judged = trials::judge_rays(trial.light, receiver, pattern, 64, random);
    const bool all = judged.active_count == judged.rays.count, none = judged.active_count == 0;
    ASSERT_TRUE(all || !is_above) << "receiver " << i;
    ASSERT_TRUE(none || !is_below) << "receiver " << i;
    count.above += is_above, count.below += is_below;
    count.all_above += all, count.none_above += none;
  }
}

Count run_light(const char* light_kind, std::uint64_t receivers, std::uint64_t first_seed) {
  Count count;
  for_each_seed(first_seed, count.receivers, receivers, [&](Random& random) {
    const nasty::Place place = nasty::random_place(random);
    run(Trial(light_kind, place, random), random, count);
  });
  return count;
}

class SeeLight : public testing::TestWithParam<const char*> {};
using SlowSeeLight = SeeLight;

TEST_P(SeeLight, IsRightOfHorizonsAndNeverCertainInTheLight) {
  const Count count = run_light(GetParam(), 10'000, 0);
  if (std::string_view(GetParam()) == "point") return;  // of points nothing is certain
  EXPECT_GT(count.certain, count.outside / 3);
  EXPECT_GT(count.certain + count.near, count.outside * 3 / 4);
  EXPECT_GT(count.above, count.all_above / 2);
  EXPECT_GT(count.below, count.none_above / 2);
}

TEST_P(SlowSeeLight, IsRightOfHorizonsAndNeverCertainInTheLight) {
  run_light(GetParam(), 5'000'000, 1'000'000);
}

const auto name_of_light = [](const auto& test) { return std::string(test.param); };
INSTANTIATE_TEST_SUITE_P(Of, SeeLight, testing::ValuesIn(light_kinds), name_of_light);
INSTANTIATE_TEST_SUITE_P(Of, SlowSeeLight, testing::ValuesIn(light_kinds), name_of_light);

ReceiverBits bits_of(const LightShape& light, const Receiver& receiver, const Box& scene) {
  ReceiverRows rows;
  const std::vector<ShadowQuery> queries(3, ShadowQuery{receiver, 0});
  return see_light(LightForm(LightHull(light, {{-9, -9, -9}, {9, 9, 9}})), queries, scene, rows);
}

/// Of which receivers anything is said.
std::uint64_t decided(const LightShape& light, const Receiver& receiver, const Box& scene) {
  const ReceiverBits bits = bits_of(light, receiver, scene);
  return bits.certain | bits.near | bits.above | bits.below;
}

TEST(SeeLightBits, NumbersThatAreNoneAreNotCertain) {
  const Box all{{-infinite, -infinite, -infinite}, {infinite, infinite, infinite}};
  for (const char* kind : light_kinds) {
    if (std::string_view(kind) == "point") continue;
    const LightShape light = light_of_kind(kind, {0, 0, 5}, 1, {});
    EXPECT_EQ(bits_of(light, {{0, 0, 0}, {0, 0, 1}}, all).certain, 7u) << kind;
    for (const float odd : {nan, infinite, -infinite, 3e38f, -3e38f})
      for (int axis = 0; axis < 3; ++axis) {
        Receiver at{{0, 0, 0}, {0, 0, 1}}, turned = at;
        at.position[axis] = odd, turned.normal[axis] = odd;
        EXPECT_EQ(decided(light, at, all), 0u) << kind << " " << odd;
        EXPECT_EQ(decided(light, turned, all), 0u) << kind << " " << odd;
      }
  }
}

TEST(SeeLightBits, WhatLiesOutsideTheSceneIsNotCertain) {
  const Box scene{{-1, -1, -1}, {1, 1, 1}};
  const BallLight light{{0, 0, 5}, 1};
  EXPECT_EQ(bits_of(light, {{1, 1, -1}, {0, 0, 1}}, scene).certain, 7u);
  for (int axis = 0; axis < 3; ++axis)
    for (const float sign : {-1.0f, 1.0f}) {
      Receiver receiver{{0, 0, 0}, {0, 0, 1}};
      receiver.position[axis] = sign * std::nextafter(1.0f, 2.0f);
      EXPECT_EQ(decided(light, receiver, scene), 0u);
    }
}

TEST(SeeLightBits, KeptRowsAreThoseOfTheSetBitsInTheirOrder) {
  Random random(3);
  const LightForm form(LightHull(BallLight{{0, 0, 50}, 1}, {{-9, -9, -9}, {9, 9, 9}}));
  for (int round = 0; round < 200; ++round) {
    std::vector<ShadowQuery> queries(1 + random.below(64));
    for (ShadowQuery& query : queries)
      query.receiver = {random.in_cube(), normalize(random.in_cube())};
    ReceiverRows all, kept;
    const Box scene{{-1, -1, -1}, {1, 1, 1}};
    see_light(form, queries, scene, all), see_light(form, queries, scene, kept);
    const std::uint64_t used = queries.size() == 64 ? ~0ull : (1ull << queries.size()) - 1;
    const std::uint64_t bits =
        used & (std::uint64_t{random.below(~0u)} << 32 | std::uint64_t{random.below(~0u)});
    keep_rows(bits, kept);
    std::size_t to = 0;
    for (std::size_t from = 0; from < queries.size(); ++from) {
      if (!(bits >> from & 1)) continue;
      for (int axis = 0; axis < 3; ++axis) {
        EXPECT_EQ(kept.p[axis][to], all.p[axis][from]);
        EXPECT_EQ(kept.normal[axis][to], all.normal[axis][from]);
        EXPECT_EQ(kept.way[axis][to], all.way[axis][from]);
      }
      EXPECT_EQ(kept.distance[to], all.distance[from]);
      EXPECT_EQ(kept.doubt[to], all.doubt[from]);
      ++to;
    }
    EXPECT_EQ(kept.count, to);
  }
}

}  // namespace
}  // namespace penumbra
