// SPDX-License-Identifier: MIT
// A line through measured points.
#pragma once

#include <span>

#include "report.h"

namespace penumbra::reproduce {

struct FittedLine {
  Line line;
  double slope_error =
      0;  ///< standard error of the slope, by the residuals; infinite for two points
};

/// Least squares. At least two points of different x.
FittedLine fit_line(std::span<const Point> points);

/// How many times steeper than `flat` is `steep`; where `flat` cannot be told from level (by two
/// standard errors), the least that it can be, which `is_bound` says.
struct SlopeRatio {
  double times = 0;
  bool is_bound = false;
};
SlopeRatio slope_ratio(const FittedLine& steep, const FittedLine& flat);

}  // namespace penumbra::reproduce
