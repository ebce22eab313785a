// SPDX-License-Identifier: MIT
// How a plot tells its curves apart: pens, and the key above it.
#pragma once

#include <string>

#include "report.h"

namespace penumbra::reproduce {

struct Pen {
  const char* color;
  int point;  ///< gnuplot's number of its shape
};

/// The same colour and shape for the same `Curve::color`; they repeat after eight.
Pen pen_of(const Curve& curve);

/// As gnuplot takes text that means nothing but itself; quotes become apostrophes.
std::string quoted(const std::string& text);

/// In units of an SVG, which are as many pixels where nobody scales it.
constexpr double svg_width = 480;

/// Columns are as wide as the longest name may be.
struct Key {
  int columns = 1, rows = 1;
  double column_width = 0;
};

/// Lengths in units of an SVG; a PNG is a multiple of it. From top to bottom: title, key, plot.
struct Layout {
  Key key;
  double height = 0, title = 0;

  /// gnuplot's screen coordinate
  double from_top(double y) const { return 1 - y / height; }
};

/// With so much room for a title. Plots of the same height, unless a key has more than three rows.
Layout layout_of(const Plot& plot, double title);

/// Draws the key, and begins the plot below.
std::string key_commands(const Plot& plot, const Layout& layout);

}  // namespace penumbra::reproduce
