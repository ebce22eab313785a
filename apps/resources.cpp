// SPDX-License-Identifier: MIT
#include "resources.h"

#include <sys/resource.h>

namespace penumbra {

std::uint64_t peak_rss_bytes() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;  // Linux counts KiB
}

}  // namespace penumbra
