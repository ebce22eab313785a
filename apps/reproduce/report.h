// SPDX-License-Identifier: MIT
// What a reproduction comes to, before it is written down as a page, as CSV, as Markdown: tables,
// plots, pictures and the words between them. Texts are plain; whoever writes them down escapes.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace penumbra::reproduce {

/// One cell of a table.
struct Cell {
  std::string ours;   ///< "0.41"
  std::string paper;  ///< the figure that the paper prints there; empty where it prints none, or we
                      ///< don't have it
  std::string more;   ///< in small print, such as a spread: "32 ms ± 2"
};

struct Row {
  std::string label;  ///< "(b) stochastic"
  std::vector<Cell> cells;
  bool is_beyond = false;  ///< about what the paper does not have: set apart
};

struct Table {
  std::string id;      ///< of its file and its anchor: "table1"
  std::string title;   ///< "Table 1: run times"
  std::string text;    ///< what the figures are, in a sentence or two
  std::string corner;  ///< above the labels
  std::vector<std::string> columns;
  std::vector<Row> rows;
};

/// Points (x, y) with the spread of y, in order of x.
struct Point {
  double x = 0, y = 0, low = 0, high = 0;
};

/// y = intercept + slope x
struct Line {
  double intercept = 0, slope = 0;
};

enum class CurveKind { points, fitted };

struct Curve {
  std::string name;
  std::vector<Point> points;
  CurveKind kind = CurveKind::points;
  Line fit;       ///< of a fitted one: drawn as a line through its points, which are not joined
  int color = 0;  ///< the same method has the same colour in all plots; 0, 1, 2, ...
};

struct Plot {
  std::string id, title, text, x_label, y_label;
  bool has_log_x = false, has_log_y = false;
  std::vector<Curve> curves;
};

/// One way to look at a scene.
struct View {
  std::string name;   ///< "picture", "proven by shaft"
  std::string file;   ///< beside the page, in full size: "balls.png"
  std::string media;  ///< "image/jpeg"
  std::string bytes;  ///< what the page itself shows
};

/// Views of the same size, of which the page shows one at a time.
struct Gallery {
  std::string id, title, text;
  std::vector<View> views;  ///< never empty; the first is shown first
};

struct Section {
  std::string id, title;
  std::vector<std::string> paragraphs;
  std::vector<Gallery> galleries;
  std::vector<Table> tables;
  std::vector<Plot> plots;
  std::vector<std::string> notes;  ///< a list at its end
};

struct Report {
  std::string title, subtitle;
  std::vector<std::pair<std::string, std::string>> setting;  ///< what was measured with what
  std::vector<Section> sections;
};

}  // namespace penumbra::reproduce
