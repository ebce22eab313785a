// SPDX-License-Identifier: MIT
// Where the answers of many questions go, and how much is wanted of them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "penumbra/shadow/samples.h"
#include "penumbra/shadow/shadow_query.h"

namespace penumbra {

/// What is wanted: with the class alone, methods that prove trace no sample.
enum class Wanted { visibility, shadow_class };

/// One row a question.
struct AnswerRows {
  std::span<Visibility> seen;  ///< where the class is all that is wanted, the rest means nothing
  /// A bit for each sample that is free, ceil(d / 32) words a question; empty: not wanted.
  std::span<std::uint32_t> free_samples{};
  std::uint32_t shadow_samples = 0;  ///< d; needed for `free_samples`
  Wanted wanted = Wanted::visibility;

  std::size_t words() const { return (shadow_samples + 31) / 32; }

  AnswerRows part(std::size_t first, std::size_t count) const {
    AnswerRows rows = *this;
    rows.seen = seen.subspan(first, count);
    if (!free_samples.empty())
      rows.free_samples = free_samples.subspan(first * words(), count * words());
    return rows;
  }

  /// Row i; the samples are those of the scratch unless all, or none, are free.
  void put(std::size_t i, const Visibility& answer, const SampleScratch& samples) const {
    seen[i] = answer;
    if (free_samples.empty()) return;
    const std::span<std::uint32_t> row = free_samples.subspan(i * words(), words());
    if (answer.fraction == 0 || answer.fraction == 1) {
      std::fill(row.begin(), row.end(), answer.fraction == 0 ? 0 : ~0u);
      if (shadow_samples % 32 != 0) row.back() &= (1u << shadow_samples % 32) - 1;
    } else {
      for (std::size_t word = 0; word < row.size(); ++word)
        row[word] = samples.active[word] & ~samples.blocked[word];
    }
  }

  /// Row i becomes row k of others.
  void copy(std::size_t i, const AnswerRows& from, std::size_t k) const {
    seen[i] = from.seen[k];
    for (std::size_t word = 0; word < words() && !free_samples.empty(); ++word)
      free_samples[i * words() + word] = from.free_samples[k * words() + word];
  }
};

}  // namespace penumbra
