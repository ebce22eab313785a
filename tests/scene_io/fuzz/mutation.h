// SPDX-License-Identifier: MIT
// Files damaged by chance, the same for the same seed: bits, bytes, words, lines and parts of other
// files of their kind.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace penumbra {

/// xorshift64*: the same numbers in every run.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : state_((seed + 1) * 0x9E3779B97F4A7C15u | 1) {}
  /// In [0, limit), or 0 where there is nothing below it.
  std::size_t below(std::size_t limit) {
    state_ ^= state_ >> 12;
    state_ ^= state_ << 25;
    state_ ^= state_ >> 27;
    return limit == 0 ? 0 : (state_ * 0x2545F4914F6CDD1Du >> 33) % limit;
  }
  bool one_in(std::size_t limit) { return below(limit) == 0; }

 private:
  std::uint64_t state_;
};

/// One of the samples after a few random changes; at most `most_bytes` long.
std::string damaged(const std::vector<std::string>& samples, Dice& dice,
                    std::size_t most_bytes = std::size_t{1} << 18);

}  // namespace penumbra
