// SPDX-License-Identifier: MIT
#include "beyond_curves.h"

#include <fmt/format.h>

#include <functional>
#include <utility>

#include "../options.h"
#include "paper.h"

namespace penumbra::reproduce {
namespace {

const std::string shaft = name_of(Contender{Method::shaft});

/// How much faster `b` does the shadow work than `a`, between the outer quartiles.
Point speedup(double x, const Timing& a, const Timing& b) {
  return {x, a.median / b.median, a.low / b.high, a.high / b.low};
}

using Settings = std::vector<std::pair<double, Setting>>;  // by x

/// One curve a scene, and two plots: over Embree, and over one ray a point.
std::vector<Plot> speed_plots(const Results& results, Plot plot,
                              const std::function<Settings(const PlannedScene&)>& settings) {
  Plot to_hard = plot;
  plot.id += "-speedup", plot.y_label = "speed-up over Embree";
  plot.title = "Speed-up of shaft over Embree's packets, " + plot.title;
  to_hard.id += "-hard", to_hard.y_label = "times one hard ray a point";
  to_hard.title = "Price of shaft in hard shadows, " + to_hard.title;
  int color = 0;
  for (const PaperSceneIndex scene : results.plan.beyond_scenes) {
    Curve faster{title_of(results.plan, scene), {}, CurveKind::points, {}, color};
    Curve dearer = faster;
    for (const auto& [x, setting] : settings(results.plan.scenes[scene])) {
      const Timing& ours = results.of(setting, shaft).row.shadow;
      faster.points.push_back(speedup(x, results.of(setting, embree).row.shadow, ours));
      dearer.points.push_back(speedup(x, ours, results.of(setting, embree_hard).row.shadow));
    }
    plot.curves.push_back(std::move(faster));
    to_hard.curves.push_back(std::move(dearer));
    ++color;
  }
  return {std::move(plot), std::move(to_hard)};
}

}  // namespace

std::vector<Plot> speed_against_light(const Results& results) {
  const Plot plot{"light",
                  "by light radius",
                  fmt::format("Shadow work of a picture of {0} × {0} pixels, d = {1}, mirrors "
                              "included; the fastest of Embree's packets and streams.",
                              results.plan.large_size, paper_samples),
                  "light radius, % of the scene's extent",
                  {},
                  true,
                  true,
                  {}};
  return speed_plots(results, plot, [&](const PlannedScene& scene) {
    Settings settings;
    for (const std::string& radius : results.plan.light_radii)
      settings.push_back(
          {parse_light_radius(radius).value, light_setting(results.plan, scene, radius)});
    return settings;
  });
}

std::vector<Plot> speed_against_size(const Results& results) {
  const Plot plot{"size",
                  "by picture size",
                  fmt::format("Shadow work under lights of {} of the extent, d = {}. Neighbouring "
                              "pixels share queries: the more of them, the more is shared.",
                              results.plan.size_radius, paper_samples),
                  "pixels along an edge",
                  {},
                  true,
                  true,
                  {}};
  return speed_plots(results, plot, [&](const PlannedScene& scene) {
    Settings settings;
    for (const std::uint32_t size : results.plan.sizes)
      settings.push_back({double(size), size_setting(results.plan, scene, size)});
    return settings;
  });
}

Plot growth(const Results& results) {
  Plot plot{"growth",
            "Shadow time a question, by number of objects",
            fmt::format("balls:1 to balls:{}, the same picture of {} × {} pixels with ever finer "
                        "detail, lights of {} of the extent, d = {}.",
                        results.plan.growing.size(), results.plan.large_size,
                        results.plan.large_size, results.plan.size_radius, paper_samples),
            "objects",
            "microseconds a point and light",
            true,
            true,
            {}};
  const std::vector<std::pair<const char*, std::string>> methods{
      {"(b) packets", name_of(Contender{Method::stochastic})},
      {"shaft", shaft},
      {"Embree", embree},
      {"Embree, one ray", embree_hard}};
  int color = 3;  // those of the plots against d
  for (const auto& [name, method] : methods) {
    Curve curve{name, {}, CurveKind::points, {}, color++};
    for (const std::string& scene : results.plan.growing) {
      const Measurement& m = results.of(growth_setting(results.plan, scene), method);
      const double scale = 1e6 / static_cast<double>(m.questions);
      const Timing& t = m.row.shadow;
      curve.points.push_back({double(m.objects), scale * t.median, scale * t.low, scale * t.high});
    }
    plot.curves.push_back(std::move(curve));
  }
  return plot;
}

}  // namespace penumbra::reproduce
