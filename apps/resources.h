// SPDX-License-Identifier: MIT
// What a run takes: time and memory.
#pragma once

#include <cstdint>

#include "penumbra/trace/clock.h"

namespace penumbra {

/// The most memory this process has had resident.
std::uint64_t peak_rss_bytes();

}  // namespace penumbra
