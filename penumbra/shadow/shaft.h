// SPDX-License-Identifier: MIT
// One question to the geometry set: which records may block a light's samples?
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "penumbra/kernel/traverse.h"
#include "penumbra/shadow/candidates.h"
#include "penumbra/shadow/seen_light.h"
#include "penumbra/shadow/shadow_scene.h"

namespace penumbra {

/// What holds every segment from a receiver to an active sample: the hull of the receivers' box and
/// the light's, over the receivers' horizon. For `walk`.
ShaftBounds shaft_bounds(const ShadowScene& scene, std::uint32_t light, const Box& receivers,
                         const SeenLight& sight);

/// Gathers the records that may block an active sample of the light for any of the receivers (which
/// lie in the scene's box); `sight` is the light as they see it. False, and the list of no use, if
/// they are more than `most` (at most CandidateList::most), or if there is no hierarchy to ask
/// (brute force). Adds the records looked at to `tests`.
bool gather_candidates(const ShadowScene& scene, std::uint32_t light, const Box& receivers,
                       const SeenLight& sight, std::size_t most, CandidateList& list,
                       std::uint64_t& tests);

}  // namespace penumbra
