// SPDX-License-Identifier: MIT
// What `bench` has measured, as a table and as JSON.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "options.h"
#include "penumbra/trace/render.h"

namespace penumbra {

/// Seconds over the rounds: median and quartiles.
struct Timing {
  double median = 0, low = 0, high = 0;
};

/// One method in one cell.
struct BenchRow {
  std::string method;
  Timing shadow, render;
  double seconds_build = 0;
  double speedup = 0;                                ///< over `embree`
  double speedup_over_stochastic = 0;                ///< of the shadow work, too
  double ratio_to_hard = 0;                          ///< over `embree_hard`
  RenderCounters counters;                           ///< of Embree: those of the shadow work alone
  std::size_t geometry_bytes = 0, shadow_bytes = 0;  ///< hierarchy; what the method prepares
  std::string variant;                               ///< of Embree: how it was asked; else empty
  double different_samples = 0;                      ///< share on which Embree and we don't agree
};

/// One scene, radius, number of threads and d.
struct BenchCell {
  std::string scene;
  std::optional<std::string> light_radius;  ///< as given
  PixelSize size;
  std::uint32_t threads = 1, shadow_samples = 1;
  std::uint64_t seed = 0;
  std::size_t queries = 0;
  std::vector<BenchRow> rows;
};

/// What one cell comes to, for people.
std::string to_text(const BenchCell& cell);

/// `{"machine": ..., "rows": [...], "baselines": [...]}`
std::string to_json(const std::vector<BenchCell>& cells);

}  // namespace penumbra
