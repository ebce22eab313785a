// SPDX-License-Identifier: MIT
// What a run takes: time and memory.
#pragma once

#include <cstdint>

namespace penumbra {

/// Seconds on a clock that only goes forward.
double now_seconds();

/// The most memory this process has had resident.
std::uint64_t peak_rss_bytes();

}  // namespace penumbra
