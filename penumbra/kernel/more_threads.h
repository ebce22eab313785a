// SPDX-License-Identifier: MIT
// As many threads as are asked for, also where there are fewer cores: results are promised for any
// number.
#pragma once

#include <tbb/global_control.h>
#include <tbb/info.h>

#include <cstddef>
#include <optional>

namespace penumbra {

/// While it lives, an arena of `threads` has them. What the program has set for itself is not
/// lowered.
class MoreThreads {
 public:
  explicit MoreThreads(std::size_t threads) {
    if (threads > static_cast<std::size_t>(tbb::info::default_concurrency()))
      control_.emplace(tbb::global_control::max_allowed_parallelism, threads);
  }

 private:
  std::optional<tbb::global_control> control_;
};

}  // namespace penumbra
