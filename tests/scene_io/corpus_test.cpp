// SPDX-License-Identifier: MIT
// The files under corpus/, whole and damaged by chance: each is a scene or an Error, and soon.
// scene_io_fuzz does the same for longer, and under limits of time and memory.
#include <gtest/gtest.h>

#include <string>

#include "tests/scene_io/fuzz/fuzz_format.h"

namespace penumbra {
namespace {

const std::filesystem::path corpus = PENUMBRA_SOURCE_DIR "/tests/scene_io/corpus";

class Corpus : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Of, Corpus, testing::ValuesIn(format_names(corpus)),
                         [](const auto& format) { return format.param; });

TEST_P(Corpus, every_file_says_in_its_name_whether_it_is_a_scene) {
  const FuzzFormat format = load_format(corpus, GetParam());
  EXPECT_GE(format.samples.size(), 10u);
  for (std::size_t i = 0; i < format.samples.size(); ++i) {
    const bool is_bad = format.paths[i].filename().string().starts_with("bad_");
    SCOPED_TRACE(format.paths[i].string());
    Outcome outcome = Outcome::error;
    EXPECT_NO_THROW(outcome = read_input(format, format.samples[i]));
    EXPECT_EQ(outcome, is_bad ? Outcome::error : Outcome::scene);
  }
}

TEST_P(Corpus, damaged_files_are_scenes_or_errors) {
  const FuzzFormat format = load_format(corpus, GetParam());
  int scenes = 0;
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    SCOPED_TRACE("scene_io_fuzz " + format.name + " 0 " + std::to_string(seed));
    EXPECT_NO_THROW(scenes += read_input(format, input_of(format, seed)) == Outcome::scene);
  }
  EXPECT_GT(scenes, 20);  // or the damage is too much to be a test
}

}  // namespace
}  // namespace penumbra
