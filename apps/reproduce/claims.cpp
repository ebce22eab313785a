// SPDX-License-Identifier: MIT
#include "claims.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>

#include "number_text.h"
#include "paper.h"
#include "sample_curves.h"

namespace penumbra::reproduce {
namespace {

/// What is found of one scene.
struct Verdict {
  std::string figure;
  bool holds = false;
};

Verdict more_than_one(double ratio) { return {rounded(ratio), ratio > 1}; }

double ratio(std::uint64_t a, std::uint64_t b) {
  return static_cast<double>(a) / static_cast<double>(b);
}

/// An order or trend; `printed`: the paper's figure of it.
struct Claim {
  const char* text;
  std::function<std::optional<Verdict>(PaperSceneIndex)> judge;
  std::function<std::string(const PaperScene&)> printed;
};

/// The paper's variants, ray by ray.
class Judge {
 public:
  explicit Judge(const Results& results) : results_(results) {}

  Verdict fewer_rays(PaperSceneIndex scene) const {
    std::vector<std::uint64_t> rays;
    for (const Method m : {Method::stochastic, Method::offset, Method::reduced, Method::umbra})
      rays.push_back(of(scene, m).row.counters.shadow.rays);
    return {rounded(ratio(rays.front(), *std::min_element(rays.begin(), rays.end()))),
            rays[0] > rays[1] && std::is_sorted(rays.rbegin(), rays.rend())};
  }
  Verdict less_doubt(PaperSceneIndex scene) const {
    const auto doubt = [&](Method m) { return of(scene, m).row.counters.shadow.penumbra; };
    const std::uint64_t full = doubt(Method::offset), reduced = doubt(Method::reduced),
                        umbra = doubt(Method::umbra);
    return {rounded(ratio(full, std::max<std::uint64_t>(umbra, 1))),
            full > reduced && reduced > umbra};
  }
  Verdict faster(PaperSceneIndex scene) const {
    return more_than_one(time(scene, Method::stochastic) / best_time(scene));
  }
  Verdict hard_is_cheapest(PaperSceneIndex scene) const {
    return more_than_one(best_time(scene) / time(scene, Method::hard));
  }
  std::optional<Verdict> smaller_slope(PaperSceneIndex scene) const {
    const std::vector<PaperSceneIndex>& measured = results_.plan.sample_scenes;
    if (std::find(measured.begin(), measured.end(), scene) == measured.end()) return {};
    const auto line = [&](Method m) {
      return fitted_time(results_, results_.plan.scenes[scene], name_of(single(m)));
    };
    const FittedLine plain = line(Method::stochastic), fast = line(fast_method(scene));
    return Verdict{to_text(slope_ratio(plain, fast)), fast.line.slope < plain.line.slope};
  }
  Verdict memory(PaperSceneIndex scene) const {
    const BenchRow& row = of(scene, Method::umbra).row;
    const double times = 1 + ratio(row.shadow_bytes, row.geometry_bytes);
    return {rounded(times), times <= paper_most_memory};
  }

 private:
  const Measurement& of(PaperSceneIndex scene, Method method) const {
    return results_.of(setting(scene), single(method));
  }
  Setting setting(PaperSceneIndex scene) const {
    return table_setting(results_.plan, results_.plan.scenes[scene]);
  }
  double time(PaperSceneIndex scene, Method method) const {
    return of(scene, method).row.render.median;
  }
  double best_time(PaperSceneIndex scene) const {
    return best_proof(results_, setting(scene)).row.render.median;
  }

  const Results& results_;
};

std::vector<Claim> claims_of(const Judge& judge) {
  using Paper = const PaperScene&;
  const auto nothing = [](Paper) { return std::string(); };
  return {
      {"Shadow rays: (b) > (c) ≥ (d) ≥ (e). (b) over the fewest of (c) to (e)",
       [&](PaperSceneIndex s) { return judge.fewer_rays(s); },
       [](Paper p) { return rounded(ratio(p.shadow_rays_plain, p.shadow_rays_best)); }},
      {"Points and lights in doubt: (c) > (d) > (e). (c) over (e)",
       [&](PaperSceneIndex s) { return judge.less_doubt(s); }, nothing},
      {"Time: (b) > best of (c) to (e). (b) over the best",
       [&](PaperSceneIndex s) { return judge.faster(s); },
       [](Paper p) { return rounded(p.seconds_plain / p.seconds_best); }},
      {"Time: best of (c) to (e) > (a). The best over (a)",
       [&](PaperSceneIndex s) { return judge.hard_is_cheapest(s); }, nothing},
      {"Growth with d: that of (b) is steeper. Slope of (b) over that of (e), of (d) for the bust",
       [&](PaperSceneIndex s) { return judge.smaller_slope(s); },
       [](Paper p) { return p.slope_ratio ? rounded(*p.slope_ratio) : std::string(); }},
      {"Memory: at most twice that of (b). (e) over (b)",
       [&](PaperSceneIndex s) { return judge.memory(s); },
       [](Paper) { return fmt::format("≤ {}", paper_most_memory); }},
  };
}

Row row_of(const Plan& plan, const Claim& claim, std::vector<std::string>& failing) {
  Row row{claim.text, {}};
  for (const PaperSceneIndex scene : paper_order) {
    const std::optional<Verdict> verdict = claim.judge(scene);
    const bool compares = verdict && !plan.scenes[scene].is_stand_in;
    row.cells.push_back({verdict ? verdict->figure : std::string(),
                         compares ? claim.printed(paper_scenes[scene]) : std::string(),
                         {}});
    if (verdict && !verdict->holds) failing.push_back(title_of(plan, scene));
  }
  row.cells.push_back({failing.empty() ? "yes" : "not all", {}, {}});
  return row;
}

/// Table 4 in one sentence.
std::string gain_by_light(const Results& results) {
  std::vector<double> gains;
  std::vector<std::string> figures;
  for (std::size_t i = 0; i < paper_lights.size(); ++i) {
    const Setting s = table4_setting(results.plan, i);
    gains.push_back(results.of(s, single(Method::stochastic)).row.render.median /
                    best_proof(results, s).row.render.median);
    figures.push_back(rounded(gains.back()));
  }
  return fmt::format(
      "The smaller the light, the larger the gain (Table 4): the best of (c) to (e) is {} times "
      "faster than (b), from the smallest light to the largest; the paper has {} for the smallest "
      "and {} for the largest. The order is {}.",
      fmt::join(figures, ", "), rounded(*paper_lights.front().speedup),
      rounded(*paper_lights.back().speedup),
      std::is_sorted(gains.rbegin(), gains.rend()) ? "the same" : "not the same throughout");
}

}  // namespace

Claims check_claims(const Results& results) {
  Claims claims{
      {"claims",
       "The paper's orders and trends",
       "Of rows (a) to (e), traced ray by ray as in 1998; rows without figures of the paper "
       "are what its methods lead to expect. \"Same order\" is about medians in every scene "
       "that was measured, not about the size of the figure.",
       "order. Figure",
       scene_titles(results.plan),
       {}},
      {}};
  claims.table.columns.push_back("same order");
  const Judge judge(results);
  for (const Claim& claim : claims_of(judge)) {
    std::vector<std::string> failing;
    claims.table.rows.push_back(row_of(results.plan, claim, failing));
    if (!failing.empty())
      claims.notes.push_back(
          fmt::format("Not so for {}: {}", fmt::join(failing, ", "), claim.text));
  }
  claims.notes.push_back(gain_by_light(results));
  return claims;
}

Table standing_today(const Results& results) {
  Table table{
      "today",
      "What it comes to today",
      "How many times faster a whole picture is, at the paper's settings and by the medians of "
      "Table 1.",
      "",
      scene_titles(results.plan),
      {}};
  const std::string packets = name_of(Contender{Method::stochastic}),
                    umbra = name_of(Contender{Method::umbra}),
                    shaft = name_of(Contender{Method::shaft});
  const std::vector<std::array<std::string, 3>> contests{
      {"(e) than (b), both in packets", umbra, packets},
      {"shaft than (b) in packets", shaft, packets},
      {"shaft than Embree", shaft, embree},
      {"shaft than (b) ray by ray", shaft, name_of(single(Method::stochastic))},
  };
  for (const auto& [label, fast, slow] : contests) {
    Row row{label, {}};
    for (const PaperSceneIndex scene : paper_order) {
      const Setting s = table_setting(results.plan, results.plan.scenes[scene]);
      row.cells.push_back(
          {rounded(results.of(s, slow).row.render.median / results.of(s, fast).row.render.median),
           {},
           {}});
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace penumbra::reproduce
