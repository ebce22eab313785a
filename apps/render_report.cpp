// SPDX-License-Identifier: MIT
#include "render_report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "options.h"
<<<<<<< HEAD
#include "output_files.h"
=======
#include "penumbra/version.h"
>>>>>>> pack
#include "resources.h"

namespace penumbra {
namespace {

double ratio(std::uint64_t part, std::uint64_t whole) {
  return whole == 0 ? 0 : static_cast<double>(part) / static_cast<double>(whole);
}

}  // namespace

double geometry_tests_per_ray(const RenderCounters& n) {
  return ratio(n.closest_tests + n.shadow.tests,
               n.primary + n.reflected + n.refracted + n.shadow.rays);
}

double shadow_tests_per_ray(const RenderCounters& n) {
  return ratio(n.shadow.set_tests, n.shadow.set_rays);
}

std::string stats_json(const RenderReport& report, const Picture& picture) {
  const RenderCounters& n = picture.counters;
  const nlohmann::ordered_json json = {
      {"version", PENUMBRA_VERSION},
      {"scene", report.scene},
      {"method", name_of(report.method)},
      {"shadow_samples", report.options.shadow_samples},
      {"size", {picture.image.width, picture.image.height}},
      {"spp", report.options.samples_per_pixel},
      {"seed", report.options.seed},
      {"threads", picture.threads},
      {"seconds",
       {{"load", report.load_seconds},
        {"build", report.build_seconds},
        {"render", picture.seconds.render},
        {"shadow", picture.seconds.shadow}}},
      {"rays",
       {{"primary", n.primary},
        {"reflected", n.reflected},
        {"refracted", n.refracted},
        {"shadow", n.shadow.rays},
        {"shadow_set", n.shadow.set_rays}}},
      {"shadow_queries",
       {{"lit", n.shadow.lit}, {"penumbra", n.shadow.penumbra}, {"umbra", n.shadow.umbra}}},
      {"tests_per_ray",
       {{"geometry", geometry_tests_per_ray(n)}, {"shadow", shadow_tests_per_ray(n)}}},
      {"cache_decided", n.shadow.cache_decided},
      {"verified", report.verified},
      {"memory_bytes", {{"geometry", report.geometry_bytes}, {"shadow", report.shadow_bytes}}},
      {"peak_rss_bytes", peak_rss_bytes()}};
  return json.dump(2) + "\n";
}

void add_metadata(const RenderReport& report, Picture& picture) {
  picture.image.metadata = {
      {"Software", "penumbra " PENUMBRA_VERSION},
      {"Command", command_text(report.arguments)},
      {"Scene", without_folders(report.scene)},
      {"Method", std::string(name_of(report.method))},
      {"ShadowSamples", std::to_string(report.options.shadow_samples)},
      {"SamplesPerPixel", std::to_string(report.options.samples_per_pixel)},
      {"Seed", std::to_string(report.options.seed)},
      {"Size", fmt::format("{}x{}", picture.image.width, picture.image.height)},
      {"RenderSeconds", fmt::format("{:.3f}", picture.seconds.render)}};
}

std::string summary(const std::string& output, const Picture& picture) {
  const RenderCounters& n = picture.counters;
  const std::uint64_t queries = n.shadow.lit + n.shadow.penumbra + n.shadow.umbra;
  const auto percent = [&](std::uint64_t part) { return 100 * ratio(part, queries); };
  const bool is_dark = n.shadow.rays > 0 && n.shadow.lit + n.shadow.penumbra == 0;
  return fmt::format(
      "wrote {}: {}x{}, {:.1f} s; rays: {} primary, {} reflected, {} refracted, {} shadow; "
      "lit {:.0f} %, penumbra {:.0f} %, umbra {:.0f} %{}",
      output, picture.image.width, picture.image.height, picture.seconds.render, n.primary,
      n.reflected, n.refracted, n.shadow.rays, percent(n.shadow.lit), percent(n.shadow.penumbra),
      percent(n.shadow.umbra),
      is_dark ? "\nno light reaches what is seen: are the lights under the ground, or inside "
                "something? (see --light, --ground, and `penumbra info`)"
              : "");
}

}  // namespace penumbra
