// SPDX-License-Identifier: MIT
// The occluders that blocked a light last, tried first (paper, sections 2 and 5: a queue of two for
// each node of the ray tree and light; also known as shadow buffer, Haines & Greenberg 1986).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "penumbra/kernel/traverse.h"
#include "penumbra/shadow/inner_volumes.h"

namespace penumbra {

/// One queue. Entries index the kernel's records.
struct OccluderQueue {
  std::array<std::uint32_t, 2> record{no_record, no_record};
  std::uint32_t inner_volume = no_volume;  ///< of the last umbra proof by one (`umbra`)

  /// A hit: `blocker` comes to the front, once.
  void move_to_front(std::uint32_t blocker) {
    if (record[0] != blocker) record[1] = record[0];
    record[0] = blocker;
  }
  /// A miss drops the last.
  void drop_last() { (record[1] != no_record ? record[1] : record[0]) = no_record; }
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
