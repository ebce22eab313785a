// SPDX-License-Identifier: MIT
// What a method knows of (point, light) before it looks at samples.
#pragma once

#include <cstdint>
#include <span>

namespace penumbra {

/// Class of (point, light). lit and umbra are proofs, except that `stochastic` and `hard` class by
/// their samples: umbra when no sample is free, lit when no ray is blocked.
enum class ShadowClass : std::uint8_t { lit = 0, penumbra = 1, umbra = 2 };

struct Proof {
  ShadowClass shadow_class = ShadowClass::penumbra;
  /// Whether no other records than `candidates` can block a sample.
  bool has_candidates = false;
  std::span<const std::uint32_t> candidates;
};

}  // namespace penumbra
