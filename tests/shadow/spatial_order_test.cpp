// SPDX-License-Identifier: MIT
#include "penumbra/shadow/spatial_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

namespace penumbra {
namespace {

ShadowQuery at(float x, float y, float z) { return {{{x, y, z}, {0, 0, 1}}, 0}; }

/// A grid of 16 x 16 receivers, row by row.
std::vector<ShadowQuery> grid() {
  std::vector<ShadowQuery> queries;
  for (int i = 0; i < 256; ++i)
    queries.push_back(at(static_cast<float>(i % 16), static_cast<float>(i / 16), 0));
  return queries;
}

std::vector<ShadowQuery> in_order(const std::vector<ShadowQuery>& queries) {
  std::vector<std::uint32_t> order;
  order_in_space(queries, order);
  std::vector<ShadowQuery> ordered;
  for (const std::uint32_t i : order) ordered.push_back(queries[i]);
  return ordered;
}

TEST(SpatialOrder, HoldsEveryQueryOnceEvenThoseThatAreNoNumbers) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  constexpr float infinity = std::numeric_limits<float>::infinity();
  std::vector<ShadowQuery> queries = grid();
  queries.push_back(at(nan, 0, 0)), queries.push_back(at(infinity, -infinity, 1));
  std::vector<std::uint32_t> order;
  order_in_space(queries, order);
  ASSERT_EQ(order.size(), queries.size());
  std::sort(order.begin(), order.end());
  for (std::uint32_t i = 0; i < order.size(); ++i) EXPECT_EQ(order[i], i);
}

TEST(SpatialOrder, MakesRunsOfAShuffledGridNarrow) {
  std::vector<ShadowQuery> queries = grid();
  std::shuffle(queries.begin(), queries.end(), std::mt19937(5));
  EXPECT_TRUE(is_scattered(queries, 64));
  EXPECT_FALSE(is_scattered(in_order(queries), 64));
}

TEST(SpatialOrder, LeavesOneRunAndNoneAlone) {
  EXPECT_FALSE(is_scattered({}, 64));
  EXPECT_FALSE(is_scattered(std::vector(64, at(1, 2, 3)), 64));
  EXPECT_TRUE(in_order({}).empty());
}

}  // namespace
}  // namespace penumbra
