// SPDX-License-Identifier: MIT
// Which numbers a scene may hold.
#pragma once

#include <cmath>

#include "penumbra/geometry/vec.h"

namespace penumbra {

/// Squares of what lies within it are far inside float's range.
inline constexpr double largest_coordinate = 1e15;

// Comparisons are written so that NaN fails them.
template <typename Number>
bool is_coordinate(Vec3<Number> p) {
  return std::abs(p.x) <= largest_coordinate && std::abs(p.y) <= largest_coordinate &&
         std::abs(p.z) <= largest_coordinate;
}
inline bool is_radius(float r) { return r > 0 && r <= largest_coordinate; }

}  // namespace penumbra
