// SPDX-License-Identifier: MIT
// What `bench` has measured, as a table and as JSON.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "penumbra/shadow/visibility.h"

namespace penumbra {

/// One method in one cell. Times are medians over the rounds.
struct BenchRow {
  std::string method;
  double seconds_shadow = 0, seconds_render = 0, seconds_build = 0;
  double speedup = 0;                  ///< over `embree`
  double speedup_over_stochastic = 0;  ///< of the shadow work, too
  double ratio_to_hard = 0;            ///< over `embree_hard`
  ShadowCounters counters;
  std::size_t memory_bytes = 0;
  std::string variant;           ///< of Embree: how it was asked; else empty
  double different_samples = 0;  ///< share on which Embree and we don't agree
};

/// One scene, radius, number of threads and d.
struct BenchCell {
  std::string scene;
  std::optional<std::string> light_radius;  ///< as given
  std::uint32_t threads = 1, shadow_samples = 1;
  std::size_t queries = 0;
  std::vector<BenchRow> rows;
};

/// What one cell comes to, for people.
std::string to_text(const BenchCell& cell);

/// `{"machine": ..., "rows": [...], "baselines": [...]}`
std::string to_json(const std::vector<BenchCell>& cells);

/// "AMD EPYC, 2 cores, AVX3; Embree 3.13.5"
std::string machine_text();

}  // namespace penumbra
