// SPDX-License-Identifier: MIT
#include "penumbra/kernel/traverse.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <string>

#include "penumbra/kernel/kernel.h"
#include "tests/geometry/instruction_sets.h"
#include "tests/kernel/nasty_shapes.h"

namespace penumbra {
namespace {

/// Everything a kernel says about a row of random cases, as bits.
struct Answers {
  std::string instruction_set;
  std::vector<std::uint32_t> words;
};

void ask(const Kernel& kernel, const LightSamples& rays, std::vector<std::uint32_t>& words) {
  const std::size_t count = (rays.count + 31) / 32;
  std::vector<std::uint32_t> active(count, 0xffffffffu), blocked(count);
  active.back() >>= 32 * count - rays.count;
  const std::uint64_t tests = kernel.occluded(rays, active, blocked).tests;
  words.insert(words.end(), blocked.begin(), blocked.end());
  words.push_back(static_cast<std::uint32_t>(tests));
  const auto nearest = kernel.closest({rays.origin, {rays.x[0], rays.y[0], rays.z[0]}});
  words.push_back(nearest.tests);
  words.push_back(nearest.hit ? nearest.hit->shape.index : 0xffffffffu);
  words.push_back(nearest.hit ? nearest.hit->shape.triangle : 0xffffffffu);
  std::uint32_t t = 0;
  if (nearest.hit) std::memcpy(&t, &nearest.hit->t, sizeof t);
  words.push_back(t);
}

Answers ask_all() {
  nasty::Random random(31);
  Answers answers{instruction_set(), {}};
  for (int round = 0; round < 40; ++round)
    for (ShapeKind kind :
         {ShapeKind::sphere, ShapeKind::cone, ShapeKind::ring, ShapeKind::triangle}) {
      const nasty::Place place = nasty::random_place(random);
      const ShapeSet shapes = nasty::random_shapes(kind, 2 + random.below(60), place, random);
      const std::vector<ShapeRef> refs = all_primitives(shapes);
      if (refs.empty()) continue;
      const Kernel kernel(shapes, {});
      for (int packet = 0; packet < 20; ++packet)
        ask(kernel, nasty::random_packet(shapes, refs, place, 1 + random.below(70), random),
            answers.words);
    }
  return answers;
}

/// A row of random scenes with a packet of rays each.
template <class F>
void for_random_packets(std::uint64_t seed, F&& f) {
  nasty::Random random(seed);
  for (int round = 0; round < 200; ++round) {
    const auto kind = static_cast<ShapeKind>(round % 4);
    const nasty::Place place = nasty::random_place(random);
    const ShapeSet shapes = nasty::random_shapes(kind, 2 + random.below(60), place, random);
    const std::vector<ShapeRef> refs = all_primitives(shapes);
    if (refs.empty()) continue;
    const Kernel kernel(shapes, {});
    f(kernel, nasty::random_packet(shapes, refs, place, 1 + random.below(70), random));
  }
}

TEST(Traverse, TheBlockerThatIsReportedBlocksSomeRay) {
  int found = 0;
  for_random_packets(5, [&](const Kernel& kernel, const LightSamples& rays) {
    const std::size_t count = (rays.count + 31) / 32;
    std::vector<std::uint32_t> active(count, 0xffffffffu), blocked(count), by_one(count);
    active.back() >>= 32 * count - rays.count;
    const OccludedReport report = kernel.occluded(rays, active, blocked);
    const bool any = blocked != std::vector<std::uint32_t>(count);
    ASSERT_EQ(report.blocker != no_record, any);
    if (!any) return;
    occluded_among(kernel.records(), {&report.blocker, 1}, rays, active, by_one);
    EXPECT_NE(by_one, std::vector<std::uint32_t>(count));
    for (std::size_t word = 0; word < count; ++word) EXPECT_EQ(by_one[word] & ~blocked[word], 0u);
    ++found;
  });
  EXPECT_GT(found, 50);
}

TEST(Traverse, OneRecordBlocksWhatBruteForceSaysItBlocks) {
  for_random_packets(6, [&](const Kernel& kernel, const LightSamples& rays) {
    const std::size_t count = (rays.count + 31) / 32;
    std::vector<std::uint32_t> active(count, 0xffffffffu), lanes(count), one(count);
    active.back() >>= 32 * count - rays.count;
    for (std::uint32_t i = 0; i < kernel.records().size(); ++i) {
      occluded_among(kernel.records(), {&i, 1}, rays, active, lanes);
      const Record record = kernel.records()[i];
      occluded_brute({&record, 1}, rays, active, one);
      ASSERT_EQ(lanes, one);
    }
  });
}

TEST(Traverse, AWalkPassesEveryRecordThatItsRayMeets) {
  int met = 0;
  for_random_packets(7, [&](const Kernel& kernel, const LightSamples& rays) {
    std::vector<Box> boxes;
    for (const Record& record : kernel.records().own()) boxes.push_back(bounds(record));
    const BoxTree tree = build_box_tree(boxes);
    const std::uint32_t active = 1;
    std::vector<std::uint32_t> blocked((rays.count + 31) / 32);
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
      occluded_brute({&kernel.records().own()[i], 1}, rays, std::vector(blocked.size(), active),
                     blocked);
      if (!(blocked[0] & 1)) continue;
      ++met;
      const auto holds_it = [&](std::uint32_t first, std::uint32_t count) {
        return std::count(&tree.order[first], &tree.order[first] + count, i) > 0;
      };
      EXPECT_TRUE(walk(tree.nodes,
                       Ray{rays.origin, {rays.x[0], rays.y[0], rays.z[0]}, 0, rays.t_max},
                       holds_it));
    }
  });
  EXPECT_GT(met, 100);
}

/// Lanes of 4, 8 and 16 rays give the same hits, the same t and the same counts.
TEST(Traverse, EveryInstructionSetGivesTheSameBits) {
  const Answers expected = ask_all();
  std::string seen;
  for_each_instruction_set([&] {
    const Answers answers = ask_all();
    EXPECT_EQ(answers.words, expected.words);
    seen += answers.instruction_set + " ";
  });
  RecordProperty("instruction_sets", seen);
}

}  // namespace
}  // namespace penumbra
