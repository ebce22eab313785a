// SPDX-License-Identifier: MIT
// One proof for all receivers of a convex region: a texel's footprint, a box.
#pragma once

#include <span>

#include "penumbra/shadow/shadow_query.h"
#include "penumbra/shadow/shadow_scene.h"
#include "penumbra/shadow/visibility.h"

namespace penumbra {

/// What is proven of one light.
struct HullProof {
  /// lit: nothing blocks a sample above the horizon. umbra: every sample is blocked or below it.
  ShadowClass shadow_class = ShadowClass::penumbra;
  /// Every sample is above the horizon: then lit means that the visible fraction is 1.
  bool is_above = false;
};

/// For every receiver in the convex hull of the positions of `corners` (1 to 64, p') that has their
/// normal, which all share: one unit vector, or 0 for receivers without a horizon. By the shaft
/// method; for other methods, for lights without extent, and in doubt, nothing is proven. Adds to
/// `counters` the query, not the class. Cost: that of a query of a tile, 1 to 5 microseconds.
HullProof prove_hull(const ShadowScene& scene, std::uint32_t light,
                     std::span<const Receiver> corners, OccluderQueue& queue,
                     VisibilityScratch& scratch, ShadowCounters& counters);

}  // namespace penumbra
