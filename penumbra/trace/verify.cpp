// SPDX-License-Identifier: MIT
#include "penumbra/trace/verify.h"

#include <fmt/format.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>

#include "penumbra/trace/names.h"
#include "penumbra/trace/pixel.h"

namespace penumbra {
namespace {

std::string text(const Visibility& seen) {
  return fmt::format("{}, V = {:.9g}, fraction = {:.9g}", name_of(seen.shadow_class),
                     seen.cosine_weighted, seen.fraction);
}

}  // namespace

void AnswerDraw::add(const AnsweredBatch& batch) {
  const auto by_rank = [](const Drawn& a, const Drawn& b) { return a.rank < b.rank; };
  for (std::size_t i = 0; i < batch.queries.size(); ++i) {
    const std::uint64_t rank = hash(seed_, batch.queries[i].key);
    if (rank >= highest_.load(std::memory_order_relaxed)) continue;
    const std::lock_guard lock(mutex_);
    drawn_.push_back({rank, {batch.path, batch.light, batch.queries[i], batch.seen[i]}});
    std::push_heap(drawn_.begin(), drawn_.end(), by_rank);
    if (drawn_.size() > count_) {
      std::pop_heap(drawn_.begin(), drawn_.end(), by_rank);
      drawn_.pop_back();
    }
    if (drawn_.size() == count_) highest_ = drawn_.empty() ? 0 : drawn_.front().rank;
  }
}

std::vector<GivenAnswer> AnswerDraw::answers() const {
  std::vector<Drawn> sorted = drawn_;
  std::sort(sorted.begin(), sorted.end(),
            [](const Drawn& a, const Drawn& b) { return a.rank < b.rank; });
  std::vector<GivenAnswer> answers;
  for (const Drawn& drawn : sorted) answers.push_back(drawn.answer);
  return answers;
}

bool is_same_answer(const Visibility& a, const Visibility& b) {
  return std::bit_cast<std::uint32_t>(a.cosine_weighted) ==
             std::bit_cast<std::uint32_t>(b.cosine_weighted) &&
         std::bit_cast<std::uint32_t>(a.fraction) == std::bit_cast<std::uint32_t>(b.fraction);
}

std::optional<WrongAnswer> find_wrong_answer(const ShadowScene& judge, std::uint32_t shadow_samples,
                                             std::span<const GivenAnswer> answers) {
  std::vector<Visibility> expected(answers.size());
  tbb::enumerable_thread_specific<VisibilityScratch> scratches(shadow_samples);
  tbb::parallel_for(std::size_t{0}, answers.size(), [&](std::size_t i) {
    const GivenAnswer& given = answers[i];
    OccluderQueue queue;
    ShadowCounters counters;
    expected[i] = visibility(judge, given.light, given.query.receiver, given.query.key, queue,
                             scratches.local(), counters);
  });
  for (std::size_t i = 0; i < answers.size(); ++i)
    if (!is_same_answer(answers[i].seen, expected[i])) return WrongAnswer{answers[i], expected[i]};
  return {};
}

std::string to_text(const WrongAnswer& wrong, const RenderOptions& options) {
  const GivenAnswer& given = wrong.given;
  const PixelSample at =
      find_sample(options, given.path, given.light, given.query.key).value_or(PixelSample{});
  return fmt::format("pixel {},{}, sample {}, {}, light {}: {}; expected {}", at.x, at.y, at.sample,
                     path_name(given.path), given.light, text(given.seen), text(wrong.expected));
}

}  // namespace penumbra
