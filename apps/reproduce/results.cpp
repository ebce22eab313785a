// SPDX-License-Identifier: MIT
#include "results.h"

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <stdexcept>

#include "number_text.h"
#include "paper.h"

namespace penumbra::reproduce {

const Measurement& Results::of(const Setting& setting, const std::string& method) const {
  if (const Measurement* found = journal.find(setting, method)) return *found;
  throw std::logic_error(fmt::format("not measured: {} of {} in {}, d = {}", method, setting.scene,
                                     setting.experiment, setting.shadow_samples));
}

const std::vector<Variant>& paper_variants() {
  static const std::vector<Variant> all = [] {
    std::vector<Variant> rows;
    const char* letters = "abcde";
    for (const Contender contender : paper_contenders())
      rows.push_back(
          {fmt::format("({}) {}", *letters++, name_of(contender.method)), name_of(contender)});
    return rows;
  }();
  return all;
}

const std::vector<Variant>& todays_variants() {
  static const std::vector<Variant> all{
      {"stochastic, packets", name_of(Contender{Method::stochastic})},
      {"umbra, packets", name_of(Contender{Method::umbra})},
      {"shaft", name_of(Contender{Method::shaft})},
      {"Embree", embree},
      {"hard by Embree", embree_hard}};
  return all;
}

const Measurement& best_proof(const Results& results, const Setting& setting) {
  const Measurement* best = nullptr;
  for (const Contender contender : paper_contenders()) {
    if (!has_shadow_set(contender.method)) continue;
    const Measurement& m = results.of(setting, contender);
    if (!best || m.row.render.median < best->row.render.median) best = &m;
  }
  return *best;
}

const char* slug_of(PaperSceneIndex scene) {
  constexpr std::array slugs{"cylinders", "balls", "rings", "molecule", "bust"};
  return slugs[scene];
}

std::string title_of(const Plan& plan, PaperSceneIndex scene) {
  const PlannedScene& planned = plan.scenes[scene];
  return planned.is_stand_in ? std::filesystem::path(planned.scene).filename().string()
                             : paper_scenes[scene].title;
}

std::vector<std::string> scene_titles(const Plan& plan) {
  std::vector<std::string> titles;
  for (const PaperSceneIndex scene : paper_order) titles.push_back(title_of(plan, scene));
  return titles;
}

std::string with_spread(const Timing& t, std::uint32_t rounds) {
  const std::string time = rounded(1000 * t.median) + " ms";
  if (rounds < 2 || t.median <= 0) return time;
  const double percent = 50 * (t.high - t.low) / t.median;
  return percent < 1 ? time + " ± < 1 %" : fmt::format("{} ± {:.0f} %", time, percent);
}

}  // namespace penumbra::reproduce
