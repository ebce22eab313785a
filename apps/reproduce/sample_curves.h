// SPDX-License-Identifier: MIT
// Time against d: the paper's Figures 6 to 8, their slopes, and error against time.
#pragma once

#include <vector>

#include "line_fit.h"
#include "report.h"
#include "results.h"

namespace penumbra::reproduce {

/// The line through (d, milliseconds of a picture) for d >= 8: the paper's slopes are for large d,
/// and packets are not full below.
FittedLine fitted_time(const Results& results, const PlannedScene& scene,
                       const std::string& method);

/// Figures 6 to 8, and one more.
std::vector<Plot> times_against_samples(const Results& results);

/// The same without (b) and (d), which are far above the others.
std::vector<Plot> fast_times_against_samples(const Results& results);

/// The paper's fast method: (e), but it proves no umbra behind meshes: (d) for the bust.
constexpr Method fast_method(PaperSceneIndex scene) {
  return scene == bust ? Method::reduced : Method::umbra;
}

/// "> 120", or "12.3".
std::string to_text(const SlopeRatio& ratio);

/// How much more slowly time grows with d, by each method.
Table slopes(const Results& results);

/// Error of the picture against the time it takes.
std::vector<Plot> errors_against_time(const Results& results);

}  // namespace penumbra::reproduce
