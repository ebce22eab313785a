// SPDX-License-Identifier: MIT
#include "plot_key.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "plain_text.h"

namespace penumbra::reproduce {
namespace {

constexpr double row_height = 18;

/// Colours that colour-blind readers can tell apart (Okabe and Ito, Color Universal Design, 2008),
/// without the yellow, which white paper swallows; and gnuplot's point types.
constexpr std::array<Pen, 8> pens = {{{"#0072B2", 7},
                                      {"#D55E00", 5},
                                      {"#009E73", 9},
                                      {"#CC79A7", 13},
                                      {"#E69F00", 11},
                                      {"#56B4E9", 6},
                                      {"#000000", 4},
                                      {"#777777", 8}}};

std::size_t characters(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

Key key_of(const Plot& plot) {
  constexpr double character = 8.6, sample = 45, room = svg_width - 15;
  std::size_t longest = 1;
  for (const Curve& curve : plot.curves) longest = std::max(longest, characters(curve.name));
  const double width = static_cast<double>(longest) * character + sample;
  const int curves = std::max(1, static_cast<int>(plot.curves.size()));
  const int most_columns = std::clamp(static_cast<int>(room / width), 1, curves);
  const int rows = (curves + most_columns - 1) / most_columns;
  return {(curves + rows - 1) / rows, rows, width};
}

}  // namespace

Pen pen_of(const Curve& curve) { return pens[static_cast<std::size_t>(curve.color) % pens.size()]; }

std::string quoted(const std::string& text) {
  // Between double quotes gnuplot would run what stands in backquotes; of single quotes that are
  // doubled it does not understand those at the beginning.
  std::string result = "'";
  for (char c : plain_text(text)) result += c == '\'' || c == '`' ? "’" : std::string(1, c);
  return result + '\'';
}

Layout layout_of(const Plot& plot, double title) {
  constexpr int usual_height = 360, usual_rows = 3;
  const Key key = key_of(plot);
  return {key, usual_height + title + row_height * std::max(0, key.rows - usual_rows), title};
}

std::string key_commands(const Plot& plot, const Layout& layout) {
  // Labels and arrows: gnuplot's own key covers data where it takes names for too long.
  constexpr double left = 10, sample = 26, gap = 16;
  std::string text;
  for (std::size_t i = 0; i < plot.curves.size(); ++i) {
    const int row = static_cast<int>(i) / layout.key.columns;
    const int column = static_cast<int>(i) % layout.key.columns;
    const double x = left + column * layout.key.column_width;
    const double y = layout.from_top(layout.title + (row + 0.75) * row_height);
    const Pen pen = pen_of(plot.curves[i]);
    text += fmt::format(
        "set arrow from screen {0:.4f},{3:.4f} to screen {2:.4f},{3:.4f} nohead lc rgb '{4}' lw "
        "1.5\n"
        "set label '' at screen {1:.4f},{3:.4f} point lc rgb '{4}' pt {5} ps 0.75\n"
        "set label {7} at screen {6:.4f},{3:.4f} left noenhanced\n",
        x / svg_width, (x + 0.5 * sample) / svg_width, (x + sample) / svg_width, y, pen.color,
        pen.point, (x + sample + 6) / svg_width, quoted(plot.curves[i].name));
  }
  return text + fmt::format("unset key\nset tmargin at screen {:.4f}\n",
                            layout.from_top(layout.title + row_height * layout.key.rows + gap));
}

}  // namespace penumbra::reproduce
