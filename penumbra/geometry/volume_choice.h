// SPDX-License-Identifier: MIT
// Private to the layer: a few sets that cover most of what many cover.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace penumbra::detail {

/// A set of points, as bits; sets of one `group` are about the same points.
struct PointSet {
  std::vector<std::uint64_t> bits;
  std::uint32_t group = 0;
};

/// Sets that cover much, the most useful first: each time the one that adds the greatest share of
/// its group's points, weighted by the group (greedy; Nemhauser, Wolsey, Fisher 1978, with the lazy
/// evaluation of Minoux 1978). Of each group the first to come is free, others count up to `most`;
/// those that add less than `least` of their group's points stay out.
struct Group {
  std::size_t points = 0;
  double weight = 1;
};
std::vector<std::uint32_t> most_useful(std::span<const PointSet> sets,
                                       std::span<const Group> groups, std::size_t most,
                                       double least);

}  // namespace penumbra::detail
