// SPDX-License-Identifier: MIT
#include "page.h"

#include <gtest/gtest.h>

namespace penumbra::reproduce {
namespace {

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != text.npos;
}

const std::string hostile = "<script>'\"&";
const std::string harmless = "&lt;script&gt;&#39;&quot;&amp;";

/// Every text of it is `hostile`.
Report hostile_report() {
  Section section{"s", hostile, {hostile}, {}, {}, {}, {hostile}};
  section.galleries.push_back({"g", hostile, hostile, {{hostile, hostile, "image/png", "x"}}});
  section.tables.push_back(
      {"t", hostile, hostile, hostile, {hostile}, {{hostile, {{hostile, hostile, hostile}}}}});
  section.plots.push_back({"p", hostile, hostile, hostile, hostile, false, false, {}});
  return {hostile, hostile, {{hostile, hostile}}, {section}};
}

TEST(Page, TextsAreText) {
  const std::string page = to_html(hostile_report(), {{"p", "<svg width=\"4\" height=\"3\">"}});
  EXPECT_FALSE(holds(page, "<script"));
  EXPECT_TRUE(holds(page, "<td data-label=\"" + harmless + "\">"));
  EXPECT_TRUE(holds(page, "href=\"%3Cscript%3E%27%22%26\""));
  EXPECT_TRUE(holds(page, "width=\"4\" height=\"3\" alt=\"" + harmless + ": " + harmless));
}

TEST(Page, RowsThatThePaperLacksAreSetApart) {
  Report report{"r", "", {}, {{"s", "s", {}, {}, {}, {}, {}}}};
  report.sections[0].tables.push_back(
      {"t", "t", "", "", {"a"}, {{"x", {{"1", "2", ""}}}, {"y", {{"3", "", ""}}, true}}});
  const std::string page = to_html(report, {});
  const auto divider = page.find("Not in the paper");
  EXPECT_LT(page.find("<span class=\"paper\">[2]</span>"), divider);
  EXPECT_GT(page.find("<th scope=\"row\">y</th>"), divider);
  EXPECT_TRUE(holds(page, "<p class=\"legend\">"));
  report.sections[0].tables[0].rows[0].cells[0].paper.clear();
  EXPECT_FALSE(holds(to_html(report, {}), "<p class=\"legend\">"));
}

}  // namespace
}  // namespace penumbra::reproduce
