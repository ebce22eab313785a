// SPDX-License-Identifier: MIT
// Neighbours in space next to one another.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "penumbra/geometry/box.h"
#include "penumbra/shadow/shadow_query.h"

namespace penumbra {

/// Whether runs of `run` queries, as they are, spread about as widely as all of them together:
/// then an order in space makes their shafts narrower. Cost: 2 ns a query.
bool is_scattered(std::span<const ShadowQuery> queries, std::size_t run);

/// Where a point lies on a Z-shaped curve through the box: 30 bits. Anything for points that are no
/// numbers, or outside.
std::uint32_t place_on_curve(Vec3f point, const Box& box);

/// Fills `order` with the queries' indices along a Z-shaped curve through the box of their
/// receivers; those that are no numbers anywhere. Deterministic. Cost: 30 ns a query.
void order_in_space(std::span<const ShadowQuery> queries, std::vector<std::uint32_t>& order);

}  // namespace penumbra
