// SPDX-License-Identifier: MIT
#include "line_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace penumbra::reproduce {
namespace {

TEST(FitLine, FindsALineAndNoDoubt) {
  const std::vector<Point> points{{1, 5}, {8, 19}, {512, 1027}};
  const FittedLine fit = fit_line(points);
  EXPECT_NEAR(fit.line.slope, 2, 1e-12);
  EXPECT_NEAR(fit.line.intercept, 3, 1e-10);
  EXPECT_NEAR(fit.slope_error, 0, 1e-12);
}

/// Of four points around y = x: slope 1, residuals ±1, sum of squares of x 5.
TEST(FitLine, TellsItsStandardError) {
  const std::vector<Point> points{{0, 1}, {1, 0}, {2, 1}, {3, 4}};
  const FittedLine fit = fit_line(points);
  EXPECT_NEAR(fit.line.slope, 1, 1e-12);
  EXPECT_NEAR(fit.slope_error, std::sqrt(4.0 / 2 / 5), 1e-12);
}

TEST(FitLine, TwoPointsLeaveAllDoubt) {
  const std::vector<Point> points{{0, 1}, {1, 2}};
  EXPECT_TRUE(std::isinf(fit_line(points).slope_error));
}

TEST(SlopeRatio, IsABoundWhereTheLineMayBeLevel) {
  const FittedLine steep{{0, 10}, 0.1};
  EXPECT_EQ(slope_ratio(steep, {{0, 2}, 0.5}).times, 5);
  EXPECT_FALSE(slope_ratio(steep, {{0, 2}, 0.5}).is_bound);
  const SlopeRatio doubtful = slope_ratio(steep, {{0, 0.5}, 1});
  EXPECT_TRUE(doubtful.is_bound);
  EXPECT_EQ(doubtful.times, 4);
  EXPECT_EQ(slope_ratio(steep, {{0, -3}, 1}).times, 5);
}

}  // namespace
}  // namespace penumbra::reproduce
