// SPDX-License-Identifier: MIT
// Sheets against the judge: no ray passes by the triangles of one that covers.
#include "penumbra/shadow/sheet.h"
#include "tests/shadow/group_trials.h"
#include "tests/shadow/seeds.h"
#include "tests/shadow/sheet_meshes.h"

namespace penumbra {
namespace {

using nasty::Random;
using trials::GroupTrial;
using trials::Watchers;

struct Count {
  std::uint64_t trials = 0, proven = 0, critical = 0, receivers = 0, of_groups = 0, triangles = 0;
};

/// Sheets and a hierarchy of them.
struct Sheets {
  explicit Sheets(const ShapeSet& shapes_)
      : shapes(shapes_),
        kernel(shapes, {KernelKind::wide, {false, true}}),
        sheet(shapes, kernel.records()) {}
  ShapeSet shapes;
  Kernel kernel;
  TriangleSheet sheet;
};

/// One question about some receivers of a trial.
struct Question {
  std::uint32_t most_triangles;
  std::uint32_t start;  ///< or `no_record`: what stands before the light's centre
  bool asks_one;
};

SeenLight sight_of(const Watchers& watchers, bool asks_one) {
  return asks_one ? seen_by_one(watchers.form, watchers.rows, 0)
                  : seen_by_all(watchers.form, watchers.group(0, watchers.count()));
}

bool covers(const Sheets& sheets, const Watchers& watchers, const Question& question,
            SheetScratch& scratch) {
  if (watchers.count() == 0) return false;
  const SeenLight sight = sight_of(watchers, question.asks_one);
  std::uint32_t start = question.start;
  if (start == no_record) {
    Ray ray{sight.p, sight.way};
    ray.t_max = 1;
    start = sheets.kernel.closest_record(ray);
  }
  std::uint64_t tests = 0;
  return start != no_record && sheet_covers(sheets.sheet, sheets.kernel.records(), sight, start,
                                            question.most_triangles, scratch, tests);
}

/// A receiver that looks at a triangle, and a light behind it, before it, or through it.
trials::OffsetTrial look_at_triangle(const Sheets& sheets, const nasty::Place& place,
                                     const char* light_kind, Random& random) {
  const std::vector<ShapeRef> refs = all_primitives(sheets.shapes);
  const Vec3d aim(nasty::point_of_interest(
      sheets.shapes, refs[random.below(static_cast<std::uint32_t>(refs.size()))], random));
  const Vec3d way = random.direction();
  const double scale = double(place.scale);
  const auto far = [&] { return scale * double(random.power(random.one_in(3) ? -6 : -1, 1)); };
  const Vec3f p(aim - way * far());
  const Vec3d center = aim + way * (random.one_in(10) ? -far() : far());
  const LightFigure figure = random_figure(random);
  const double size = scale * double(random.power(-2, 0.5f));
  const Vec3f normal(random.one_in(3) ? random.direction() : way);
  return {make_light(light_kind, figure, center, size, p), p, normal, figure, center, size};
}

void judge(const Sheets& sheets, const Watchers& watchers, const Question& question,
           const SheetScratch& scratch, Random& random, Count& count) {
  static const SamplePattern pattern(64);
  std::vector<std::uint32_t> members;
  for (const TriangleSheet::Member& member : scratch.found()) members.push_back(member.record);
  count.triangles += members.size();
  for (std::size_t i = 0; i < (question.asks_one ? 1 : watchers.count()); ++i) {
    const Vec3f p = watchers.receivers[i].position;
    const LightSamples rays = judging_rays(watchers.light, p, pattern, 32, random);
    const std::vector<std::uint32_t> active(rays.count / 32, ~0u);
    std::vector<std::uint32_t> blocked(active.size());
    occluded_among(sheets.kernel.records(), members, rays, active, blocked);
    ASSERT_EQ(blocked, active) << "receiver " << i << " of " << watchers.count() << ", "
                               << members.size() << " triangles";
    ++count.receivers;
  }
}

void try_one(const Sheets& sheets, const nasty::Place& place, const char* light_kind,
             Random& random, Count& count) {
  static SheetScratch scratch;
  const auto place_one = [&] {
    const auto other = look_at_triangle(sheets, place, light_kind, random);
    return Receiver{other.p, other.normal};
  };
  const auto first = look_at_triangle(sheets, place, light_kind, random);
  const GroupTrial trial(light_kind, first, double(place.scale), place_one, random);
  const auto records = static_cast<std::uint32_t>(sheets.kernel.records().size());
  const Question question{random.one_in(3) ? 1 + random.below(64) : SheetScratch::most,
                          random.one_in(10) ? random.below(records) : no_record, random.one_in(2)};
  const Box box = bounds(sheets.shapes);
  const auto is_covered = [&](double t) {
    return covers(sheets, Watchers(trial.light(t), trial.queries(), box), question, scratch);
  };
  const auto [t, is_critical] = trials::critical(is_covered);
  ++count.trials, count.critical += is_critical;
  for (const double at : {t, 0.5 * t, 0.0}) {
    const Watchers watchers(trial.light(at), trial.queries(), box);
    if (!covers(sheets, watchers, question, scratch)) continue;
    ++count.proven, count.of_groups += !question.asks_one && watchers.count() > 1;
    judge(sheets, watchers, question, scratch, random, count);
  }
}

Count run_light(const char* light_kind, std::uint64_t trials, std::uint64_t first_seed) {
  Count count;
  for_each_seed(first_seed, count.trials, trials, [&](Random& random) {
    const nasty::Place place = nasty::random_place(random);
    const ShapeSet shapes = nasty::random_sheets(place, random);
    if (shapes.meshes.empty()) return;
    const Sheets sheets(shapes);
    for (int i = 0; i < 64; ++i) {
      try_one(sheets, place, light_kind, random, count);
      if (testing::Test::HasFatalFailure()) return;
    }
  });
  return count;
}

class SheetTrials : public testing::TestWithParam<const char*> {};
using SlowSheetTrials = SheetTrials;

TEST_P(SheetTrials, NoRayPassesByASheetThatCovers) {
  const Count count = run_light(GetParam(), 5'000, 0);
  EXPECT_GT(count.proven, count.trials / 2);
  EXPECT_GT(count.critical, count.trials / 10);
  EXPECT_GT(count.of_groups, count.trials / 10);
  EXPECT_GT(count.triangles, 4 * count.proven);
}

TEST_P(SlowSheetTrials, NoRayPassesByASheetThatCovers) {
  run_light(GetParam(), 1'000'000, 1'000'000);
}

const auto lights = testing::ValuesIn(light_kinds.begin() + 1, light_kinds.end());
const auto name_of_light = [](const auto& test) { return std::string(test.param); };
INSTANTIATE_TEST_SUITE_P(Under, SheetTrials, lights, name_of_light);
INSTANTIATE_TEST_SUITE_P(Under, SlowSheetTrials, lights, name_of_light);

}  // namespace
}  // namespace penumbra
