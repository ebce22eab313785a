// SPDX-License-Identifier: MIT
#include "results.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <stdexcept>

#include "paper.h"

namespace penumbra::reproduce {

const Measurement& Results::of(const Setting& setting, const std::string& method) const {
  if (const Measurement* found = journal.find(setting, method)) return *found;
  throw std::logic_error(fmt::format("not measured: {} of {} in {}, d = {}", method, setting.scene,
                                     setting.experiment, setting.shadow_samples));
}

const std::vector<Variant>& variants() {
  static const std::vector<Variant> all = [] {
    std::vector<Variant> rows;
    const char* letters = "abcde";
    for (const Contender contender : paper_contenders())
      rows.push_back(
          {fmt::format("({}) {}", *letters++, name_of(contender.method)), name_of(contender)});
    rows.push_back({"stochastic, packets", name_of(Contender{Method::stochastic}), true});
    rows.push_back({"umbra, packets", name_of(Contender{Method::umbra}), true});
    rows.push_back({"shaft", name_of(Contender{Method::shaft}), true});
    rows.push_back({"Embree packets", embree, true});
    return rows;
  }();
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

std::string grouped(std::uint64_t number) {
  std::string digits = std::to_string(number);
  for (auto i = static_cast<std::ptrdiff_t>(digits.size()) - 3; i > 0; i -= 3)
    digits.insert(digits.begin() + i, ',');
  return digits;
}

std::string rounded(double number) {
  if (number == 0 || !std::isfinite(number)) return number == 0 ? "0" : "-";
  if (std::abs(number) >= 999.5) return grouped(static_cast<std::uint64_t>(std::llround(number)));
  const int before_point = static_cast<int>(std::floor(std::log10(std::abs(number)))) + 1;
  return fmt::format("{:.{}f}", number, std::min(std::max(0, 3 - before_point), 6));
}

std::string with_spread(const Timing& t) {
  const double percent = t.median > 0 ? 50 * (t.high - t.low) / t.median : 0;
  return fmt::format("{} ms ± {:.0f} %", rounded(1000 * t.median), percent);
}

}  // namespace penumbra::reproduce
