// SPDX-License-Identifier: MIT
#include "csv.h"

#include <gtest/gtest.h>

namespace penumbra::reproduce {
namespace {

using Lines = std::vector<std::vector<std::string>>;

TEST(Csv, ReadsWhatItWrote) {
  const Lines lines{{"a", "", "b,c"}, {"\"quoted\"", "two\nlines", "\r"}, {""}};
  std::string text;
  for (const auto& line : lines) text += csv_line(line);
  EXPECT_EQ(read_csv(text), lines);
}

TEST(Csv, EndsOfLinesOfAnyKind) { EXPECT_EQ(read_csv("a,b\r\nc"), (Lines{{"a", "b"}, {"c"}})); }

TEST(Csv, AnUnclosedQuoteEndsWithTheText) {
  EXPECT_EQ(read_csv("a,\"b,c\n"), (Lines{{"a", "b,c\n"}}));
}

TEST(Csv, NothingHasNoLines) { EXPECT_TRUE(read_csv("").empty()); }

}  // namespace
}  // namespace penumbra::reproduce
