// SPDX-License-Identifier: MIT
#include "beyond_curves.h"

#include <fmt/format.h>

#include <functional>
#include <utility>

#include "../options.h"

namespace penumbra::reproduce {
namespace {

constexpr Contender shaft{Method::shaft};

/// How many times longer `a` takes than `b`, between the outer quartiles.
Point speedup(double x, const Timing& a, const Timing& b) {
  return {x, a.median / b.median, a.low / b.high, a.high / b.low};
}

using Settings = std::vector<std::pair<double, Setting>>;  // by x

/// What `shaft` is held against, a plot each.
struct Rival {
  const char *id, *title, *y_label;
  std::string method;
  bool is_price = false;  ///< the ratio is ours over theirs
};

const std::vector<Rival>& rivals() {
  static const std::vector<Rival> all{
      {"embree", "Speed-up of shaft over Embree, ", "speed-up over Embree", embree},
      {"packets", "Speed-up of shaft over our own packets, ", "speed-up over (b) in packets",
       name_of(Contender{Method::stochastic})},
      {"hard", "Price of shaft in hard shadows, ", "times one ray a point by Embree", embree_hard,
       true}};
  return all;
}

/// One curve a scene, one plot a rival.
std::vector<Plot> speed_plots(const Results& results, const Plot& about,
                              const std::function<Settings(const PlannedScene&)>& settings) {
  std::vector<Plot> plots;
  for (const Rival& rival : rivals()) {
    Plot plot = about;
    plot.id += std::string("-") + rival.id;
    plot.title = rival.title + about.title;
    plot.y_label = rival.y_label;
    int color = 0;
    for (const PaperSceneIndex scene : results.plan.beyond_scenes) {
      Curve curve{title_of(results.plan, scene), {}, CurveKind::points, {}, color++};
      for (const auto& [x, setting] : settings(results.plan.scenes[scene])) {
        const Timing &ours = results.of(setting, shaft).row.shadow,
                     &theirs = results.of(setting, rival.method).row.shadow;
        curve.points.push_back(rival.is_price ? speedup(x, ours, theirs)
                                              : speedup(x, theirs, ours));
      }
      plot.curves.push_back(std::move(curve));
    }
    plots.push_back(std::move(plot));
  }
  return plots;
}

}  // namespace

std::vector<Plot> speed_against_light(const Results& results) {
  const Plot plot{
      "light",
      "by light radius",
      fmt::format("Shadow work alone of a picture of {0} × {0} pixels, d = {1}, mirrors "
                  "included. Bars are between the outer quartiles.",
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
  const Plot plot{
      "size",
      "by picture size",
      fmt::format("Shadow work alone under lights of {} of the extent, d = {}. Queries are "
                  "shared by tiles of neighbouring pixels.",
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
            "µs a point and light",
            true,
            true,
            {}};
  const std::vector<std::pair<const char*, std::string>> methods{
      {"(b) packets", name_of(Contender{Method::stochastic})},
      {"shaft", name_of(shaft)},
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
