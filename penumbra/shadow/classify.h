// SPDX-License-Identifier: MIT
// The class of (point, light) by the paper's methods (c) to (e).
#pragma once

#include "penumbra/shadow/occluder_cache.h"
#include "penumbra/shadow/shadow_query.h"
#include "penumbra/shadow/shadow_scene.h"

namespace penumbra {

/// How much a query may cost before it gives up and leaves the point to its samples: grown
/// occluders tested, and tested beyond the first candidate (only umbra can be proven then). In
/// proportion to what the samples cost: dense meshes under large lights have thousands of
/// candidates a point.
struct ProofBudget {
  std::uint64_t tests, tests_beyond_candidate;
};
ProofBudget proof_budget(std::uint32_t shadow_samples);

/// lit: the shadow set has no candidate. umbra: one occluder, or an inner volume, hides the whole
/// light. Both are proven for every sample above or below p's horizon; all else is penumbra. For
/// methods that have a shadow set. The volume of the last proof is kept in `queue`.
ShadowClass classify(const ShadowScene& scene, std::uint32_t light, Vec3f p,
                     const ProofBudget& budget, OccluderQueue& queue, ShadowCounters& counters);

}  // namespace penumbra
