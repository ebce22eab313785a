// SPDX-License-Identifier: MIT
// First within each column, then along rows over what columns found, as exact distance transforms
// do (A. Meijster, J. Roerdink, W. Hesselink, A General Algorithm for Computing Distance Transforms
// in Linear Time, 2000), but with a plain search in rows: paddings are short.
#include "penumbra/trace/dilate.h"

#include <algorithm>
#include <cstddef>

namespace penumbra {
namespace {

constexpr std::uint32_t no_row = 0xffffffffu;

std::uint64_t apart(std::uint64_t a, std::uint64_t b) { return a < b ? b - a : a - b; }

/// For each texel the row of the nearest covered one above or below it, or `no_row`.
std::vector<std::uint32_t> nearest_in_columns(std::span<const std::uint8_t> covered,
                                              std::uint32_t width, std::uint32_t height) {
  std::vector<std::uint32_t> nearest(covered.size(), no_row);
  for (std::uint32_t y = 0; y < height; ++y)
    for (std::size_t x = 0, i = std::size_t{y} * width; x < width; ++x, ++i)
      nearest[i] = covered[i] != 0 ? y : y > 0 ? nearest[i - width] : no_row;
  for (std::uint32_t y = height; y-- > 1;)
    for (std::size_t x = 0, i = std::size_t{y} * width; x < width; ++x, ++i) {
      const std::uint32_t below = nearest[i];
      std::uint32_t& row = nearest[i - width];
      if (below != no_row && below >= y && (row == no_row || below - (y - 1) < y - 1 - row))
        row = below;
    }
  return nearest;
}

}  // namespace

std::vector<std::uint32_t> nearest_covered(std::span<const std::uint8_t> covered,
                                           std::uint32_t width, std::uint32_t height,
                                           std::uint32_t padding) {
  const std::vector<std::uint32_t> rows = nearest_in_columns(covered, width, height);
  std::vector<std::uint32_t> source(covered.size(), no_texel);
  for (std::size_t i = 0; i < covered.size(); ++i) {
    const std::uint64_t x = i % width, y = i / width;
    std::uint64_t least = std::uint64_t{padding} * padding + 1;
    const auto try_column = [&](std::uint64_t column) {
      const std::uint32_t row = rows[y * width + column];
      if (row == no_row) return;
      const std::uint64_t dx = apart(column, x), dy = apart(row, y);
      if (dx * dx + dy * dy >= least) return;
      least = dx * dx + dy * dy;
      source[i] = static_cast<std::uint32_t>(row * std::uint64_t{width} + column);
    };
    for (std::uint64_t dx = 0; dx * dx < least && dx < width; ++dx) {
      if (dx <= x) try_column(x - dx);
      if (x + dx < width) try_column(x + dx);
    }
  }
  return source;
}

}  // namespace penumbra
