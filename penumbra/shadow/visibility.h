// SPDX-License-Identifier: MIT
// How much of a light a point sees: the judge (`stochastic`) and the hard shadow. Every later
// method returns the same struct with the same bits in `cosine_weighted` and `fraction`.
#pragma once

#include <cstdint>

#include "penumbra/geometry/light_sampling.h"
#include "penumbra/kernel/kernel.h"
#include "penumbra/scene/light.h"

namespace penumbra {

enum class Method { hard, stochastic };

/// Class of (point, light). lit and umbra are proofs, except for `stochastic` and `hard`, which
/// class by their samples.
enum class ShadowClass : std::uint8_t { lit = 0, penumbra = 1, umbra = 2 };

/// Exact integers.
struct ShadowCounters {
  std::uint64_t lit = 0, penumbra = 0, umbra = 0;  ///< queries (one a point and light) by class
  std::uint64_t rays = 0;                          ///< sample rays traced in the geometry set
  std::uint64_t tests = 0;                         ///< primitives tested by them
  void add(const ShadowCounters& other);
};

/// A receiver: p' of design section 3 and the geometric normal on the side it was moved to.
struct Receiver {
  Vec3f position;
  Vec3f normal;  ///< unit
};

struct Visibility {
  float cosine_weighted = 0;  ///< V = sum w v / sum w; where sum w is 0 or not finite, `fraction`
  float fraction = 0;         ///< free samples / d; samples below the horizon are not free
  ShadowClass shadow_class = ShadowClass::penumbra;
};

/// Memory that one thread reuses between queries.
struct VisibilityScratch {
  LightSamples samples;
  std::vector<std::uint32_t> blocked;
};

/// The visible part of one light from one receiver. `key` is the point key combined with the
/// light's index; see `light_key`. Counters are added to.
Visibility visibility(const Kernel& kernel, const LightShape& light, const Receiver& receiver,
                      Method method, const SamplePattern& pattern, std::uint64_t key,
                      VisibilityScratch& scratch, ShadowCounters& counters);

/// Random numbers are keyed by the point (pixel, sample, path; a library caller's index) and the
/// light.
std::uint64_t light_key(std::uint64_t point_key, std::uint32_t light_index);

}  // namespace penumbra
