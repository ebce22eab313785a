// SPDX-License-Identifier: MIT
// Low-discrepancy points of the unit square, keyed instead of drawn from a stream: Sobol's (0,
// 2)-sequence with hash-based Owen scrambling (Laine & Karras 2011; Burley, JCGT 2020).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace penumbra {

/// A random 64-bit value that depends on all bits of the arguments (finaliser of SplitMix64, Steele
/// 2014).
std::uint64_t hash(std::uint64_t a, std::uint64_t b);

/// A uniform float in [0, 1) from the top 24 bits.
inline float unit_float(std::uint32_t bits) { return static_cast<float>(bits >> 8) * 0x1p-24f; }

/// The first `count` points of the sequence, unscrambled, ordered along a Z-shaped curve: aligned
/// runs of 2^k of 2^m points fill one elementary interval, a square or half of one, whatever the
/// key, so that packets of neighbours are coherent. Build it once for each d.
class SamplePattern {
 public:
  explicit SamplePattern(std::uint32_t count);
  std::uint32_t size() const { return static_cast<std::uint32_t>(x_.size()); }

  /// Scrambled points for one key, written to `u` and `v` (both of length size()), in [0, 1).
  /// (1) Each point is uniform over the key; (2) any key gives a (0, m, 2)-net when size() is 2^m;
  /// (3) depends on nothing but key and size().
  void scramble(std::uint64_t key, std::span<float> u, std::span<float> v) const;

 private:
  std::vector<std::uint32_t> x_, y_;  // bit-reversed coordinates
};

}  // namespace penumbra
