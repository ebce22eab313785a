// SPDX-License-Identifier: MIT
#include "penumbra/kernel/wide_tree.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cstring>

#include "tests/kernel/nasty_shapes.h"

namespace penumbra {
namespace {

std::vector<Record> random_records(std::uint32_t count, std::uint64_t seed) {
  nasty::Random random(seed);
  const ShapeSet shapes = nasty::random_shapes(ShapeKind::triangle, count, {}, random);
  std::vector<Record> records;
  for (const ShapeRef ref : all_primitives(shapes))
    records.push_back(make_record(shapes, ref, static_cast<std::uint32_t>(records.size())));
  return records;
}

/// Walks a tree: counts how often each record is met and returns the exact box of all below.
Box walk(const WideTree& tree, NodeRef ref, std::vector<int>& met, int& failures) {
  Box box;
  if (ref.is_leaf()) {
    for (std::uint32_t i = 0; i < ref.count(); ++i) {
      const Record& record = tree.records[ref.first() + i];
      ++met[record.id];
      box.add(bounds(record));
    }
    return box;
  }
  const WideNode& node = tree.nodes[ref.node()];
  for (int child = 0; child < WideNode::width; ++child) {
    if (!(node.used >> child & 1)) continue;
    const Box below = walk(tree, node.child[child], met, failures);
    const Box stored{{node.lo[0][child], node.lo[1][child], node.lo[2][child]},
                     {node.hi[0][child], node.hi[1][child], node.hi[2][child]}};
    failures += !stored.contains(below);
    box.add(stored);
  }
  return box;
}

TEST(WideTree, HoldsEveryRecordOnceInBoxesThatContainIt) {
  for (std::uint32_t count : {1u, 2u, 7u, 8u, 9u, 17u, 100u, 10'000u}) {
    const std::vector<Record> records = random_records(count, count);
    const WideTree tree = build_wide_tree(records);
    std::vector<int> met(records.size(), 0);
    int failures = 0;
    walk(tree, NodeRef::inner(0), met, failures);
    EXPECT_EQ(failures, 0) << count;
    EXPECT_EQ(std::count(met.begin(), met.end(), 1), static_cast<std::ptrdiff_t>(count));
  }
}

TEST(WideTree, ManyEqualBoxesStillMakeATree) {
  std::vector<Record> records(5000, random_records(1, 1).front());
  for (std::uint32_t i = 0; i < records.size(); ++i) records[i].id = i;
  const WideTree tree = build_wide_tree(records);
  std::vector<int> met(records.size(), 0);
  int failures = 0;
  walk(tree, NodeRef::inner(0), met, failures);
  EXPECT_EQ(failures, 0);
  EXPECT_EQ(std::count(met.begin(), met.end(), 1), 5000);
}

TEST(WideTree, DoesNotDependOnTheNumberOfThreads) {
  const std::vector<Record> records = random_records(60'000, 9);
  const auto build = [&](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return build_wide_tree(records);
  };
  const WideTree one = build(1), seven = build(7);
  ASSERT_EQ(one.nodes.size(), seven.nodes.size());
  EXPECT_EQ(std::memcmp(one.nodes.data(), seven.nodes.data(), one.nodes.size() * sizeof(WideNode)),
            0);
  EXPECT_EQ(
      std::memcmp(one.records.data(), seven.records.data(), one.records.size() * sizeof(Record)),
      0);
}

}  // namespace
}  // namespace penumbra
