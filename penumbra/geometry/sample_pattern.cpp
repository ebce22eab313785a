// SPDX-License-Identifier: MIT
#include "penumbra/geometry/sample_pattern.h"

#include "penumbra/geometry/sample_loops.h"

#include <algorithm>
#include <numeric>

namespace penumbra {
namespace {

std::uint64_t mix(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

/// Second coordinate of Sobol's sequence: the binomial matrix modulo 2.
std::uint32_t sobol_y(std::uint32_t index) {
  std::uint32_t y = 0;
  for (std::uint32_t column = 1u << 31; index != 0; index >>= 1, column ^= column >> 1)
    if (index & 1) y ^= column;
  return y;
}

/// True if the first bit in which the two points differ, x before y, is 0 in `a`: the order of a
/// Z-shaped curve, in which aligned runs of 2^k points fill one elementary interval, near square.
bool is_before(std::uint32_t ax, std::uint32_t ay, std::uint32_t bx, std::uint32_t by) {
  const std::uint32_t dx = ax ^ bx, dy = ay ^ by;
  const bool y_decides = dx < dy && dx < (dx ^ dy);  // dy has the higher leading bit
  return y_decides ? ay < by : ax < bx;
}

/// Adding a uniform number makes each single point uniform, exactly; the factor decouples keys.
OwenScramble random_scramble(std::uint64_t random) {
  return {static_cast<std::uint32_t>(random), static_cast<std::uint32_t>(random >> 32) | 1u};
}

}  // namespace

std::uint64_t hash(std::uint64_t a, std::uint64_t b) {
  constexpr std::uint64_t golden = 0x9e3779b97f4a7c15u;
  return mix(mix(a + golden) + b * golden + golden);
}

SamplePattern::SamplePattern(std::uint32_t count) {
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [](std::uint32_t i, std::uint32_t j) {
    return is_before(reversed_bits(i), sobol_y(i), reversed_bits(j), sobol_y(j));
  });
  x_ = order;  // the first coordinate is the reversed index
  y_.reserve(count);
  for (std::uint32_t i : order) y_.push_back(reversed_bits(sobol_y(i)));
}

void SamplePattern::scramble(std::uint64_t key, std::span<float> u, std::span<float> v) const {
  scramble_to_units(x_.data(), x_.size(), random_scramble(hash(key, 0)), u.data());
  scramble_to_units(y_.data(), y_.size(), random_scramble(hash(key, 1)), v.data());
}

}  // namespace penumbra
