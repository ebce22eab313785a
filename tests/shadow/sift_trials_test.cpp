// SPDX-License-Identifier: MIT
// Sifts against the judge: no candidate that blocks an active sample is ever dropped, and no sample
// passes by a sphere that covers.
#include "penumbra/shadow/sift.h"
#include "tests/shadow/group_trials.h"
#include "tests/shadow/pairs.h"
#include "tests/shadow/seeds.h"

namespace penumbra {
namespace {

using nasty::Random;
using trials::GroupTrial;
using trials::Watchers;

struct Count {
  std::uint64_t trials = 0, receivers = 0;  ///< each held against one candidate
  std::uint64_t free = 0, dropped = 0, hidden = 0, covered = 0, critical = 0;
  std::uint64_t dropped_for_all = 0, covered_for_all = 0;
};

/// One shape, as often as fills some lanes.
std::unique_ptr<CandidateList> list_of(const Record& record, std::uint32_t copies) {
  auto list = std::make_unique<CandidateList>();
  list->clear();
  for (std::uint32_t i = 0; i < copies; ++i) list->add(record, i);
  return list;
}

/// Scratch of one thread.
struct Sifts {
  Sifted one;
  SiftedRows rows;
  std::unique_ptr<CandidateList> all = std::make_unique<CandidateList>();
};

/// What the sifts claim of one candidate.
struct Claims {
  std::uint64_t dropped = 0, covered = 0;  ///< by receiver
  bool dropped_for_all = false, covered_for_all = false;
};

Claims claims_of(const CandidateList& list, const Watchers& watchers, Sifts& sifts) {
  Claims claims;
  for (std::size_t i = 0; i < watchers.count(); ++i) {
    sift(list, seen_by_one(watchers.form, watchers.rows, i), sifts.one);
    claims.dropped |= std::uint64_t{sifts.one.record.empty() && sifts.one.cover == no_record} << i;
    claims.covered |= std::uint64_t{sifts.one.cover != no_record} << i;
  }
  const SeenLight sight = seen_by_all(watchers.form, watchers.group(0, watchers.count()));
  claims.covered_for_all = sift_for_all(list, sight, *sifts.all) != no_record;
  claims.dropped_for_all = !claims.covered_for_all && sifts.all->size() == 0;
  return claims;
}

/// Lanes of receivers say of part of the group what each of it says alone.
void expect_rows_agree(const CandidateList& list, const Watchers& watchers, const Claims& claims,
                       Random& random, Sifts& sifts) {
  const std::size_t first = random.below(static_cast<std::uint32_t>(watchers.count()));
  const std::size_t count = 1 + random.below(static_cast<std::uint32_t>(watchers.count() - first));
  sift_rows(list, watchers.form, watchers.group(first, count), sifts.rows);
  std::uint64_t kept = 0;
  for (const SiftedRows::Candidate& candidate : sifts.rows.candidate) kept |= candidate.kept;
  ASSERT_EQ(sifts.rows.kept, kept);
  ASSERT_EQ(sifts.rows.candidate.size(), kept == 0 ? 0 : list.size());
  for (std::size_t i = 0; i < count; ++i) {
    const bool is_covered = sifts.rows.covered >> i & 1;
    ASSERT_EQ(is_covered, claims.covered >> (first + i) & 1);
    ASSERT_TRUE(is_covered || (kept >> i & 1) != (claims.dropped >> (first + i) & 1));
  }
}

/// The same of one word of 32 samples or some of them, as if they were the light.
void judge_part(const CandidateList& list, const SeenLight& sight, const Record& record,
                const trials::Judgement& judged, Random& random, Sifts& sifts) {
  const std::uint32_t word = random.below(static_cast<std::uint32_t>(judged.active.size()));
  std::vector<std::uint32_t> wanted(judged.active.size()), blocked(wanted.size());
  wanted[word] = judged.active[word];
  if (random.one_in(2)) wanted[word] &= random.below(~0u);
  if (wanted[word] == 0) return;
  sift(list, seen_part(sight, judged.rays, word, wanted[word]), sifts.one);
  const std::uint32_t only = 0;
  occluded_among({&record, 1}, {&only, 1}, judged.rays, wanted, blocked);
  const bool is_covered = sifts.one.cover != no_record;
  ASSERT_TRUE(blocked == wanted || !is_covered) << "word " << word;
  ASSERT_TRUE(blocked[word] == 0 || is_covered || !sifts.one.record.empty()) << "word " << word;
}

/// Everything that is claimed of the receivers, against samples.
void judge(const CandidateList& list, const Record& record, const Watchers& watchers,
           const Claims& claims, Random& random, Sifts& sifts, Count& count) {
  static const SamplePattern patterns[] = {SamplePattern(64), SamplePattern(64), SamplePattern(100),
                                           SamplePattern(256)};
  for (std::size_t i = 0; i < watchers.count(); ++i) {
    const bool is_dropped = claims.dropped >> i & 1, is_covered = claims.covered >> i & 1;
    const trials::Judgement judged = trials::judge_rays(watchers.light, watchers.receivers[i],
                                                        patterns[random.below(4)], 24, random);
    const std::vector<std::uint32_t> blocked = blocked_rays(record, judged.rays);
    std::uint32_t any = 0, all = 0;
    for (std::size_t word = 0; word < blocked.size(); ++word) {
      any |= blocked[word] & judged.active[word];
      all += static_cast<std::uint32_t>(std::popcount(blocked[word]));
    }
    ++count.receivers;
    count.free += any == 0, count.dropped += is_dropped;
    count.hidden += all == judged.rays.count, count.covered += is_covered;
    ASSERT_TRUE(any == 0 || !is_dropped) << "receiver " << i;
    ASSERT_TRUE(any == 0 || !claims.dropped_for_all) << "receiver " << i;
    ASSERT_TRUE(all == judged.rays.count || !is_covered) << "receiver " << i;
    ASSERT_TRUE(all == judged.rays.count || !claims.covered_for_all) << "receiver " << i;
    judge_part(list, seen_by_one(watchers.form, watchers.rows, i), record, judged, random, sifts);
    if (testing::Test::HasFatalFailure()) return;
    count.dropped_for_all += claims.dropped_for_all;
    count.covered_for_all += claims.covered_for_all;
  }
}

/// Which claim is led to where it is nearly wrong.
enum class Claim { dropped, dropped_for_all, covered, covered_for_all };

bool holds(Claim claim, const Claims& claims) {
  switch (claim) {
    case Claim::dropped: return claims.dropped & 1;
    case Claim::dropped_for_all: return claims.dropped_for_all;
    case Claim::covered: return claims.covered & 1;
    case Claim::covered_for_all: return claims.covered_for_all;
  }
  return false;
}

void try_one(const Record& record, const GroupTrial& trial, Random& random, Count& count) {
  static Sifts sifts;
  const auto list = list_of(record, random.one_in(3) ? 1 + random.below(40) : 1);
  const auto claim = static_cast<Claim>(random.below(record.kind == ShapeKind::sphere ? 4 : 2));
  const auto is_held = [&](double t) {
    const Watchers watchers(trial.light(t), trial.queries(), bounds(record));
    return watchers.count() > 0 && holds(claim, claims_of(*list, watchers, sifts));
  };
  const auto [t, is_critical] = trials::critical(is_held);
  const Watchers watchers(trial.light(t), trial.queries(), bounds(record));
  if (watchers.count() == 0) return;
  const Claims claims = claims_of(*list, watchers, sifts);
  ++count.trials, count.critical += is_critical;
  expect_rows_agree(*list, watchers, claims, random, sifts);
  if (!testing::Test::HasFatalFailure())
    judge(*list, record, watchers, claims, random, sifts, count);
}

Count run_pair(const ShapeForm& form, const char* light_kind, std::uint64_t receivers,
               std::uint64_t first_seed) {
  Count count;
  for_each_seed(first_seed, count.receivers, receivers, [&](Random& random) {
    const nasty::Place place = nasty::random_place(random);
    const ShapeSet shapes = random_shape(form, place, random);
    const Kernel kernel(shapes, {KernelKind::brute, {}});
    const auto place_one = [&] {
      if (const auto own = trials::own_point(shapes, kernel, place, random))
        return Receiver{receiver_position(*own), Vec3f(own->normal)};
      return Receiver{place(random.in_cube() * 2.0f), trials::random_direction(random)};
    };
    for (int i = 0; i < 32; ++i) {
      const auto first = trials::offset_trial(shapes, kernel, place, light_kind, random);
      const GroupTrial trial(light_kind, first, double(place.scale), place_one, random);
      try_one(kernel.records()[0], trial, random, count);
      if (testing::Test::HasFatalFailure()) return;
    }
  });
  return count;
}

using SiftTrials = EveryPair;
using SlowSiftTrials = EveryPair;

TEST_P(SiftTrials, NothingThatBlocksIsDroppedAndNothingPassesACover) {
  const Count count = run_pair(form(), light_kind(), 1'500, 0);
  EXPECT_GT(count.dropped, count.free * 3 / 10);
  EXPECT_GT(count.dropped_for_all, count.free / 6);
  EXPECT_GT(count.critical, count.trials / 25);
  if (form().kind == ShapeKind::sphere) {
    EXPECT_GT(count.covered, count.hidden / 2);
    EXPECT_GT(count.covered_for_all, count.hidden / 5);
  }
}

TEST_P(SlowSiftTrials, NothingThatBlocksIsDroppedAndNothingPassesACover) {
  run_pair(form(), light_kind(), 1'000'000, 1'000'000);
}

auto pairs_with_extent() {
  return testing::Combine(testing::ValuesIn(shape_forms),
                          testing::ValuesIn(light_kinds.begin() + 1, light_kinds.end()));
}
INSTANTIATE_TEST_SUITE_P(Pairs, SiftTrials, pairs_with_extent(), name_of_pair);
INSTANTIATE_TEST_SUITE_P(Pairs, SlowSiftTrials, pairs_with_extent(), name_of_pair);

}  // namespace
}  // namespace penumbra
