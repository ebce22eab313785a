// SPDX-License-Identifier: MIT
#include "penumbra/geometry/sample_pattern.h"

#include "tests/geometry/chi_squared.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <set>
#include <utility>

namespace penumbra {
namespace {

struct Points {
  std::vector<float> u, v;
};

Points points_of(const SamplePattern& pattern, std::uint64_t key) {
  Points points{std::vector<float>(pattern.size()), std::vector<float>(pattern.size())};
  pattern.scramble(key, points.u, points.v);
  return points;
}

TEST(Hash, EveryInputBitFlipsHalfTheOutput) {
  for (int bit = 0; bit < 64; ++bit)
    for (const std::uint64_t step : {std::uint64_t{1}, std::uint64_t{1} << 40}) {
      double flips_a = 0, flips_b = 0;
      for (std::uint64_t i = 0; i < 1000; ++i) {
        const std::uint64_t a = i * step, b = 1000 - i, flip = std::uint64_t{1} << bit;
        flips_a += std::popcount(hash(a, b) ^ hash(a ^ flip, b));
        flips_b += std::popcount(hash(a, b) ^ hash(a, b ^ flip));
      }
      EXPECT_NEAR(flips_a / 1000, 32, 0.8);
      EXPECT_NEAR(flips_b / 1000, 32, 0.8);
    }
  EXPECT_NE(hash(1, 2), hash(2, 1));
}

// Property (1).
TEST(SamplePattern, EachPointIsUniformOverTheKeys) {
  constexpr int keys = 50'000, side = 16;
  for (const std::uint32_t d : {1u, 3u, 32u, 50u}) {
    const SamplePattern pattern(d);
    std::vector<std::vector<double>> counts(d, std::vector<double>(side * side));
    for (std::uint64_t key = 0; key < keys; ++key) {
      const Points points = points_of(pattern, key * 0x10001);
      for (std::uint32_t i = 0; i < d; ++i) {
        const int x = static_cast<int>(points.u[i] * side);
        ++counts[i][x * side + static_cast<int>(points.v[i] * side)];
      }
    }
    for (std::uint32_t i = 0; i < d; ++i) {
      const double deviate = chi_squared_deviate(counts[i], std::vector<double>(side * side, 1));
      EXPECT_LT(std::abs(deviate), 4.2) << "point " << i << " of " << d;
    }
  }
}

TEST(SamplePattern, PointsOfAPairAreUncorrelatedBeyondTheNet) {
  // The two points of d = 2 lie in different halves; within them they know nothing of each other.
  constexpr int keys = 50'000, side = 8;
  const SamplePattern pattern(2);
  std::vector<double> counts(side * side);
  for (std::uint64_t key = 0; key < keys; ++key) {
    const Points points = points_of(pattern, key);
    const auto within = [](float u) { return static_cast<int>(std::fmod(2 * u, 1.0f) * side); };
    ++counts[within(points.u[0]) * side + within(points.u[1])];
  }
  EXPECT_LT(chi_squared_deviate(counts, std::vector<double>(side * side, 1)), 4);
}

// Property (2).
TEST(SamplePattern, EachElementaryIntervalHoldsOnePoint) {
  for (int m = 0; m <= 10; ++m) {
    const std::uint32_t d = 1u << m;
    const SamplePattern pattern(d);
    for (const std::uint64_t key : {0ull, 1ull, 77ull, 0xffffffffffffffffull, 1ull << 63}) {
      const Points points = points_of(pattern, key);
      for (int split = 0; split <= m; ++split) {
        const auto columns = static_cast<float>(1u << split);
        const auto rows = static_cast<float>(1u << (m - split));
        std::set<std::pair<int, int>> cells;
        for (std::uint32_t i = 0; i < d; ++i)
          cells.insert(
              {static_cast<int>(points.u[i] * columns), static_cast<int>(points.v[i] * rows)});
        EXPECT_EQ(cells.size(), d) << "m " << m << ", split " << split << ", key " << key;
      }
    }
  }
}

TEST(SamplePattern, AlignedRunsShareASquareOrHalfOfOne) {
  const SamplePattern pattern(256);
  const Points points = points_of(pattern, 5);
  for (int k = 0; k <= 8; ++k) {
    const auto columns = static_cast<float>(1 << (8 - k + 1) / 2);
    const auto rows = static_cast<float>(1 << (8 - k) / 2);
    for (std::uint32_t i = 0; i < 256; ++i) {
      const std::uint32_t first = i >> k << k;
      EXPECT_EQ(std::floor(points.u[i] * columns), std::floor(points.u[first] * columns));
      EXPECT_EQ(std::floor(points.v[i] * rows), std::floor(points.v[first] * rows));
    }
  }
}

// Property (3).
TEST(SamplePattern, SameKeySamePoints) {
  const Points a = points_of(SamplePattern(37), 9), b = points_of(SamplePattern(37), 9);
  EXPECT_EQ(a.u, b.u);
  EXPECT_EQ(a.v, b.v);
  EXPECT_NE(a.u, points_of(SamplePattern(37), 10).u);
}

TEST(SamplePattern, PointsLieInTheHalfOpenSquare) {
  const SamplePattern pattern(1000);
  for (std::uint64_t key = 0; key < 1000; ++key) {
    const Points points = points_of(pattern, key);
    for (std::uint32_t i = 0; i < 1000; ++i) {
      ASSERT_TRUE(points.u[i] >= 0 && points.u[i] < 1);
      ASSERT_TRUE(points.v[i] >= 0 && points.v[i] < 1);
    }
  }
}

TEST(SamplePattern, NoPointsIsAPatternToo) {
  const SamplePattern pattern(0);
  EXPECT_EQ(points_of(pattern, 1).u.size(), 0u);
}

}  // namespace
}  // namespace penumbra
