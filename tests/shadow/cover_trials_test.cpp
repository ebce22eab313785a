// SPDX-License-Identifier: MIT
// Umbra against the judge: no sample is free where a cover is proven.
#include "tests/shadow/cover_trials.h"
#include "penumbra/shadow/cover.h"
#include "tests/shadow/light_rays.h"
#include "tests/shadow/pairs.h"
#include "tests/shadow/seeds.h"

namespace penumbra {
namespace {

using nasty::Random;
using trials::CoverTrial;
using trials::Occluder;

constexpr std::uint32_t sample_count = 32, edge_count = 32;

bool covers(const Record& record, const CoverTrial& trial) {
  Box scene = bounds(record);
  scene.add(trial.p);
  return is_finite(trial.p) && surely_covers(record, LightHull(trial.light, scene), trial.p);
}

/// `critical`: between a light that is proven hidden and one that isn't.
struct Count {
  std::uint64_t trials = 0, proven = 0, critical = 0;
};

/// Looks for the last t that is proven, and lets the judge have a look there.
void try_one(const ShapeForm& form, const char* light_kind, Random& random, Count& count) {
  static const SamplePattern pattern(sample_count);
  const nasty::Place place = nasty::random_place(random);
  const Occluder occluder = trials::make_occluder(form, place, random);
  const trials::Situation situation(light_kind, occluder, random);
  const auto is_proven = [&](double t) { return covers(occluder.record, situation.at(t)); };
  ++count.trials;
  if (!is_proven(0)) return;
  ++count.proven;
  double proven = 0, unproven = 1;
  if (is_proven(1)) proven = 1;
  for (int i = 0; i < 24 && proven != 1; ++i) {
    const double middle = (proven + unproven) / 2;
    (is_proven(middle) ? proven : unproven) = middle;
  }
  count.critical += proven > 0 && proven < 1;
  for (double t : {proven, 0.5 * proven, 0.0}) {
    if (!is_proven(t)) continue;  // a light that moves may come out from behind and go back
    const CoverTrial trial = situation.at(t);
    const LightSamples rays = judging_rays(trial.light, trial.p, pattern, edge_count, random);
    ASSERT_EQ(free_rays(occluder.record, rays), 0u) << "at t = " << t;
  }
}

Count run_pair(const ShapeForm& form, const char* light_kind, std::uint64_t trials,
               std::uint64_t first_seed) {
  Count count;
  for_each_seed(first_seed, count.trials, trials, [&](Random& random) {
    for (int i = 0; i < 64; ++i) {
      try_one(form, light_kind, random, count);
      if (testing::Test::HasFatalFailure()) return;
    }
  });
  return count;
}

using CoverTrials = EveryPair;
using SlowCoverTrials = EveryPair;

TEST_P(CoverTrials, NoSampleIsFreeWhereCoverIsProven) {
  const Count count = run_pair(form(), light_kind(), 1'000, 0);
  EXPECT_GT(count.proven, count.trials / 20);
  EXPECT_GT(count.critical, count.trials / 40);
}

// A million, in two halves that may run side by side.
TEST_P(SlowCoverTrials, NoSampleIsFreeWhereCoverIsProven) {
  run_pair(form(), light_kind(), 500'000, 1'000'000);
}
TEST_P(SlowCoverTrials, NoSampleIsFreeWhereCoverIsProvenEither) {
  run_pair(form(), light_kind(), 500'000, 2'000'000);
}

INSTANTIATE_TEST_SUITE_P(Pairs, CoverTrials, every_pair(), name_of_pair);
INSTANTIATE_TEST_SUITE_P(Pairs, SlowCoverTrials, every_pair(), name_of_pair);

}  // namespace
}  // namespace penumbra
