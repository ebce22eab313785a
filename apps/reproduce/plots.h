// SPDX-License-Identifier: MIT
// Plots drawn by gnuplot.
#pragma once

#include <string>

#include "report.h"

namespace penumbra::reproduce {

struct PlotFiles {
  std::string svg;  ///< 480 units wide, as high as its key needs; pages give the title beneath
  std::string png;  ///< 1120 pixels wide, with its title
};

/// Points that are not finite, and those that an axis with logarithms has no place for, are left
/// out; a spread is drawn where low < high. Names of curves of up to 45 characters have room.
/// Throws Error as `run_gnuplot` does.
PlotFiles draw(const Plot& plot);

}  // namespace penumbra::reproduce
