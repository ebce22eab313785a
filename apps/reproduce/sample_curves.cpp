// SPDX-License-Identifier: MIT
#include "sample_curves.h"

#include <fmt/format.h>

#include "paper.h"

namespace penumbra::reproduce {
namespace {

struct Contest {
  const char* name;
  std::string method;
};

/// Those that answer for every d; the place is the curve's colour.
const std::vector<Contest>& contests() {
  const auto single = [](Method m) { return name_of(Contender{m, RayGrouping::single}); };
  static const std::vector<Contest> all{
      {"(b) ray by ray", single(Method::stochastic)},
      {"(d) ray by ray", single(Method::reduced)},
      {"(e) ray by ray", single(Method::umbra)},
      {"(b) packets", name_of(Contender{Method::stochastic})},
      {"shaft", name_of(Contender{Method::shaft})},
      {"Embree", embree},
  };
  return all;
}

constexpr int packets = 3, shaft = 4;  // of them

Curve time_curve(const Results& results, const PlannedScene& scene, int contest) {
  const auto& [name, method] = contests()[static_cast<std::size_t>(contest)];
  Curve curve{name, {}, CurveKind::fitted, fitted_time(results, scene, method), contest};
  for (const std::uint32_t d : results.plan.sample_counts) {
    const Timing& t = results.of(samples_setting(results.plan, scene, d), method).row.render;
    curve.points.push_back({double(d), 1000 * t.median, 1000 * t.low, 1000 * t.high});
  }
  curve.fit.intercept *= 1000, curve.fit.slope *= 1000;
  return curve;
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
std::string figure_name(PaperSceneIndex scene) {
  switch (scene) {
    case cylinders: return "Figure 6: ";
    case molecule: return "Figure 7: ";
    case bust: return "Figure 8: ";
    default: return "Not in the paper: ";
  }
}

}  // namespace

Line fitted_time(const Results& results, const PlannedScene& scene, const std::string& method) {
  double w = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (const std::uint32_t d : results.plan.sample_counts) {
    const double seconds =
        results.of(samples_setting(results.plan, scene, d), method).row.render.median;
    const double weight = 1 / (seconds * seconds);
    w += weight, x += weight * d, y += weight * seconds;
    xx += weight * d * d, xy += weight * d * seconds;
  }
  const double slope = (w * xy - x * y) / (w * xx - x * x);
  return {(y - slope * x) / w, slope};
}

std::vector<Plot> times_against_samples(const Results& results) {
  std::vector<Plot> plots;
  for (const PaperSceneIndex scene : results.plan.sample_scenes) {
    Plot plot{fmt::format("samples-{}", slug_of(scene)),
              figure_name(scene) + title_of(results.plan, scene),
              "Time of a picture against the number of shadow samples, with fitted lines.",
              "shadow samples d",
              "milliseconds",
              false,
              false,
              {}};
    for (int i = 0; i < static_cast<int>(contests().size()); ++i)
      plot.curves.push_back(time_curve(results, results.plan.scenes[scene], i));
    plots.push_back(std::move(plot));
  }
  return plots;
}

Table slopes(const Results& results) {
  Table table{"slopes",
              "Slopes of Figures 6 to 8",
              "What one more sample a point costs a picture, in milliseconds, by the fitted lines; "
              "and how many times less than by (b).",
              "",
              {},
              {}};
  for (const PaperSceneIndex scene : results.plan.sample_scenes)
    table.columns.push_back(title_of(results.plan, scene));
  const std::string& classical = contests().front().method;
  for (const Contest& contest : contests()) {
    Row row{contest.name, {}, !contest.method.ends_with("single rays")};
    for (const PaperSceneIndex index : results.plan.sample_scenes) {
      const PlannedScene& scene = results.plan.scenes[index];
      const double slope = fitted_time(results, scene, contest.method).slope;
      Cell cell{rounded(1000 * slope), {}, {}};
      if (contest.method != classical) {
        const double ratio = fitted_time(results, scene, classical).slope / slope;
        cell.more = rounded(ratio) + " times less";
        // The paper proves no umbra by meshes: on the bust its fast method is our (d).
        const bool is_fast =
            std::string_view(contest.name).starts_with(index == bust ? "(d)" : "(e)");
        if (is_fast && paper_scenes[index].slope_ratio &&
            title_of(results.plan, index) == paper_scenes[index].title)
          cell.paper = rounded(*paper_scenes[index].slope_ratio) + " times less";
      }
      row.cells.push_back(std::move(cell));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

std::vector<Plot> errors_against_time(const Results& results) {
  std::vector<Plot> plots;
  for (const PaperSceneIndex scene : results.plan.sample_scenes) {
    Plot plot{fmt::format("error-{}", slug_of(scene)),
              "Error against time: " + title_of(results.plan, scene),
              fmt::format("Root mean square error of the picture to one of d = {} and another "
                          "seed. Points are d = {} to {}: at the same d the error is the same.",
                          results.plan.reference_samples, results.plan.sample_counts.front(),
                          results.plan.sample_counts.back()),
              "milliseconds",
              "RMSE",
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
