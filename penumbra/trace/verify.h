// SPDX-License-Identifier: MIT
// Does a picture hold what its method promises? Some of its answers are drawn at random and asked
// again of the judge.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "penumbra/shadow/visibility.h"
#include "penumbra/trace/render.h"

namespace penumbra {

/// What a method said of a point and a light.
struct GivenAnswer {
  std::uint64_t path = 1;  ///< of the ray tree, see RayNode
  std::uint32_t light = 0;
  ShadowQuery query;
  Visibility seen;
};

/// Draws answers from a picture while it is rendered: those whose keys have the smallest hashes, so
/// that the same are drawn for any number of threads.
class AnswerDraw {
 public:
  AnswerDraw(std::size_t count, std::uint64_t seed) : count_(count), seed_(seed) {}
  /// For `RenderOptions::observe`; from any thread.
  void add(const AnsweredBatch& batch);
  /// At most `count`, in an order that depends on the seed alone.
  std::vector<GivenAnswer> answers() const;

 private:
  struct Drawn {
    std::uint64_t rank;
    GivenAnswer answer;
  };
  std::size_t count_;
  std::uint64_t seed_;
  std::atomic<std::uint64_t> highest_ = UINT64_MAX;  // rank that gets in
  std::mutex mutex_;
  std::vector<Drawn> drawn_;  // a heap, the highest rank first
};

/// The same bits in what the picture is made of; classes and counters may differ.
bool is_same_answer(const Visibility& a, const Visibility& b);

struct WrongAnswer {
  GivenAnswer given;
  Visibility expected;
};

/// The first answer that is not the judge's, whose method is `stochastic`; over all threads. Its
/// kernel may be another than the one that answered: brute force is the most independent witness.
std::optional<WrongAnswer> find_wrong_answer(const ShadowScene& judge, std::uint32_t shadow_samples,
                                             std::span<const GivenAnswer> answers);

/// "pixel 12,20, sample 0, camera ray > reflected, light 1: lit, V = 1, fraction = 1; expected
/// penumbra, ..."
std::string to_text(const WrongAnswer& wrong, const RenderOptions& options);

}  // namespace penumbra
