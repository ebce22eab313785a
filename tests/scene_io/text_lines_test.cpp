// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/text_lines.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace penumbra {
namespace {

std::vector<std::string> lines_of(std::string_view text, LineJoints joints) {
  std::vector<std::string> result;
  TextLines lines(text, joints);
  while (const auto line = lines.next())
    result.push_back(std::to_string(lines.number()) + ":" + std::string(*line));
  return result;
}

using Lines = std::vector<std::string>;

TEST(TextLines, end_as_any_system_has_it) {
  EXPECT_EQ(lines_of("a\nb\r\nc\rd", LineJoints::none), (Lines{"1:a", "2:b", "3:c", "4:d"}));
  EXPECT_EQ(lines_of("\n\n", LineJoints::none), (Lines{"1:", "2:"}));
  EXPECT_EQ(lines_of("", LineJoints::none), Lines{});
  EXPECT_EQ(lines_of("\xEF\xBB\xBF"
                     "a",
                     LineJoints::none),
            Lines{"1:a"});
}

TEST(TextLines, backslashes_join_where_the_format_says_so) {
  EXPECT_EQ(lines_of("a\\\nb\nc", LineJoints::backslash), (Lines{"1:a\\\nb", "3:c"}));
  EXPECT_EQ(lines_of("a\\\nb\nc", LineJoints::none), (Lines{"1:a\\", "2:b", "3:c"}));
  EXPECT_EQ(lines_of("a\\", LineJoints::backslash), Lines{"1:a\\"});
}

TEST(NextWord, spaces_comments_and_joints_separate) {
  std::string_view rest = "  one\ttwo\\\n three # four";
  EXPECT_EQ(next_word(rest), "one");
  EXPECT_EQ(next_word(rest), "two");
  EXPECT_EQ(next_word(rest), "three");
  EXPECT_EQ(next_word(rest), "");
  EXPECT_EQ(next_word(rest), "");
}

TEST(NextWord, a_hash_inside_a_word_is_part_of_it) {
  std::string_view rest = "a#b";
  EXPECT_EQ(next_word(rest), "a#b");
}

}  // namespace
}  // namespace penumbra
