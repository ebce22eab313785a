// SPDX-License-Identifier: MIT
#include "tables_text.h"

#include <gtest/gtest.h>

namespace penumbra::reproduce {
namespace {

Table small_table() {
  return {"t",
          "Table 1: times",
          "In *seconds*.",
          "method",
          {"balls", "rings"},
          {{"(a) \"no\", really", {{"1", "31", "± 2"}, {"2", "", ""}}, false},
           {"shaft", {{"0.5", "", ""}}, true}}};
}

TEST(TableCsv, has_a_column_for_the_paper_where_it_has_figures) {
  EXPECT_EQ(to_csv(small_table()),
            "method,balls,\"balls, paper\",rings\n"
            "\"(a) \"\"no\"\", really\",1,31,2\n"
            "shaft,0.5,,\n");
}

TEST(PlotCsv, one_line_a_point) {
  Plot plot;
  plot.curves = {{"a,b", {{1, 2, 1.5, 2.5}, {0.1, 1e-9, 0, 0}}, CurveKind::points, {}, 0}};
  EXPECT_EQ(to_csv(plot), "curve,x,y,low,high\n\"a,b\",1,2,1.5,2.5\n\"a,b\",0.1,1e-09,0,0\n");
}

TEST(Markdown, has_the_paper_in_brackets_and_what_it_lacks_apart) {
  Report report{"Again", "", {{"CPU", "a_b"}}, {}};
  report.sections.push_back({"s", "Times", {}, {}, {small_table()}, {}, {}});
  EXPECT_EQ(to_markdown(report),
            "# Again\n\n"
            "Figures of the paper stand in brackets and italics: *\\[1.23\\]*.\n\n"
            "- CPU: a\\_b\n\n"
            "## Times\n\n"
            "### Table 1: times\n\n"
            "In \\*seconds\\*.\n\n"
            "| method | balls | rings |\n"
            "| --- | ---: | ---: |\n"
            "| (a) \"no\", really | 1; ± 2 *\\[31\\]* | 2 |\n"
            "| **not in the paper** |  |  |\n"
            "| shaft | 0.5 |  |\n\n");
}

}  // namespace
}  // namespace penumbra::reproduce
