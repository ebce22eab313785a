// SPDX-License-Identifier: MIT
// The loop over the samples of one receiver for maps too branchy for lanes.
#pragma once

#include <cstddef>

#include "penumbra/geometry/sample_loops.h"
#include "penumbra/geometry/vec.h"

namespace penumbra {

/// Each (u, v) becomes map(u, v), a Vec3f; equal neighbours, such as the padding, only once.
template <typename Map>
void replace_samples(SampleArrays samples, const Map& map) {
  float last_u = -1, last_v = -1;
  Vec3f sample;
  for (std::size_t i = 0; i < samples.count; ++i) {
    const float u = samples.x[i], v = samples.y[i];
    if (u != last_u || v != last_v) sample = map(u, v);
    last_u = u, last_v = v;
    samples.x[i] = sample.x, samples.y[i] = sample.y, samples.z[i] = sample.z;
  }
}

}  // namespace penumbra
