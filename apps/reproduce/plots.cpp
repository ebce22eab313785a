// SPDX-License-Identifier: MIT
#include "plots.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "axis.h"
#include "gnuplot.h"
#include "html.h"
#include "plot_key.h"

namespace penumbra::reproduce {
namespace {

constexpr double title_height = 30, png_scale = 1120 / svg_width;

struct Axes {
  Axis x, y;
};

bool is_inside(const Axis& axis, double value) {
  return std::isfinite(value) && value >= axis.low && value <= axis.high;
}

bool has_spread(const Point& p) { return p.low < p.high; }

double value_at(const Line& line, double x) { return line.intercept + line.slope * x; }

Axes axes_of(const Plot& plot) {
  std::vector<double> x, y;
  for (const Curve& curve : plot.curves)
    for (const Point& p : curve.points) {
      if (!std::isfinite(p.x) || !std::isfinite(p.y)) continue;
      x.push_back(p.x), y.push_back(p.y);
      if (has_spread(p)) y.push_back(p.low), y.push_back(p.high);
    }
  return {axis_around(x, plot.has_log_x), axis_around(y, plot.has_log_y)};
}

/// "x y low high" a line; what has no spread gets none.
std::string point_lines(const Curve& curve, const Axes& axes) {
  std::string lines;
  for (const Point& p : curve.points) {
    if (!is_inside(axes.x, p.x) || !is_inside(axes.y, p.y)) continue;
    const double low = std::max(p.low, axes.y.low);
    lines += has_spread(p) ? fmt::format("{} {} {} {}\n", p.x, p.y, low, p.high)
                           : fmt::format("{} {} {} {}\n", p.x, p.y, p.y, p.y);
  }
  return lines;
}

/// The fitted line over the whole axis; with logarithms it is a curve.
std::string fit_lines(const Line& fit, const Axes& axes) {
  constexpr int steps = 100;
  std::string lines;
  for (int i = 0; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    const double x = axes.x.has_log ? axes.x.low * std::pow(axes.x.high / axes.x.low, t)
                                    : axes.x.low + t * (axes.x.high - axes.x.low);
    if (is_inside(axes.y, value_at(fit, x))) lines += fmt::format("{} {}\n", x, value_at(fit, x));
  }
  return lines;
}

/// Data blocks `$pointsN` and `$fitN`, and what `plot` draws of them.
struct Drawing {
  std::string data;
  std::vector<std::string> items;
};

void add(const Curve& curve, const Axes& axes, Drawing& drawing) {
  const std::size_t id = drawing.items.size();
  const Pen pen = pen_of(curve);
  const std::string points = point_lines(curve, axes);
  const std::string dots = fmt::format("lc rgb '{}' lw 1.5 pt {} ps 0.75", pen.color, pen.point);
  const bool is_fitted = curve.kind == CurveKind::fitted;
  if (points.empty()) return;
  if (const std::string fit = fit_lines(curve.fit, axes); is_fitted && !fit.empty()) {
    drawing.data += fmt::format("$fit{} << EOD\n{}EOD\n", id, fit);
    drawing.items.push_back(fmt::format("$fit{} with lines lc rgb '{}' lw 1.5", id, pen.color));
  }
  drawing.data += fmt::format("$points{} << EOD\n{}EOD\n", id, points);
  drawing.items.push_back(fmt::format(
      "$points{} using 1:3:(0):($4-$3) with vectors nohead lc rgb '{}' lw 1.5", id, pen.color));
  drawing.items.push_back(fmt::format("$points{} using 1:2 with {} {}", id,
                                      is_fitted ? "points" : "linespoints", dots));
}

std::string axis_commands(char name, const Axis& axis, const std::string& label) {
  std::string text =
      fmt::format("set {}label {} noenhanced{}\nset {}range [{}:{}]\n", name, quoted(label),
                  name == 'x' ? " offset 0,0.5" : "", name, axis.low, axis.high);
  if (axis.has_log)
    text += fmt::format("set logscale {}\nset {}tics {} scale 0.8\n", name, name, log_tics(axis));
  return text;
}

std::string script_of(const Plot& plot, const Layout& layout, const std::string& terminal) {
  const Axes axes = axes_of(plot);
  Drawing drawing;
  for (const Curve& curve : plot.curves) add(curve, axes, drawing);
  if (drawing.items.empty()) drawing.items.push_back("NaN");
  std::string text = "set encoding utf8\n" + terminal +
                     "set border 3 lc rgb '#555555'\n"
                     "set tics nomirror out scale 0.8 textcolor rgb '#222222'\n"
                     "set xtics offset 0,0.3\n"
                     "set grid back lt 1 lc rgb '#dddddd' lw 0.8\n" +
                     key_commands(plot, layout);
  text += axis_commands('x', axes.x, plot.x_label) + axis_commands('y', axes.y, plot.y_label);
  return text + drawing.data + fmt::format("plot {}\n", fmt::join(drawing.items, ", \\\n  "));
}

std::string svg_terminal(const Layout& layout) {
  return fmt::format("set terminal svg size {},{} fixed font 'sans-serif,14' background 'white'\n",
                     svg_width, layout.height);
}

/// libgd's PNGs are the second choice: their lines are jagged.
std::string png_terminal(const Plot& plot, const Layout& layout) {
  return fmt::format(
      "if (strstrt(GPVAL_TERMINALS, ' pngcairo ')) {{\n"
      "  set terminal pngcairo size {0:.0f},{1:.0f} font 'sans,24' linewidth 2.2 pointscale 2\n"
      "}} else {{\n  set terminal png size {0:.0f},{1:.0f} font 'sans,24' linewidth 2\n}}\n"
      "set label {2} at screen 0.5, screen {3:.4f} center noenhanced\n",
      png_scale * svg_width, png_scale * layout.height, quoted(plot.title),
      layout.from_top(0.5 * layout.title));
}

/// gnuplot calls all its pictures "Gnuplot".
std::string with_title(std::string svg, const std::string& title) {
  const std::string_view theirs = "<title>Gnuplot</title>";
  if (const auto at = svg.find(theirs); at != svg.npos)
    svg.replace(at, theirs.size(), "<title>" + escape(title) + "</title>");
  return svg;
}

}  // namespace

PlotFiles draw(const Plot& plot) {
  const Layout bare = layout_of(plot, 0), titled = layout_of(plot, title_height);
  return {with_title(run_gnuplot(script_of(plot, bare, svg_terminal(bare))), plot.title),
          run_gnuplot(script_of(plot, titled, png_terminal(plot, titled)))};
}

}  // namespace penumbra::reproduce
