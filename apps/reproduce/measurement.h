// SPDX-License-Identifier: MIT
// One measured figure set: who, on what, under which setting.
#pragma once

#include <cstdint>
#include <string>
#include <tuple>

#include "../bench_report.h"

namespace penumbra::reproduce {

// The baselines among the methods.
inline constexpr const char* embree = "embree";
inline constexpr const char* embree_hard = "embree_hard";

/// What is asked: a square picture of a scene under one light radius, with one d.
struct Setting {
  std::string experiment;    ///< what for: "tables", "samples", ...
  std::string scene;         ///< a file, or a built-in scene
  std::string light_radius;  ///< in scene units, or with % of the extent
  std::uint32_t size = 128;  ///< pixels along either edge
  std::uint32_t shadow_samples = 32;
  friend bool operator==(const Setting&, const Setting&) = default;
};

struct Measurement {
  Setting setting;
  BenchRow row;  ///< without its ratios, which follow from the others
  std::uint64_t objects = 0, lights = 0, questions = 0;
  double rmse = -1;  ///< of the picture, to one with far more samples; -1: not measured
  std::uint32_t rounds = 0;
  std::string date;
  std::string program;  ///< that measured: checksum of its file
};

/// Calls visit(name, value) for all that is kept of a measurement, in the order of its file.
template <class M, class Visit>
void each_field(M& m, Visit&& visit) {
  visit("experiment", m.setting.experiment);
  visit("scene", m.setting.scene), visit("light_radius", m.setting.light_radius);
  visit("size", m.setting.size), visit("shadow_samples", m.setting.shadow_samples);
  visit("method", m.row.method);
  visit("objects", m.objects), visit("lights", m.lights), visit("questions", m.questions);
  visit("seconds_render", m.row.render.median), visit("seconds_render_low", m.row.render.low);
  visit("seconds_render_high", m.row.render.high), visit("seconds_shadow", m.row.shadow.median);
  visit("seconds_shadow_low", m.row.shadow.low), visit("seconds_shadow_high", m.row.shadow.high);
  visit("seconds_build", m.row.seconds_build);
  auto& n = m.row.counters;
  visit("rays_primary", n.primary), visit("rays_reflected", n.reflected);
  visit("rays_refracted", n.refracted), visit("rays_shadow", n.shadow.rays);
  visit("rays_shadow_set", n.shadow.set_rays), visit("tests_closest", n.closest_tests);
  visit("tests_shadow", n.shadow.tests), visit("tests_shadow_set", n.shadow.set_tests);
  visit("cache_decided", n.shadow.cache_decided), visit("lit", n.shadow.lit);
  visit("penumbra", n.shadow.penumbra), visit("umbra", n.shadow.umbra);
  visit("geometry_bytes", m.row.geometry_bytes), visit("shadow_bytes", m.row.shadow_bytes);
  visit("embree_call", m.row.variant), visit("different_samples", m.row.different_samples);
  visit("rmse", m.rmse), visit("rounds", m.rounds), visit("date", m.date);
  visit("program", m.program);
}

}  // namespace penumbra::reproduce
