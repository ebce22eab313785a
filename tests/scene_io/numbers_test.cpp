// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/numbers.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace penumbra {
namespace {

TEST(Numbers, take_the_forms_of_c_and_nothing_else) {
  EXPECT_EQ(parse_float("1.5"), 1.5f);
  EXPECT_EQ(parse_float("+1.5e1"), 15.0f);
  EXPECT_EQ(parse_float("-.5"), -0.5f);
  EXPECT_EQ(parse_float("1.11022e-16"), 1.11022e-16f);
  for (const char* bad : {"", "+", "-", "+-1", "++1", "1,5", "1.5x", "0x10", "e5", "."})
    EXPECT_FALSE(parse_float(bad)) << bad;
  EXPECT_EQ(parse_integer("+7"), 7);
  EXPECT_FALSE(parse_integer("7.0"));
  EXPECT_FALSE(parse_integer("99999999999999999999"));
}

TEST(Numbers, beyond_the_range_become_infinite_or_zero) {
  constexpr float infinite = std::numeric_limits<float>::infinity();
  EXPECT_EQ(parse_float("1e39"), infinite);
  EXPECT_EQ(parse_float("-1e99999999999999999999"), -infinite);
  EXPECT_EQ(parse_float("1e-99999999999999999999"), 0.0f);
  EXPECT_EQ(parse_float("1" + std::string(400, '0')), infinite);
  EXPECT_EQ(parse_float("0." + std::string(400, '0') + "1"), 0.0f);
  EXPECT_EQ(parse_double("0." + std::string(400, '0') + "1e402"), 10.0);
  EXPECT_EQ(parse_double("1" + std::string(400, '0') + "e-400"), 1.0);
  EXPECT_TRUE(std::isnan(*parse_float("nan")));
  EXPECT_EQ(parse_float("inf"), infinite);
}

TEST(Numbers, written_read_back_to_the_same_bits) {
  std::uint32_t bits = 1;
  for (int i = 0; i < 20000; ++i) {
    bits = bits * 1664525u + 1013904223u;
    const float value = std::bit_cast<float>(bits);
    if (!std::isfinite(value)) continue;
    const std::optional<float> back = parse_float(to_text(value));
    ASSERT_TRUE(back) << to_text(value);
    EXPECT_EQ(std::bit_cast<std::uint32_t>(*back), bits) << to_text(value);
    const double wide = static_cast<double>(value) * 1.000000001;
    EXPECT_EQ(parse_double(to_text(wide)), wide);
  }
  EXPECT_EQ(to_text(0.1f), "0.1");
  EXPECT_EQ(to_text(2.61313f), "2.61313");
  EXPECT_EQ(to_text(-0.0f), "-0");
}

TEST(Numbers, quotes_are_short_and_printable) {
  EXPECT_EQ(in_quotes("ab\x01\xff"), "`ab??`");
  EXPECT_LT(in_quotes(std::string(1000, 'a')).size(), 50u);
}

}  // namespace
}  // namespace penumbra
