// SPDX-License-Identifier: MIT
#include "penumbra/trace/dilate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace penumbra {
namespace {

constexpr std::uint32_t width = 40, height = 30;

double distance(std::size_t a, std::size_t b) {
  const double dx = double(a % width) - double(b % width),
               dy = double(a / width) - double(b / width);
  return std::hypot(dx, dy);
}

TEST(NearestCovered, FillsWhatIsWithinThePaddingFromTheNearest) {
  std::mt19937 generator(3);
  for (int trial = 0; trial < 30; ++trial) {
    std::vector<std::uint8_t> covered(width * height, 0);
    for (int i = 0; i < 1 + trial; ++i) covered[generator() % covered.size()] = 1;
    const auto padding = static_cast<std::uint32_t>(trial % 9);
    const std::vector<std::uint32_t> source = nearest_covered(covered, width, height, padding);
    for (std::size_t i = 0; i < covered.size(); ++i) {
      double least = 1e9;
      for (std::size_t k = 0; k < covered.size(); ++k)
        if (covered[k] != 0) least = std::min(least, distance(i, k));
      if (source[i] == no_texel) {
        EXPECT_GT(least, padding);
        continue;
      }
      ASSERT_NE(covered[source[i]], 0);
      EXPECT_LE(distance(i, source[i]), padding);
      EXPECT_EQ(distance(i, source[i]), least);
    }
  }
}

TEST(NearestCovered, LeavesCoveredTexelsAndEmptyTexturesAlone) {
  std::vector<std::uint8_t> covered(width * height, 1);
  const std::vector<std::uint32_t> source = nearest_covered(covered, width, height, 8);
  for (std::uint32_t i = 0; i < source.size(); ++i) EXPECT_EQ(source[i], i);
  covered.assign(covered.size(), 0);
  for (const std::uint32_t s : nearest_covered(covered, width, height, 8)) EXPECT_EQ(s, no_texel);
}

}  // namespace
}  // namespace penumbra
