// SPDX-License-Identifier: MIT
#include "penumbra/shadow/spatial_order.h"

#include <algorithm>
#include <utility>

namespace penumbra {
namespace {

Box bounds(std::span<const ShadowQuery> queries) {
  Box box;
  for (const ShadowQuery& query : queries) box.add(query.receiver.position);
  return box;
}

/// Ten bits, with two zeros between each.
std::uint32_t spread_bits(std::uint32_t x) {
  x = (x | x << 16) & 0x030000ffu;
  x = (x | x << 8) & 0x0300f00fu;
  x = (x | x << 4) & 0x030c30c3u;
  return (x | x << 2) & 0x09249249u;
}

}  // namespace

bool is_scattered(std::span<const ShadowQuery> queries, std::size_t run) {
  if (queries.size() <= run) return false;
  float sum = 0, runs = 0;
  for (std::size_t first = 0; first < queries.size(); first += run, ++runs)
    sum += bounds(queries.subspan(first, std::min(run, queries.size() - first))).largest_extent();
  return sum > 0.7f * runs * bounds(queries).largest_extent();
}

std::uint32_t place_on_curve(Vec3f point, const Box& box) {
  const float scale = 1023 / std::max(box.largest_extent(), 1e-30f);
  const Vec3f from = (point - box.lo) * scale;
  std::uint32_t place = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const float step = from[axis] > 0 ? std::min(from[axis], 1023.0f) : 0;  // NaN: 0
    place |= spread_bits(static_cast<std::uint32_t>(step)) << axis;
  }
  return place;
}

void order_in_space(std::span<const ShadowQuery> queries, std::vector<std::uint32_t>& order) {
  const Box box = bounds(queries);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> keys;
  keys.reserve(queries.size());
  for (std::uint32_t i = 0; i < queries.size(); ++i)
    keys.emplace_back(place_on_curve(queries[i].receiver.position, box), i);
  std::sort(keys.begin(), keys.end());
  order.clear();
  for (const auto& [key, index] : keys) order.push_back(index);
}

}  // namespace penumbra
