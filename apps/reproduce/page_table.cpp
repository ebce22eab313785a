// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "html.h"
#include "page_parts.h"

namespace penumbra::reproduce {
namespace {

std::string cell_html(const Cell& cell, const std::string& column) {
  std::string text = fmt::format("<td data-label=\"{}\"><div>", escape(column));
  text +=
      fmt::format("<span class=\"ours\">{}</span>", cell.ours.empty() ? "–" : escape(cell.ours));
  if (!cell.more.empty()) text += fmt::format(" <small>{}</small>", escape(cell.more));
  if (!cell.paper.empty())
    text += fmt::format(" <span class=\"paper\">[{}]</span>", escape(cell.paper));
  return text + "</div></td>";
}

/// Nothing at all to say: cards leave such cells out.
bool is_empty(const Cell& cell) {
  return cell.ours.empty() && cell.paper.empty() && cell.more.empty();
}

std::string row_html(const Row& row, const std::vector<std::string>& columns) {
  std::string text = fmt::format("<tr><th scope=\"row\">{}</th>", escape(row.label));
  for (std::size_t i = 0; i < columns.size(); ++i)
    text += i < row.cells.size() && !is_empty(row.cells[i]) ? cell_html(row.cells[i], columns[i])
                                                            : "<td class=\"none\"></td>";
  return text + "</tr>\n";
}

std::string head_html(const Table& table) {
  std::string text = fmt::format("<thead><tr><th scope=\"col\">{}</th>", escape(table.corner));
  for (const std::string& column : table.columns)
    text += fmt::format("<th scope=\"col\">{}</th>", escape(column));
  return text + "</tr></thead>\n";
}

/// One <tbody> for each run of rows that are in the paper, or are not.
std::string bodies_html(const Table& table) {
  std::string text;
  for (std::size_t i = 0; i < table.rows.size();) {
    const bool is_beyond = table.rows[i].is_beyond;
    text += is_beyond ? fmt::format(
                            "<tbody class=\"beyond\">\n<tr class=\"divider\">"
                            "<th scope=\"rowgroup\" colspan=\"{}\">Not in the paper</th></tr>\n",
                            table.columns.size() + 1)
                      : "<tbody>\n";
    for (; i < table.rows.size() && table.rows[i].is_beyond == is_beyond; ++i)
      text += row_html(table.rows[i], table.columns);
    text += "</tbody>\n";
  }
  return text;
}

bool has_paper(const Table& table) {
  for (const Row& row : table.rows)
    for (const Cell& cell : row.cells)
      if (!cell.paper.empty()) return true;
  return false;
}

/// By how much room its columns want, and whether there is something to compare with.
std::string class_of(const Table& table) {
  std::string kind = table.columns.size() > 4 ? "many" : table.columns.size() > 1 ? "some" : "few";
  return has_paper(table) ? kind + " compared" : kind;
}

}  // namespace

std::string table_html(const Table& table) {
  const std::string id = escape(table.id);
  std::string text = fmt::format("<div class=\"sheet\" id=\"{}\">\n<table class=\"{}\">\n<caption>",
                                 id, class_of(table));
  text += fmt::format("<strong>{}</strong>", escape(table.title));
  if (!table.text.empty()) text += fmt::format(" <span>{}</span>", escape(table.text));
  text += "</caption>\n" + head_html(table) + bodies_html(table) + "</table>\n";
  return text + fmt::format("<p class=\"files\"><a href=\"{0}.csv\">{0}.csv</a></p>\n</div>\n",
                            escape(file_link(table.id)));
}

}  // namespace penumbra::reproduce
