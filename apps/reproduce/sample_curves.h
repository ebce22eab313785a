// SPDX-License-Identifier: MIT
// Time against d: the paper's Figures 6 to 8, their slopes, and error against time.
#pragma once

#include <vector>

#include "report.h"
#include "results.h"

namespace penumbra::reproduce {

/// Least squares through (d, seconds of a picture), each weighed by 1 / seconds² so that small d
/// count as much as large ones.
Line fitted_time(const Results& results, const PlannedScene& scene, const std::string& method);

/// Figures 6 to 8, and one more.
std::vector<Plot> times_against_samples(const Results& results);

/// Slopes of the fitted lines and their ratios.
Table slopes(const Results& results);

/// Error of the picture against the time it takes.
std::vector<Plot> errors_against_time(const Results& results);

}  // namespace penumbra::reproduce
