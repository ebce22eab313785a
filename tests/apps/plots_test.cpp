// SPDX-License-Identifier: MIT
#include "plots.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <limits>

#include "gnuplot.h"
#include "html.h"
#include "penumbra/scene/error.h"

namespace penumbra::reproduce {
namespace {

/// $PATH until the end of the test.
class Path {
 public:
  explicit Path(const char* value) : before_(std::getenv("PATH")) { setenv("PATH", value, 1); }
  ~Path() { setenv("PATH", before_.c_str(), 1); }
  Path(const Path&) = delete;
  Path& operator=(const Path&) = delete;

 private:
  std::string before_;
};

TEST(Gnuplot, WhereItIsMissingItsPackageIsNamed) {
  const Path path("/nonexistent");
  try {
    check_gnuplot();
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(error.hint.find("gnuplot-nox"), error.hint.npos);
  }
}

TEST(Plots, ItsComplaintIsTheError) {
  try {
    run_gnuplot("plot what_is_not_there\n");
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(error.problem.find("what_is_not_there"), error.problem.npos);
  }
}

TEST(Plots, ArePicturesWhateverTheValues) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  for (bool has_log : {false, true}) {
    Plot plot{"p", "title", "", "x", "y", has_log, has_log, {}};
    EXPECT_EQ(picture_size(draw(plot).png).width, 1120u);
    plot.curves.push_back({"none", {}, CurveKind::fitted, {1, 2}, 0});
    EXPECT_EQ(picture_size(draw(plot).svg).width, 480u);
    plot.curves.push_back(
        {"some", {{nan, 1}, {0, 0}, {-1, 5}, {2, 3, -4, 7}}, CurveKind::fitted, {1e9, -1}, -1});
    EXPECT_EQ(picture_size(draw(plot).svg).width, 480u);
  }
}

TEST(Plots, NamesRunNothingAndMeanNothing) {
  const std::filesystem::path trace =
      std::filesystem::temp_directory_path() / ("penumbra-" + std::to_string(getpid()));
  const std::string name =
      "`touch " + trace.string() + "` x_1 ^2 {/=9 b} @c \\n $d 'e' \"f\" <&>\n";
  Plot plot{"p", name, "", name, name, false, false, {{name, {{1, 2}}, CurveKind::points, {}, 0}}};
  const std::string svg = draw(plot).svg;
  EXPECT_FALSE(std::filesystem::exists(trace));
  EXPECT_NE(svg.find("’ x_1 ^2 {/=9 b} @c \\n $d ’e’ \"f\" &lt;&amp;"), svg.npos);
}

}  // namespace
}  // namespace penumbra::reproduce
