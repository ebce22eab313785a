// SPDX-License-Identifier: MIT
// Parts of a picture, and the order in which neighbours in it are neighbours in time.
#pragma once

#include <cstdint>
#include <vector>

namespace penumbra {

/// Pixels of a part of the picture.
struct Area {
  std::uint32_t x_begin, x_end, y_begin, y_end;
  std::uint64_t pixels() const { return std::uint64_t(x_end - x_begin) * (y_end - y_begin); }
};

struct Pixel {
  std::uint32_t x, y;
};

/// Pixels of an area of at most 16 squared in Z-order.
std::vector<Pixel> z_order(Area block);

}  // namespace penumbra
