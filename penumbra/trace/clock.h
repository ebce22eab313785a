// SPDX-License-Identifier: MIT
// The clock that runs are measured by.
#pragma once

#include <chrono>

namespace penumbra {

/// Seconds on a clock that only goes forward.
inline double now_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace penumbra
