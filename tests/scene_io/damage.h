// SPDX-License-Identifier: MIT
// Damage by chance, the same in every run.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "tests/scene_io/text_source.h"

namespace penumbra {

/// xorshift64*: the same damage in every run.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : state_(seed * 2 + 1) {}
  std::size_t below(std::size_t limit) {
    state_ ^= state_ >> 12;
    state_ ^= state_ << 25;
    state_ ^= state_ >> 27;
    return limit == 0 ? 0 : (state_ * 0x2545F4914F6CDD1Du >> 33) % limit;
  }

 private:
  std::uint64_t state_;
};

inline constexpr std::array<std::string_view, 23> nasty{"-1",
                                                        "0",
                                                        "nan",
                                                        "inf",
                                                        "1e39",
                                                        "1e-50",
                                                        "4294967295",
                                                        "9223372036854775807",
                                                        "\n",
                                                        " ",
                                                        "[",
                                                        "{}",
                                                        "\"",
                                                        "\\",
                                                        "/",
                                                        "-",
                                                        "\xff\xff",
                                                        "\x7f\xff\xff\xff",
                                                        "#",
                                                        "999",
                                                        "p",
                                                        "list",
                                                        std::string_view("\0\0\0\0", 4)};

inline std::string damaged(std::string bytes, Dice& dice) {
  for (std::size_t times = 1 + dice.below(4); times > 0 && !bytes.empty(); --times) {
    const std::size_t at = dice.below(bytes.size()), length = 1 + dice.below(12);
    switch (dice.below(6)) {
      case 0: bytes[at] = static_cast<char>(dice.below(256)); break;
      case 1: bytes.erase(at, length); break;
      case 2: bytes.insert(at, bytes.substr(dice.below(bytes.size()), length)); break;
      case 3: bytes.insert(at, nasty[dice.below(nasty.size())]); break;
      case 4: bytes.replace(at, length, nasty[dice.below(nasty.size())]); break;
      case 5:
        if (dice.below(4) == 0) bytes.resize(at);
        break;
    }
  }
  return bytes;
}

using Reader = Scene (*)(const Source&, Warnings&);

/// How many of the damaged files were still read: some, or the damage is too much to be a test.
/// PENUMBRA_LONG_FUZZ=<rounds> for more than the usual few thousand.
inline int survivors(const std::string& name, const std::vector<std::string>& samples,
                     Reader read) {
  const char* setting = std::getenv("PENUMBRA_LONG_FUZZ");
  const std::uint64_t rounds = setting != nullptr ? std::strtoull(setting, nullptr, 10) : 3000;
  int count = 0;
  for (std::uint64_t round = 0; round < rounds; ++round) {
    Dice dice(round);
    const Source source = source_of(name, damaged(samples[round % samples.size()], dice));
    Warnings warnings(name);
    try {
      Scene scene = read(source, warnings);
      validate(scene);
      ++count;
    } catch (const Error& error) {
      EXPECT_TRUE(std::string(error.what()).size() < 500) << error.what();
    }
  }
  return count;
}

}  // namespace penumbra
