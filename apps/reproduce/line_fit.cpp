// SPDX-License-Identifier: MIT
#include "line_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace penumbra::reproduce {

FittedLine fit_line(std::span<const Point> points) {
  const auto count = static_cast<double>(points.size());
  double x = 0, y = 0;
  for (const Point& p : points) x += p.x / count, y += p.y / count;
  double xx = 0, xy = 0;
  for (const Point& p : points) xx += (p.x - x) * (p.x - x), xy += (p.x - x) * (p.y - y);
  const double slope = xy / xx;
  const Line line{y - slope * x, slope};
  double residuals = 0;
  for (const Point& p : points) {
    const double residual = p.y - line.intercept - line.slope * p.x;
    residuals += residual * residual;
  }
  const double error =
      count > 2 ? std::sqrt(residuals / (count - 2) / xx) : std::numeric_limits<double>::infinity();
  return {line, error};
}

SlopeRatio slope_ratio(const FittedLine& steep, const FittedLine& flat) {
  const double slope = flat.line.slope, doubt = 2 * flat.slope_error;
  if (slope > doubt) return {steep.line.slope / slope, false};
  return {steep.line.slope / (std::max(slope, 0.0) + doubt), true};
}

}  // namespace penumbra::reproduce
