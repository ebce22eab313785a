// SPDX-License-Identifier: MIT
// Memory that questions use and leave to the next: small calls would spend most of their time on
// getting it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "penumbra/shadow/visibility.h"

namespace penumbra {

/// What one thread answers with.
struct AskScratch {
  explicit AskScratch(std::uint32_t shadow_samples) : visibility(shadow_samples) {}
  VisibilityScratch visibility;
  std::vector<ShadowQuery> queries;
  std::vector<Visibility> seen;
  std::vector<std::uint32_t> free_samples;
};

/// Scratches that nobody uses at the moment. From any thread.
class ScratchPool {
 public:
  /// One for so many shadow samples.
  std::unique_ptr<AskScratch> take(std::uint32_t shadow_samples) {
    {
      const std::lock_guard lock(mutex_);
      const auto found = std::find_if(idle_.begin(), idle_.end(), [&](const auto& scratch) {
        return scratch->visibility.samples.pattern.size() == shadow_samples;
      });
      if (found != idle_.end()) {
        std::swap(*found, idle_.back());
        std::unique_ptr<AskScratch> scratch = std::move(idle_.back());
        idle_.pop_back();
        return scratch;
      }
    }
    return std::make_unique<AskScratch>(shadow_samples);
  }

  /// Those that are given back last are kept.
  void give_back(std::unique_ptr<AskScratch> scratch) {
    constexpr std::size_t most = 64;
    const std::lock_guard lock(mutex_);
    if (idle_.size() == most) idle_.erase(idle_.begin());
    idle_.push_back(std::move(scratch));
  }

 private:
  std::mutex mutex_;
  std::vector<std::unique_ptr<AskScratch>> idle_;
};

}  // namespace penumbra
