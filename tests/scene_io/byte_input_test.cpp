// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/byte_input.h"

#include <gtest/gtest.h>

#include "tests/scene_io/gzip.h"
#include "tests/scene_io/temporary_folder.h"
#include "tests/scene_io/text_source.h"

namespace penumbra {
namespace {

/// Numbers in text, one a line: what is lost or doubled shows.
std::string long_text() {
  std::string text;
  for (int i = 0; i < 300'000; ++i) text += std::to_string(i) + "\n";
  return text;
}

std::string read_all(ByteInput& input, std::size_t least) {
  std::string all;
  for (;;) {
    EXPECT_EQ(input.at(), all.size());
    const std::string_view bytes = input.peek(least).substr(0, least);
    if (bytes.empty()) return all;
    all += bytes;
    input.skip(bytes.size());
  }
}

TEST(ByteInput, gives_all_bytes_in_steps_of_any_size) {
  const TemporaryFolder folder;
  const std::string text = long_text();
  const auto plain = folder.put("a", text), packed = folder.put("b", gzip(text));
  const auto members =
      folder.put("c", gzip(text.substr(0, 1000)) + gzip(text.substr(1000)) + std::string(9, '\0'));
  for (const std::size_t least : {4096, 1'000'000, 10'000'000})
    for (const auto& path : {plain, packed, members}) {
      ByteInput input(path, Packing::detect_gzip);
      EXPECT_TRUE(read_all(input, least) == text) << path << least;
    }
  ByteInput memory("name", text);
  EXPECT_TRUE(read_all(memory, 100) == text);
}

TEST(ByteInput, takes_bytes_as_they_are_where_it_is_told_so) {
  const TemporaryFolder folder;
  const std::string packed = gzip("some text");
  ByteInput input(folder.put("a", packed), Packing::none);
  EXPECT_EQ(read_all(input, 5), packed);
}

TEST(ByteInput, what_is_packed_takes_no_memory) {
  const TemporaryFolder folder;
  const auto path = folder.put("zeros", gzip(std::string(20'000'000, '\0')));
  ByteInput input(path, Packing::detect_gzip);
  std::size_t count = 0;
  for (;;) {
    const std::size_t got = input.peek().size();
    ASSERT_LE(got, std::size_t{1} << 20);
    if (got == 0) break;
    count += got;
    input.skip(got);
  }
  EXPECT_EQ(count, 20'000'000u);
}

TEST(ByteInput, broken_gzip_is_an_error_with_its_byte) {
  const TemporaryFolder folder;
  const std::string whole = gzip("some text that is long enough to be cut");
  const auto error = [&](const std::string& bytes) {
    return error_of([&] {
      ByteInput input(folder.put("a", bytes), Packing::detect_gzip);
      read_all(input, 10);
    });
  };
  for (std::size_t size = 3; size < whole.size(); ++size)
    EXPECT_TRUE(holds(error(whole.substr(0, size)), "byte " + std::to_string(size))) << size;
  EXPECT_TRUE(holds(error(whole + "more"), "follows"));
}

TEST(ByteInput, knows_what_is_left_of_plain_files) {
  const TemporaryFolder folder;
  const std::string text = long_text();
  ByteInput plain(folder.put("a", text), Packing::detect_gzip);
  EXPECT_EQ(plain.remaining(), text.size());
  plain.peek(1000);
  plain.skip(1000);
  EXPECT_EQ(plain.remaining(), text.size() - 1000);
  EXPECT_NEAR(plain.share().value(), 1000.0 / static_cast<double>(text.size()), 1e-6);
  ByteInput packed(folder.put("b", gzip(text)), Packing::detect_gzip);
  EXPECT_FALSE(packed.remaining());
  read_all(packed, 1000);
  EXPECT_EQ(packed.share(), 1.0);
}

TEST(ByteInput, what_cannot_be_read_is_an_error) {
  const TemporaryFolder folder;
  const auto error = [&](const std::filesystem::path& path) {
    return error_of([&] { ByteInput(path, Packing::none); });
  };
  EXPECT_TRUE(holds(error(folder.path() / "missing"), "no such file"));
  EXPECT_TRUE(holds(error(folder.path()), "folder"));
}

}  // namespace
}  // namespace penumbra
