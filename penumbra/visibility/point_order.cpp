// SPDX-License-Identifier: MIT
#include "penumbra/visibility/point_order.h"

#include <cmath>
#include <functional>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>
#include <tbb/parallel_sort.h>

#include "penumbra/geometry/box.h"
#include "penumbra/shadow/spatial_order.h"

namespace penumbra {
namespace {

using Range = tbb::blocked_range<std::size_t>;

constexpr std::size_t run = 64;        // points that share a shaft
constexpr std::size_t looked_at = 16;  // of so many runs, one
constexpr double worth_ordering = 6;   // times as wide as runs on a surface need be

Box box_of(const VectorRows& positions, std::size_t first, std::size_t last) {
  Box box;
  for (std::size_t i = first; i < last; ++i)
    if (const Vec3f p = positions[i]; is_finite(p)) box.add(p);
  return box;
}

Box box_of(const VectorRows& positions) {
  return tbb::parallel_reduce(
      Range(0, positions.size(), 65536), Box{},
      [&](const Range& range, Box box) {
        box.add(box_of(positions, range.begin(), range.end()));
        return box;
      },
      [](Box a, const Box& b) {
        a.add(b);
        return a;
      });
}

bool is_worth_ordering(const VectorRows& positions, const Box& box) {
  const std::size_t runs = positions.size() / run;
  if (runs < 4) return false;
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < runs; i += looked_at, ++count)
    sum += static_cast<double>(box_of(positions, i * run, (i + 1) * run).largest_extent());
  const double needed = std::sqrt(1 / static_cast<double>(runs)) * double(box.largest_extent());
  return sum > worth_ordering * needed * count;
}

}  // namespace

std::vector<std::uint32_t> order_of(const VectorRows& positions) {
  const Box box = box_of(positions);
  if (!is_worth_ordering(positions, box)) return {};
  std::vector<std::uint64_t> keys(positions.size());
  const Range all(0, positions.size(), 65536);
  tbb::parallel_for(all, [&](const Range& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i)
      keys[i] = std::uint64_t{place_on_curve(positions[i], box)} << 32 | i;
  });
  tbb::parallel_sort(keys.begin(), keys.end());
  std::vector<std::uint32_t> order(keys.size());
  tbb::parallel_for(all, [&](const Range& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i)
      order[i] = static_cast<std::uint32_t>(keys[i]);
  });
  return order;
}

}  // namespace penumbra
