// SPDX-License-Identifier: MIT
#include "sample_curves.h"

#include <fmt/format.h>

#include <initializer_list>

#include "number_text.h"
#include "paper.h"

namespace penumbra::reproduce {
namespace {

struct Contest {
  const char* name;
  std::string method;
};

/// Those that answer for every d; the place is the curve's colour.
const std::vector<Contest>& contests() {
  static const std::vector<Contest> all{
      {"(b) ray by ray", name_of(single(Method::stochastic))},
      {"(d) ray by ray", name_of(single(Method::reduced))},
      {"(e) ray by ray", name_of(single(Method::umbra))},
      {"(b) packets", name_of(Contender{Method::stochastic})},
      {"shaft", name_of(Contender{Method::shaft})},
      {"Embree", embree},
  };
  return all;
}

constexpr int umbra = 2, packets = 3, shaft = 4, embrees = 5;  // of them

std::vector<Point> times(const Results& results, const PlannedScene& scene,
                         const std::string& method, std::uint32_t least_samples) {
  std::vector<Point> points;
  for (const std::uint32_t d : results.plan.sample_counts) {
    if (d < least_samples) continue;
    const Timing& t = results.of(samples_setting(results.plan, scene, d), method).row.render;
    points.push_back({double(d), 1000 * t.median, 1000 * t.low, 1000 * t.high});
  }
  return points;
}

Curve time_curve(const Results& results, const PlannedScene& scene, int contest) {
  const auto& [name, method] = contests()[static_cast<std::size_t>(contest)];
  return {name, times(results, scene, method, 0), CurveKind::fitted,
          fitted_time(results, scene, method).line, contest};
}

Curve error_curve(const Results& results, const PlannedScene& scene, int contest) {
  const auto& [name, method] = contests()[static_cast<std::size_t>(contest)];
  Curve curve{name, {}, CurveKind::points, {}, contest};
  for (const std::uint32_t d : results.plan.sample_counts) {
    const Measurement& m = results.of(samples_setting(results.plan, scene, d), method);
    curve.points.push_back({1000 * m.row.render.median, m.rmse, m.rmse, m.rmse});
  }
  return curve;
}

/// The paper prints three of them.
std::string figure_name(const Plan& plan, PaperSceneIndex scene) {
  const std::string title = title_of(plan, scene);
  switch (scene) {
    case cylinders: return "Figure 6: " + title;
    case molecule: return "Figure 7: " + title;
    case bust: return "Figure 8: " + title;
    default: return title + ", not in the paper";
  }
}

std::vector<Plot> time_plots(const Results& results, const char* id, const char* text,
                             std::initializer_list<int> chosen) {
  std::vector<Plot> plots;
  for (const PaperSceneIndex scene : results.plan.sample_scenes) {
    Plot plot{fmt::format("{}-{}", id, slug_of(scene)),
              figure_name(results.plan, scene),
              text,
              "shadow samples d",
              "milliseconds a picture",
              false,
              false,
              {}};
    for (const int i : chosen)
      plot.curves.push_back(time_curve(results, results.plan.scenes[scene], i));
    plots.push_back(std::move(plot));
  }
  return plots;
}

}  // namespace

FittedLine fitted_time(const Results& results, const PlannedScene& scene,
                       const std::string& method) {
  const bool is_short = results.plan.effort == Effort::smoke;
  return fit_line(times(results, scene, method, is_short ? 0 : 8));
}

std::vector<Plot> times_against_samples(const Results& results) {
  return time_plots(results, "samples",
                    "Time of a picture against the number of shadow samples, with lines fitted to "
                    "d ≥ 8.",
                    {0, 1, umbra, packets, shaft, embrees});
}

std::vector<Plot> fast_times_against_samples(const Results& results) {
  std::vector<Plot> plots =
      time_plots(results, "samples-fast", "The same without (b) and (d) ray by ray.",
                 {umbra, packets, shaft, embrees});
  for (Plot& plot : plots) plot.title += ", the faster ones";
  return plots;
}

std::string to_text(const SlopeRatio& ratio) {
  return (ratio.is_bound ? "> " : "") + rounded(ratio.times);
}

Table slopes(const Results& results) {
  Table table{
      "slopes",
      "Slopes of Figures 6 to 8",
      "How many times more slowly time grows with d than by (b), by lines fitted to d ≥ 8; in "
      "small print the slope, microseconds a sample. A bound stands where a line cannot be "
      "told from level by two standard errors.",
      "",
      {},
      {}};
  for (const PaperSceneIndex scene : results.plan.sample_scenes)
    table.columns.push_back(title_of(results.plan, scene));
  for (const Contest& contest : contests()) {
    Row row{contest.name, {}, !contest.method.ends_with("single rays")};
    for (const PaperSceneIndex index : results.plan.sample_scenes) {
      const PlannedScene& scene = results.plan.scenes[index];
      const FittedLine plain = fitted_time(results, scene, contests().front().method),
                       line = fitted_time(results, scene, contest.method);
      const bool is_compared = contest.method == name_of(single(fast_method(index))) &&
                               paper_scenes[index].slope_ratio && !scene.is_stand_in;
      row.cells.push_back({to_text(slope_ratio(plain, line)),
                           is_compared ? rounded(*paper_scenes[index].slope_ratio) : std::string(),
                           fmt::format("{} µs", rounded(1000 * line.line.slope))});
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

std::vector<Plot> errors_against_time(const Results& results) {
  std::vector<Plot> plots;
  for (const PaperSceneIndex scene : results.plan.sample_scenes) {
    Plot plot{fmt::format("error-{}", slug_of(scene)),
              "Error against time, " + title_of(results.plan, scene),
              fmt::format(
                  "Root mean square error of linear colours to a picture of d = {} and another "
                  "seed, against the time of a picture. Points are d = {} to {}: at the same d all "
                  "methods have the same error, since they draw the same picture.",
                  results.plan.reference_samples, results.plan.sample_counts.front(),
                  results.plan.sample_counts.back()),
              "milliseconds a picture",
              "RMSE of linear colours",
              true,
              true,
              {}};
    for (const int contest : {0, packets, shaft})
      plot.curves.push_back(error_curve(results, results.plan.scenes[scene], contest));
    plots.push_back(std::move(plot));
  }
  return plots;
}

}  // namespace penumbra::reproduce
