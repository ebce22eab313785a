// SPDX-License-Identifier: MIT
// Plots drawn by gnuplot.
#pragma once

#include <string>

#include "report.h"

namespace penumbra::reproduce {

/// Units of an SVG, and as many pixels where nobody scales it.
constexpr int svg_width = 480, svg_height = 360;

struct PlotFiles {
  std::string svg;  ///< without a title in the picture: pages give one beneath
  std::string png;  ///< 1120 x 840, with its title
};

/// Points that are not finite, and those that an axis with logarithms has no place for, are left
/// out; a spread is drawn where low < high. Throws Error as `run_gnuplot` does.
PlotFiles draw(const Plot& plot);

}  // namespace penumbra::reproduce
