// SPDX-License-Identifier: MIT
#include "page.h"

#include <fmt/format.h>

#include <algorithm>

#include "html.h"
#include "page_parts.h"
#include "page_style.h"

namespace penumbra::reproduce {
namespace {

std::string paragraph(const std::string& text) { return fmt::format("<p>{}</p>\n", escape(text)); }

std::string setting_html(const Report& report) {
  if (report.setting.empty()) return {};
  std::string html = "<dl class=\"setting\">\n";
  for (const auto& [name, value] : report.setting)
    html += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>\n", escape(name), escape(value));
  return html + "</dl>\n";
}

std::string link_html(const std::string& id, const std::string& title) {
  return fmt::format("<li><a href=\"#{}\">{}</a>", escape(id), escape(title));
}

/// "Table 1" of "Table 1: run times": contents lists have little room.
std::string short_title(const std::string& title) { return title.substr(0, title.find(':')); }

std::string contents_html(const Report& report) {
  std::string html = "<nav aria-label=\"Contents\">\n<h2>Contents</h2>\n<ol>\n";
  for (const Section& section : report.sections) {
    html += link_html(section.id, section.title);
    std::string parts;
    for (const Gallery& g : section.galleries)
      parts += link_html(g.id, short_title(g.title)) + "</li>";
    for (const Table& t : section.tables) parts += link_html(t.id, short_title(t.title)) + "</li>";
    for (const Plot& p : section.plots) parts += link_html(p.id, short_title(p.title)) + "</li>";
    if (!parts.empty()) html += "\n<ul>" + parts + "</ul>";
    html += "</li>\n";
  }
  return html + "</ol>\n</nav>\n";
}

bool has_paper(const Report& report) {
  for (const Section& section : report.sections)
    for (const Table& table : section.tables)
      for (const Row& row : table.rows)
        for (const Cell& cell : row.cells)
          if (!cell.paper.empty()) return true;
  return false;
}

constexpr const char* legend_html =
    "<p class=\"legend\"><span class=\"ours\">1.23</span> measured here; "
    "<span class=\"paper\">[1.23]</span> printed in the paper: in italics, in brackets; "
    "shaded rows are not in the paper.</p>\n";

std::string plots_html(const Section& section,
                       const std::map<std::string, std::string>& svg_by_plot_id) {
  if (section.plots.empty()) return {};
  std::string html = "<div class=\"plots\">\n";
  for (const Plot& plot : section.plots) {
    const auto svg = svg_by_plot_id.find(plot.id);
    html += plot_html(plot, svg == svg_by_plot_id.end() ? std::string() : svg->second);
  }
  return html + "</div>\n";
}

std::string notes_html(const Section& section) {
  if (section.notes.empty()) return {};
  std::string html = "<ul class=\"notes\">\n";
  for (const std::string& note : section.notes) html += fmt::format("<li>{}</li>\n", escape(note));
  return html + "</ul>\n";
}

std::string section_html(const Section& section,
                         const std::map<std::string, std::string>& svg_by_plot_id) {
  std::string html =
      fmt::format("<section id=\"{}\">\n<h2>{}</h2>\n", escape(section.id), escape(section.title));
  for (const std::string& text : section.paragraphs) html += paragraph(text);
  if (!section.galleries.empty()) {
    html += "<div class=\"galleries\">\n";
    for (const Gallery& gallery : section.galleries) html += gallery_html(gallery);
    html += "</div>\n";
  }
  for (const Table& table : section.tables) html += table_html(table);
  return html + plots_html(section, svg_by_plot_id) + notes_html(section) + "</section>\n";
}

/// The rules that show the chosen view, for as many views as the largest gallery has.
std::string view_rules(const Report& report) {
  std::size_t most = 0;
  for (const Section& section : report.sections)
    for (const Gallery& gallery : section.galleries) most = std::max(most, gallery.views.size());
  std::string rules;
  for (std::size_t i = 1; i <= most; ++i)
    rules += fmt::format(
        ".gallery input:nth-of-type({0}):checked ~ .frame .view:nth-child({0}) "
        "{{ visibility: visible; }}\n",
        i);
  return rules;
}

}  // namespace

std::string to_html(const Report& report,
                    const std::map<std::string, std::string>& svg_by_plot_id) {
  std::string html =
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"color-scheme\" content=\"light\">\n<link rel=\"icon\" href=\"data:,\">\n";
  html += fmt::format("<title>{}</title>\n<style>\n{}{}</style>\n</head>\n<body>\n",
                      escape(report.title), page_style(), view_rules(report));
  html += fmt::format("<header>\n<h1>{}</h1>\n", escape(report.title));
  if (!report.subtitle.empty())
    html += fmt::format("<p class=\"subtitle\">{}</p>\n", escape(report.subtitle));
  html += setting_html(report);
  if (has_paper(report)) html += legend_html;
  html += "</header>\n" + contents_html(report) + "<main>\n";
  for (const Section& section : report.sections) html += section_html(section, svg_by_plot_id);
  return html + "</main>\n</body>\n</html>\n";
}

}  // namespace penumbra::reproduce
