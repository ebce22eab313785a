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

TEST(TableCsv, HasAColumnForThePaperWhereItHasFigures) {
  EXPECT_EQ(to_csv(small_table()),
            "method,balls,\"balls, paper\",rings\n"
            "\"(a) \"\"no\"\", really\",1,31,2\n"
            "shaft,0.5,,\n");
}

TEST(PlotCsv, OneLineAPoint) {
  Plot plot;
  plot.curves = {{"a,b", {{1, 2, 1.5, 2.5}, {0.1, 1e-9, 0, 0}}, CurveKind::points, {}, 0}};
  EXPECT_EQ(to_csv(plot), "curve,x,y,low,high\n\"a,b\",1,2,1.5,2.5\n\"a,b\",0.1,1e-09,0,0\n");
}

TEST(Markdown, HasThePaperInBracketsAndWhatItLacksApart) {
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
