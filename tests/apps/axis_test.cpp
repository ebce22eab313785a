// SPDX-License-Identifier: MIT
#include "axis.h"

#include <gtest/gtest.h>

#include <limits>

namespace penumbra::reproduce {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(AxisAround, LinearAxesBeginAtZeroWhereThatIsNear) {
  EXPECT_EQ(axis_around({1, 9, 100}, false).low, 0);
  EXPECT_GT(axis_around({1, 9, 100}, false).high, 100);
  EXPECT_GT(axis_around({90, 100}, false).low, 80);
  EXPECT_LT(axis_around({-5, 100}, false).low, -5);
}

TEST(AxisAround, AnyValuesGiveAnAxisOfSomeLength) {
  for (bool has_log : {false, true})
    for (const auto& values : std::vector<std::vector<double>>{
             {}, {0}, {7}, {-3}, {1e-9}, {infinity, -infinity, infinity - infinity}, {-1, 0}}) {
      const Axis axis = axis_around(values, has_log);
      EXPECT_LT(axis.low, axis.high);
      EXPECT_TRUE(!has_log || axis.low > 0);
    }
}

TEST(LogTics, ArePlainNumbersInStepsOf125) {
  EXPECT_EQ(log_tics({0.45, 11, true}),
            R"(("0.5" 0.5, "" 0.6 1, "" 0.7 1, "" 0.8 1, "" 0.9 1, "1" 1, "2" 2, "" 3 1, "" 4 1, )"
            R"("5" 5, "" 6 1, "" 7 1, "" 8 1, "" 9 1, "10" 10))");
}

TEST(LogTics, ArePowersOfTenWhereNumbersWouldBeLong) {
  const std::string tics = log_tics({10, 2e6, true});
  EXPECT_NE(tics.find(R"("10^{6}" 1e+06)"), tics.npos);
  EXPECT_EQ(tics.find("\"2"), tics.npos);
}

}  // namespace
}  // namespace penumbra::reproduce
