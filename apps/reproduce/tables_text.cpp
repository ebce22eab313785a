// SPDX-License-Identifier: MIT
#include "tables_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "csv.h"
#include "plain_text.h"

namespace penumbra::reproduce {
namespace {

/// A row may end early.
Cell cell_of(const Row& row, std::size_t column) {
  return column < row.cells.size() ? row.cells[column] : Cell{};
}

bool has_paper(const Table& table, std::size_t column) {
  return std::any_of(table.rows.begin(), table.rows.end(),
                     [&](const Row& row) { return !cell_of(row, column).paper.empty(); });
}

/// One line, in which nothing means anything to Markdown.
std::string markdown(const std::string& text) {
  std::string escaped;
  for (char c : plain_text(text)) {
    if (std::string_view("\\`*_[]<>|#~&").find(c) != std::string_view::npos) escaped += '\\';
    escaped += c;
  }
  return escaped;
}

std::string markdown(const Cell& cell) {
  std::string text = markdown(cell.ours);
  if (!cell.more.empty()) text += (text.empty() ? "" : "; ") + markdown(cell.more);
  if (!cell.paper.empty())
    text += (text.empty() ? "*\\[" : " *\\[") + markdown(cell.paper) + "\\]*";
  return text;
}

std::string markdown_line(const std::vector<std::string>& fields) {
  return fmt::format("| {} |\n", fmt::join(fields, " | "));
}

std::string markdown(const Table& table) {
  std::vector<std::string> heads = {markdown(table.corner)}, rules = {"---"};
  for (const std::string& column : table.columns) {
    heads.push_back(markdown(column));
    rules.push_back("---:");
  }
  std::string text = fmt::format("### {}\n\n", markdown(table.title));
  if (!table.text.empty()) text += markdown(table.text) + "\n\n";
  text += markdown_line(heads) + markdown_line(rules);
  bool was_beyond = false;
  for (const Row& row : table.rows) {
    if (row.is_beyond && !was_beyond) {
      std::vector<std::string> divider(heads.size());
      divider[0] = "**not in the paper**";
      text += markdown_line(divider);
    }
    was_beyond = row.is_beyond;
    std::vector<std::string> fields = {markdown(row.label)};
    for (std::size_t i = 0; i < table.columns.size(); ++i)
      fields.push_back(markdown(cell_of(row, i)));
    text += markdown_line(fields);
  }
  return text + "\n";
}

}  // namespace

std::string to_csv(const Table& table) {
  std::vector<std::string> heads = {table.corner};
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    heads.push_back(table.columns[i]);
    if (has_paper(table, i)) heads.push_back(table.columns[i] + ", paper");
  }
  std::string text = csv_line(heads);
  for (const Row& row : table.rows) {
    std::vector<std::string> fields = {row.label};
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
      const Cell cell = cell_of(row, i);
      fields.push_back(cell.ours);
      if (has_paper(table, i)) fields.push_back(cell.paper);
    }
    text += csv_line(fields);
  }
  return text;
}

std::string to_csv(const Plot& plot) {
  std::string text = "curve,x,y,low,high\n";
  for (const Curve& curve : plot.curves)
    for (const Point& p : curve.points)
      text += csv_line({curve.name, fmt::to_string(p.x), fmt::to_string(p.y), fmt::to_string(p.low),
                        fmt::to_string(p.high)});
  return text;
}

std::string to_markdown(const Report& report) {
  std::string text = fmt::format("# {}\n\n", markdown(report.title));
  if (!report.subtitle.empty()) text += markdown(report.subtitle) + "\n\n";
  text += "Figures of the paper stand in brackets and italics: *\\[1.23\\]*.\n\n";
  for (const auto& [name, value] : report.setting)
    text += fmt::format("- {}: {}\n", markdown(name), markdown(value));
  text += '\n';
  for (const Section& section : report.sections) {
    if (section.tables.empty()) continue;
    text += fmt::format("## {}\n\n", markdown(section.title));
    for (const Table& table : section.tables) text += markdown(table);
  }
  return text;
}

}  // namespace penumbra::reproduce
