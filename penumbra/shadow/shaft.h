// SPDX-License-Identifier: MIT
// The shaft method: what may block a light is asked of the geometry set itself, once for a tile of
// receivers, and its answer, a list of candidates, decides their samples too.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "penumbra/shadow/candidates.h"
#include "penumbra/shadow/occluder_cache.h"
#include "penumbra/shadow/proof.h"
#include "penumbra/shadow/shadow_scene.h"

namespace penumbra {

/// Memory that is reused between tiles.
struct ShaftScratch {
  CandidateList tile;
  std::vector<std::uint32_t> sifted;
};

/// Gathers the records that may block the light for any point of a box of receivers (which lies in
/// the scene's). False if they are more than `most`, or nothing is known: then the list is of no
/// use. Adds the records looked at to `tests`.
bool gather_candidates(const ShadowScene& scene, std::uint32_t light, const Box& receivers,
                       std::size_t most, CandidateList& list, std::uint64_t& tests);

/// The class of (p, light), given the tile's candidates; the proof holds p's own.
Proof prove_by_candidates(const ShadowScene& scene, std::uint32_t light, Vec3f p,
                          OccluderQueue& queue, ShaftScratch& scratch);

}  // namespace penumbra
