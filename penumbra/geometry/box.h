// SPDX-License-Identifier: MIT
// Axis-aligned boxes and the conversions to float that keep a bound a bound.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "penumbra/geometry/vec.h"

namespace penumbra {

/// Smallest float not below x (x finite and within float's range).
inline float round_up(double x) {
  const float f = static_cast<float>(x);
  if (!(static_cast<double>(f) < x)) return f;
  if (f == 0) return std::numeric_limits<float>::denorm_min();
  const auto bits = std::bit_cast<std::int32_t>(f);  // the next one is the next number, by size
  return std::bit_cast<float>(bits < 0 ? bits - 1 : bits + 1);
}

/// Largest float not above x.
inline float round_down(double x) { return -round_up(-x); }

/// A closed axis-aligned box; empty (lo > hi) until something is added.
struct Box {
  Vec3f lo{std::numeric_limits<float>::infinity(), std::numeric_limits<float>::infinity(),
           std::numeric_limits<float>::infinity()};
  Vec3f hi{-std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity(),
           -std::numeric_limits<float>::infinity()};

  bool is_empty() const { return !(lo.x <= hi.x && lo.y <= hi.y && lo.z <= hi.z); }
  void add(Vec3f p) { lo = min(lo, p), hi = max(hi, p); }
  void add(const Box& b) { lo = min(lo, b.lo), hi = max(hi, b.hi); }
  Vec3f center() const { return lo * 0.5f + hi * 0.5f; }
  Vec3f size() const { return is_empty() ? Vec3f{} : hi - lo; }
  /// The longest edge; 0 when empty.
  float largest_extent() const { return max_abs(size()); }
  bool contains(const Box& b) const {
    return lo.x <= b.lo.x && lo.y <= b.lo.y && lo.z <= b.lo.z && hi.x >= b.hi.x && hi.y >= b.hi.y &&
           hi.z >= b.hi.z;
  }
};

/// The box of float corners that surely holds [lo, hi].
inline Box outward(Vec3d lo, Vec3d hi) {
  return {{round_down(lo.x), round_down(lo.y), round_down(lo.z)},
          {round_up(hi.x), round_up(hi.y), round_up(hi.z)}};
}

}  // namespace penumbra
