// SPDX-License-Identifier: MIT
#include "penumbra/trace/z_order.h"

namespace penumbra {

std::vector<Pixel> z_order(Area block) {
  constexpr std::uint32_t edge = 16;
  const auto even_bits = [](std::uint32_t i) {
    return (i & 1) | (i >> 1 & 2) | (i >> 2 & 4) | (i >> 3 & 8);
  };
  std::vector<Pixel> pixels;
  for (std::uint32_t i = 0; i < edge * edge; ++i) {
    const std::uint32_t x = block.x_begin + even_bits(i), y = block.y_begin + even_bits(i >> 1);
    if (x < block.x_end && y < block.y_end) pixels.push_back({x, y});
  }
  return pixels;
}

}  // namespace penumbra
