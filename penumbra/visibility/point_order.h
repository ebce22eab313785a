// SPDX-License-Identifier: MIT
// Points next to one another, however the caller has them.
#pragma once

#include <cstdint>
#include <vector>

#include "penumbra/visibility/rows.h"

namespace penumbra {

/// The order in which points are best asked about: along a Z-shaped curve through their box, where
/// runs of them, as they are, spread much farther than they need; else empty: as they are. Points
/// that are no numbers are anywhere. Deterministic. Fewer than 2^32 points. Cost: 5 ns a point
/// where they stay, 60 ns where they don't, over all cores; 12 bytes a point.
std::vector<std::uint32_t> order_of(const VectorRows& positions);

}  // namespace penumbra
