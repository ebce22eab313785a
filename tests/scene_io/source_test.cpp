// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/source.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "penumbra/scene_io/write_scene.h"
#include "tests/scene_io/gzip.h"
#include "tests/scene_io/text_source.h"

namespace penumbra {
namespace {

class SourceTest : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path put(const std::string& name, const std::string& bytes) const {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
    return folder_ / name;
  }

  std::filesystem::path folder_ = std::filesystem::path(testing::TempDir()) /
                                  testing::UnitTest::GetInstance()->current_test_info()->name();
};

TEST_F(SourceTest, unpacks_by_content_and_names_by_extension) {
  const std::string text(3'000'000, 'x');
  const Source packed = load(put("A.PLY.gz", gzip(text)));
  EXPECT_EQ(packed.extension, "ply");
  EXPECT_EQ(packed.bytes, text);
  const Source misnamed = load(put("b.stl", gzip("solid")));
  EXPECT_EQ(misnamed.extension, "stl");
  EXPECT_EQ(misnamed.bytes, "solid");
  const Source plain = load(put("c.nff.gz", "s 0 0 0 1"));
  EXPECT_EQ(plain.extension, "nff");
  EXPECT_EQ(plain.bytes, "s 0 0 0 1");
  EXPECT_EQ(load(put("noextension", "")).extension, "");
}

TEST_F(SourceTest, unpacks_members_and_padding) {
  EXPECT_EQ(load(put("a.gz", gzip("one ") + gzip("two") + std::string(100, '\0'))).bytes,
            "one two");
}

TEST_F(SourceTest, broken_gzip_is_an_error_with_its_byte) {
  const std::string whole = gzip("some text that is long enough to be cut");
  for (std::size_t size = 3; size < whole.size(); ++size) {
    const auto path = put("cut.gz", whole.substr(0, size));
    EXPECT_TRUE(holds(error_of([&] { load(path); }), "byte " + std::to_string(size))) << size;
  }
  EXPECT_TRUE(holds(error_of([&] { load(put("t.gz", whole + "more")); }), "follows"));
  std::string wrong = whole;
  wrong[wrong.size() - 6] ^= 1;
  EXPECT_TRUE(holds(error_of([&] { load(put("w.gz", wrong)); }), "incorrect"));
}

TEST_F(SourceTest, what_cannot_be_read_is_an_error) {
  EXPECT_TRUE(holds(error_of([&] { load(folder_ / "missing"); }), "no such file"));
  EXPECT_TRUE(holds(error_of([&] { load(folder_); }), "folder"));
  EXPECT_TRUE(holds(error_of([&] { load("/dev/zero"); }), "neither"));
}

TEST_F(SourceTest, files_are_written_whole_or_not_at_all) {
  const auto path = folder_ / "out.txt";
  write_file(path, "first");
  write_file(path, "second");
  EXPECT_EQ(load(path).bytes, "second");
  EXPECT_NE(error_of([&] { write_file(folder_ / "no" / "out.txt", "x"); }), "");
  EXPECT_NE(error_of([&] { write_file(folder_, "x"); }), "");
  std::filesystem::create_symlink(path, folder_ / "link.txt");
  write_file(folder_ / "link.txt", "third");
  EXPECT_TRUE(std::filesystem::is_symlink(folder_ / "link.txt"));
  EXPECT_EQ(load(path).bytes, "third");
  write_file("/dev/null", "nothing");
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
  const auto entries = std::filesystem::directory_iterator(folder_);
  EXPECT_EQ(std::distance(begin(entries), end(entries)), 2);
}

TEST(Warnings, are_few_and_short_whatever_the_file_says) {
  Warnings warnings("a.nff");
  for (int i = 0; i < 100'000; ++i)
    warnings.add("odd " + std::to_string(i) + std::string(1000, 'x'));
  EXPECT_EQ(warnings.lines().size(), 51u);
  for (const std::string& line : warnings.lines()) EXPECT_LT(line.size(), 400u);
  EXPECT_TRUE(holds(warnings.lines().back(), "(and 99949 more)"));
}

TEST(Warnings, keep_the_first_of_a_kind_and_count) {
  Warnings warnings("a.nff");
  warnings.add("odd", 3);
  warnings.add("odd", 4);
  warnings.add("strange");
  EXPECT_EQ(warnings.lines(),
            (std::vector<std::string>{"a.nff:3: odd (and 1 more)", "a.nff: strange"}));
}

}  // namespace
}  // namespace penumbra
