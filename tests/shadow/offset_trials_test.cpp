// SPDX-License-Identifier: MIT
// Offsets against the judge: no sample that brute force calls blocked is ever proven free.
#include "tests/shadow/offset_trials.h"
#include "penumbra/shadow/offset.h"
#include "penumbra/shadow/t_max.h"
#include "tests/shadow/light_rays.h"
#include "tests/shadow/pairs.h"
#include "tests/shadow/seeds.h"

namespace penumbra {
namespace {

using nasty::Random;

constexpr std::uint32_t sample_count = 16, edge_count = 8;

/// What brute force says of one trial.
struct Verdict {
  bool is_blocked = false;
  double s = 0;  ///< every blocked sample is blocked at some s not above
};

Verdict judge(const Kernel& kernel, const LightHull& hull, const LightSamples& rays) {
  const std::uint32_t blocked = blocked_rays(kernel.records()[0], rays).front();
  Verdict verdict{.is_blocked = blocked != 0};
  for (std::uint32_t i = 0; i < rays.count; ++i) {
    if (!(blocked >> i & 1)) continue;
    const Vec3f way{rays.x[i], rays.y[i], rays.z[i]};
    const auto hit = kernel.closest({rays.origin, way, 0, rays.t_max}).hit;
    double s = hit ? double(hit->t) : HUGE_VAL;
    // Suns: along their direction, over the reach.
    if (hull.is_sun()) s *= dot(Vec3d(way), hull.center({})) / length_squared(hull.center({}));
    verdict.s = std::max(verdict.s, s);
  }
  return verdict;
}

/// Whether the segment from p to the centre meets a box.
bool meets(const Box& box, Vec3d p, Vec3d c) {
  double first = 0, last = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const double way = c[axis] - p[axis], a = box.lo[axis] - p[axis], b = box.hi[axis] - p[axis];
    if (way == 0) {
      if (a > 0 || b < 0) return false;
      continue;
    }
    first = std::max(first, std::min(a / way, b / way));
    last = std::min(last, std::max(a / way, b / way));
  }
  return first <= last;
}

struct Count {
  std::uint64_t trials = 0, free = 0, proven = 0, reduced = 0;
};

Box around(Vec3f p, float by) { return {p - Vec3f{by, by, by}, p + Vec3f{by, by, by}}; }

void run(const Kernel& kernel, const trials::OffsetTrial& trial, const nasty::Place& place,
         Random& random, Count& count) {
  static const SamplePattern pattern(sample_count);
  const Record record = kernel.records()[0];
  const Box shape = bounds(record);
  Box scene = shape;
  scene.add(trial.p);
  const LightHull hull(trial.light, scene);
  const Verdict verdict =
      judge(kernel, hull, judging_rays(trial.light, trial.p, pattern, edge_count, random));
  Box receivers = around(trial.p, random.one_in(2) ? 0 : place.scale * random.power(-3, 1));
  if (random.one_in(4)) receivers.add(scene);
  const double reduced = t_max(shape, hull, receivers);
  ++count.trials;
  count.reduced += reduced < 1;
  const bool misses = surely_misses_offset(record, hull, trial.p, 1);
  if (!verdict.is_blocked) {
    ++count.free, count.proven += misses;
    return;
  }
  ASSERT_FALSE(misses);
  ASSERT_FALSE(surely_behind_horizon(record, hull, trial.p));
  ASSERT_LE(verdict.s, reduced);
  for (double t : {verdict.s, reduced, 1.0}) {
    ASSERT_FALSE(surely_misses_offset(record, hull, trial.p, t)) << "t = " << t;
    ASSERT_TRUE(
        meets(offset_bounds(shape, hull, t, receivers), Vec3d(trial.p), hull.center(trial.p)));
  }
}

Count run_pair(const ShapeForm& form, const char* light_kind, std::uint64_t trials,
               std::uint64_t first_seed) {
  Count count;
  for_each_seed(first_seed, count.trials, trials, [&](Random& random) {
    const nasty::Place place = nasty::random_place(random);
    const ShapeSet shapes = random_shape(form, place, random);
    const Kernel kernel(shapes, {KernelKind::brute, {}});
    for (int i = 0; i < 64; ++i) {
      run(kernel, trials::offset_trial(shapes, kernel, place, light_kind, random), place, random,
          count);
      if (testing::Test::HasFatalFailure()) return;
    }
  });
  return count;
}

using OffsetTrials = EveryPair;
using SlowOffsetTrials = EveryPair;

TEST_P(OffsetTrials, NoBlockedSampleIsProvenFree) {
  const Count count = run_pair(form(), light_kind(), 4'000, 0);
  EXPECT_GT(count.free, count.trials / 4);
  EXPECT_LT(count.free, count.trials * 19 / 20);
  EXPECT_GT(count.proven, count.free / 3);
  EXPECT_GT(count.reduced, count.trials / 2);
}

TEST_P(SlowOffsetTrials, NoBlockedSampleIsProvenFree) {
  run_pair(form(), light_kind(), 1'000'000, 1'000'000);
}

INSTANTIATE_TEST_SUITE_P(Pairs, OffsetTrials, every_pair(), name_of_pair);
INSTANTIATE_TEST_SUITE_P(Pairs, SlowOffsetTrials, every_pair(), name_of_pair);

}  // namespace
}  // namespace penumbra
