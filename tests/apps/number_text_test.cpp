// SPDX-License-Identifier: MIT
#include "number_text.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>

namespace penumbra::reproduce {
namespace {

TEST(Grouped, ByThreeDigitsWithOrWithoutSign) {
  EXPECT_EQ(grouped(0), "0");
  EXPECT_EQ(grouped(-999), "-999");
  EXPECT_EQ(grouped(1397529), "1,397,529");
  EXPECT_EQ(grouped(-100000), "-100,000");
  EXPECT_EQ(grouped(std::numeric_limits<std::int64_t>::min()), "-9,223,372,036,854,775,808");
}

TEST(Rounded, ToThreeDigits) {
  EXPECT_EQ(rounded(0.41349), "0.413");
  EXPECT_EQ(rounded(12.149), "12.1");
  EXPECT_EQ(rounded(99.96), "100");
  EXPECT_EQ(rounded(0.09996), "0.100");
  EXPECT_EQ(rounded(999.7), "1,000");
  EXPECT_EQ(rounded(1234567), "1,230,000");
  EXPECT_EQ(rounded(-1089.4), "-1,090");
  EXPECT_EQ(rounded(0.0021), "0.00210");
}

TEST(Rounded, WhatHasNoPlaceInATable) {
  EXPECT_EQ(rounded(0), "0");
  EXPECT_EQ(rounded(std::numeric_limits<double>::infinity()), "-");
  EXPECT_EQ(rounded(std::numeric_limits<double>::quiet_NaN()), "-");
  EXPECT_EQ(rounded(1e-30), "1.00e-30");
  EXPECT_EQ(rounded(-3e40), "-3.00e+40");
}

}  // namespace
}  // namespace penumbra::reproduce
