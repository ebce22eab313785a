// SPDX-License-Identifier: MIT
// The occluders that blocked a light last, tried first (paper, sections 2 and 5: a queue of two for
// each node of the ray tree and light; also known as shadow buffer, Haines & Greenberg 1986).
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "penumbra/kernel/traverse.h"
#include "penumbra/shadow/inner_volumes.h"

namespace penumbra {

/// Whether to try what has failed before: after n failures in a row 2^n - 1 times not, 31 at most.
class Backoff {
 public:
  bool is_due() {
    if (waiting_ == 0) return true;
    --waiting_;
    return false;
  }
  void note(bool has_succeeded) {
    failures_ = has_succeeded ? 0 : std::min(failures_ + 1, 5);
    waiting_ = (1 << failures_) - 1;
  }

 private:
  int failures_ = 0, waiting_ = 0;
};

/// One queue. Entries index the kernel's records.
struct OccluderQueue : RecentRecords {
  std::uint32_t inner_volume = no_volume;  ///< of the last umbra proof by one (`umbra`)
  /// Of `shaft`: lists and sheets, for groups of 64, 16, 4 receivers and for one.
  std::array<Backoff, 4> list, sheet;
  Backoff closely;  ///< proofs in double precision
};

/// The queues of one block of pixels. Paths beyond the first 64 of a ray tree share theirs.
class OccluderCache {
 public:
  explicit OccluderCache(std::size_t lights) : lights_(lights), queues_(most_paths * lights) {}
  OccluderQueue& queue(std::uint64_t path, std::size_t light) {
    return queues_[path % most_paths * lights_ + light];
  }

 private:
  static constexpr std::uint64_t most_paths = 64;
  std::size_t lights_;
  std::vector<OccluderQueue> queues_;
};

}  // namespace penumbra
