// SPDX-License-Identifier: MIT
// The shaft method, tile by tile: neighbouring receivers share one query and its candidates.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "penumbra/shadow/answer_rows.h"
#include "penumbra/shadow/candidates.h"
#include "penumbra/shadow/occluder_cache.h"
#include "penumbra/shadow/samples.h"
#include "penumbra/shadow/seen_light.h"
#include "penumbra/shadow/shadow_query.h"
#include "penumbra/shadow/shadow_scene.h"
#include "penumbra/shadow/sheet.h"
#include "penumbra/shadow/sift.h"

namespace penumbra {

/// Memory that is reused between tiles: 0.2 MB, of which most is never touched.
struct TileScratch {
  TileScratch() = default;
  /// What it holds is of no use to another: a copy begins anew.
  TileScratch(const TileScratch&) : TileScratch() {}
  TileScratch& operator=(const TileScratch&) { return *this; }

  /// For groups of up to 64, 16 and 4 receivers, each sifted from the one before; what a query
  /// gathered; and one receiver's, to be sifted for parts of the light.
  enum List : std::size_t { of_groups = 0, gathered = 3, of_one, lists };
  ReceiverRows rows;
  std::array<std::uint32_t, ReceiverRows::most> query;  ///< of each row
  std::unique_ptr<CandidateList[]> list = std::make_unique_for_overwrite<CandidateList[]>(lists);
  Sifted sifted;
  SiftedRows sifted_rows;
  SheetScratch sheet;
  LightSamples outline;  ///< rays to the light's outline
  /// Of queries that are scattered (reflections on curved mirrors).
  std::vector<std::uint32_t> order;
  std::vector<ShadowQuery> ordered;
  std::vector<Visibility> answers;
  std::vector<std::uint32_t> free_samples;
};

/// `visibilities` by Method::shaft, for lights with an extent. Runs of queries share a shaft; where
/// that settles nothing, parts of them ask again.
void answer_by_tiles(const ShadowScene& scene, std::uint32_t light,
                     std::span<const ShadowQuery> queries, OccluderQueue& queue,
                     SampleScratch& samples, TileScratch& scratch, ShadowCounters& counters,
                     const AnswerRows& answers);

}  // namespace penumbra
