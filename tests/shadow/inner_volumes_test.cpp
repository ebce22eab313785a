// SPDX-License-Identifier: MIT
#include "penumbra/shadow/inner_volumes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <string>

#include "penumbra/geometry/surface_point.h"
#include "penumbra/kernel/kernel.h"
#include "penumbra/shadow/visibility.h"
#include "tests/shadow/light_kinds.h"
#include "tests/shadow/nasty_meshes.h"

namespace penumbra {
namespace {

using nasty::Random;
using namespace solid_meshes;

/// A scene of meshes, one light, and what is asked of them.
struct Trial {
  ShapeSet shapes;
  Kernel kernel;
  LightShape light;
  LightHull hull;
  InnerVolumes volumes;

  Trial(ShapeSet set, LightShape l)
      : shapes(std::move(set)),
        kernel(shapes, {}),
        light(std::move(l)),
        hull(light, grown(kernel.bounds())),
        volumes(shapes, {}, std::vector<LightHull>{hull}, {.most_volumes = 16}) {}

  static Box grown(const Box& box) {
    const Vec3f pad = box.size() * 0.5f;
    return {box.lo - pad, box.hi + pad};
  }
  bool is_umbra(Vec3f p) const {
    return volumes.covering(0, hull, p, no_volume).volume != no_volume;
  }

  /// Samples that no triangle blocks.
  std::uint32_t free_samples(Vec3f p, const SamplePattern& pattern, std::uint64_t key) const {
    LightSamples samples;
    sample_light(light, p, pattern, key, samples);
    std::vector<std::uint32_t> active((samples.count + 31) / 32, 0), blocked(active.size(), 0);
    for (std::uint32_t i = 0; i < samples.count; ++i) active[i / 32] |= 1u << i % 32;
    kernel.occluded(samples, active, blocked);
    std::uint32_t result = 0;
    for (std::size_t i = 0; i < active.size(); ++i)
      result += static_cast<std::uint32_t>(__builtin_popcount(active[i] & ~blocked[i]));
    return result;
  }
};

Trial random_trial(Random& random) {
  const nasty::Place place = nasty::random_place(random);
  ShapeSet shapes;
  for (std::uint32_t i = 0, n = 1 + random.below(3); i < n; ++i)
    shapes.meshes.push_back(nasty::nasty_mesh(place, random));
  std::erase_if(shapes.meshes, [](const Mesh& mesh) { return mesh.triangles.empty(); });
  if (shapes.meshes.empty()) shapes.meshes.push_back(box());
  const Vec3f at = place(nasty::random_point(random) * random.uniform(0.2f, 6));
  const float size = place.scale * random.power(-3, 0.3f);
  const Vec3f target = place(random.in_cube());
  const char* kind = light_kinds[random.below(light_kinds.size())];
  return {std::move(shapes),
          make_light(kind, random_figure(random), Vec3d(at), double(size), target)};
}

/// Where a ray that starts at the light, or anywhere, hits a mesh: in front of it or behind; on the
/// far side of what it hit; or anywhere.
Vec3f random_receiver(const Trial& trial, Random& random) {
  const Box box = Trial::grown(trial.kernel.bounds());
  const auto anywhere = [&] {
    const Vec3f size = box.size();
    return box.lo + Vec3f{size.x * random.uniform(0, 1), size.y * random.uniform(0, 1),
                          size.z * random.uniform(0, 1)};
  };
  const Vec3f from = anywhere(), to = anywhere();
  if (random.one_in(4)) return from;
  const Vec3f away = random.one_in(2) ? to - from : -towards_center(trial.light, from);
  const auto hit = trial.kernel.closest({from, away}).hit;
  if (!hit) return from;
  const SurfacePoint point =
      surface_point(trial.shapes, hit->shape, Vec3d(from), Vec3d(away), double(hit->t));
  return random.one_in(3) ? behind_position(point) : receiver_position(point);
}

/// Between a point in proven umbra and one that isn't, the last that is: where a wrong proof would
/// show.
Vec3f last_in_umbra(const Trial& trial, Vec3f umbra, Vec3f other) {
  for (int i = 0; i < 24; ++i) {
    const Vec3f middle = umbra * 0.5f + other * 0.5f;
    (trial.is_umbra(middle) ? umbra : other) = middle;
  }
  return umbra;
}

struct Tally {
  std::size_t queries = 0, proofs = 0, edges = 0;
};

void expect_all_blocked(const Trial& trial, Vec3f p, std::uint64_t key) {
  static const SamplePattern pattern(64);
  const std::uint32_t free = trial.free_samples(p, pattern, key);
  EXPECT_EQ(free, 0u) << p.x << ' ' << p.y << ' ' << p.z << ", light " << trial.light.index()
                      << ", key " << key;
}

Tally run_trials(std::uint64_t seed, std::uint32_t trials, std::uint32_t queries) {
  Random random(seed);
  Tally tally;
  for (std::uint32_t t = 0; t < trials; ++t) {
    const Trial trial = random_trial(random);
    std::optional<Vec3f> umbra, other;
    for (std::uint32_t q = 0; q < queries; ++q) {
      const Vec3f p = random_receiver(trial, random);
      const std::uint64_t key = hash(t, q);
      ++tally.queries;
      if (!trial.is_umbra(p)) {
        other = p;
      } else {
        ++tally.proofs;
        umbra = p;
        expect_all_blocked(trial, p, key);
      }
      if (umbra && other && random.one_in(8)) {
        ++tally.edges;
        expect_all_blocked(trial, last_in_umbra(trial, *umbra, *other), key + 1);
      }
      if (testing::Test::HasFailure()) return tally;
    }
  }
  return tally;
}

TEST(InnerVolumes, NoProofWhereASampleIsFree) {
  const Tally tally = run_trials(1, 40, 800);
  EXPECT_GT(tally.proofs, tally.queries / 20);
  EXPECT_GT(tally.edges, tally.queries / 50);
}

TEST(InnerVolumes, WhichIsTriedFirstDoesNotMatter) {
  Random random(3);
  const Trial trial({{}, {}, {}, {globe(20, 0.3)}}, BallLight{{0, 0, 8}, 0.5f});
  ASSERT_GT(trial.volumes.size(), 3u);
  for (int i = 0; i < 2000; ++i) {
    const Vec3f p = random_receiver(trial, random);
    const auto first = random.below(static_cast<std::uint32_t>(trial.volumes.size()));
    const VolumeAnswer answer = trial.volumes.covering(0, trial.hull, p, first);
    EXPECT_EQ(answer.volume != no_volume, trial.is_umbra(p));
    EXPECT_LE(answer.tests, trial.volumes.size());
  }
}

TEST(InnerVolumes, ABoxHidesWhateverItsShadowHolds) {
  // As wide as the box, the light leaves it an umbra as wide.
  const Trial trial({{}, {}, {}, {placed(box(), 1, {0, 0, 2})}},
                    ParallelogramLight{{0, 0, 10}, {1, 0, 0}, {0, 1, 0}});
  for (const float z : {0.9f, 0.0f, -5.0f}) {
    for (const float x : {0.0f, 0.9f, 0.97f}) EXPECT_TRUE(trial.is_umbra({x, x, z})) << x << z;
    EXPECT_FALSE(trial.is_umbra({1.05f, 0, z}));
  }
}

TEST(InnerVolumes, LightsInsideOrTouchingProveNothing) {
  const Mesh room = placed(box(), 10, {});
  for (const LightShape& light :
       {LightShape(BallLight{{0, 0, 5}, 0.5f}), LightShape(BallLight{{0, 0, 10}, 0.5f}),
        LightShape(BallLight{{0, 0, 10.5f}, 0.5f}), LightShape(BallLight{{0, 0, 0}, 100}),
        LightShape(ParallelogramLight{{0, 0, 12}, {0, 0, 2}, {1, 0, 0}})}) {
    const Trial trial({{}, {}, {}, {room}}, light);
    for (const Vec3f p : {Vec3f{0, 0, -9}, Vec3f{1, 2, 3}, Vec3f{0, 0, -20}})
      EXPECT_FALSE(trial.is_umbra(p));
  }
  const Trial outside({{}, {}, {}, {room}}, BallLight{{0, 0, 11}, 0.5f});
  EXPECT_TRUE(outside.is_umbra({0, 0, -20}));
  EXPECT_TRUE(outside.is_umbra({1, 2, 3}));  // enclosed itself
}

TEST(InnerVolumes, AShaftThroughAHoleProvesNothing) {
  Mesh open = box();
  std::erase_if(open.triangles, [&](const Triangle& t) {  // the side at z = 1
    return open.positions[t[0]].z + open.positions[t[1]].z + open.positions[t[2]].z == 3;
  });
  ASSERT_EQ(open.triangles.size(), 10u);
  const Trial above({{}, {}, {}, {open}}, BallLight{{0, 0, 5}, 0.1f});
  EXPECT_FALSE(above.is_umbra({0, 0, -3}));  // blocked by the bottom alone
  EXPECT_FALSE(above.is_umbra({0, 0, 0}));
  const Trial beside({{}, {}, {}, {open}}, BallLight{{5, 0, 0}, 0.1f});
  EXPECT_TRUE(beside.is_umbra({-3, 0, 0}));
  EXPECT_TRUE(beside.is_umbra({0, 0, 0}));
  EXPECT_FALSE(beside.is_umbra({-3, 0, 1.3f}));
}

TEST(InnerVolumes, WhatIsNoNumberIsNotProven) {
  const Trial trial({{}, {}, {}, {box()}}, BallLight{{0, 0, 5}, 0.1f});
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float inf = std::numeric_limits<float>::infinity();
  for (const Vec3f p : {Vec3f{nan, 0, -3}, Vec3f{nan, nan, nan}, Vec3f{0, 0, -inf},
                        Vec3f{0, 0, inf}, Vec3f{0, 0, -1e20f}})
    EXPECT_FALSE(trial.is_umbra(p));
  EXPECT_TRUE(trial.is_umbra({0, 0, -3}));
  const ShapeSet nothing{{{{0, 0, 0}, 1, 0}}, {}, {}, {}};
  EXPECT_EQ(InnerVolumes(nothing, {}, {}, {}).size(), 0u);
}

TEST(SlowInnerVolumes, NoProofWhereASampleIsFreeInTwoMillionTrials) {
  const Tally tally = run_trials(2, 1000, 2000);
  RecordProperty("proofs", std::to_string(tally.proofs));
  RecordProperty("edges", std::to_string(tally.edges));
  EXPECT_GT(tally.proofs, tally.queries / 20);
}

}  // namespace
}  // namespace penumbra
