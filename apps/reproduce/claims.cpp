// SPDX-License-Identifier: MIT
#include "claims.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>

#include "paper.h"
#include "sample_curves.h"

namespace penumbra::reproduce {
namespace {

std::string single(Method method) { return name_of(Contender{method, RayGrouping::single}); }

/// A claim: one verdict a scene (or light), each with what it rests on.
struct Verdict {
  std::string subject, figure;
  bool holds = false;
};

std::vector<Verdict> by_scene(const Results& results,
                              const std::function<Verdict(const PlannedScene&)>& judge) {
  std::vector<Verdict> verdicts;
  for (std::size_t i = 0; i < results.plan.scenes.size(); ++i) {
    verdicts.push_back(judge(results.plan.scenes[i]));
    verdicts.back().subject = title_of(results.plan, static_cast<PaperSceneIndex>(i));
  }
  return verdicts;
}

std::vector<Verdict> fewer_rays(const Results& results) {
  return by_scene(results, [&](const PlannedScene& scene) {
    std::vector<std::uint64_t> rays;
    for (const Method m : {Method::stochastic, Method::offset, Method::reduced, Method::umbra})
      rays.push_back(results.of(table_setting(scene), single(m)).row.counters.shadow.rays);
    const double saved = static_cast<double>(rays.front()) / static_cast<double>(rays.back());
    const bool holds = rays[0] > rays[1] && std::is_sorted(rays.rbegin(), rays.rend());
    return Verdict{{}, rounded(saved) + " times", holds};
  });
}

std::vector<Verdict> faster(const Results& results) {
  return by_scene(results, [&](const PlannedScene& scene) {
    const Setting s = table_setting(scene);
    const double ratio = results.of(s, single(Method::stochastic)).row.render.median /
                         best_proof(results, s).row.render.median;
    return Verdict{{}, rounded(ratio) + " times", ratio > 1};
  });
}

std::vector<Verdict> hard_is_fastest(const Results& results) {
  return by_scene(results, [&](const PlannedScene& scene) {
    const Setting s = table_setting(scene);
    const double ratio = best_proof(results, s).row.render.median /
                         results.of(s, single(Method::hard)).row.render.median;
    return Verdict{{}, rounded(ratio) + " times (a)", ratio > 1};
  });
}

std::vector<Verdict> reduced_helps(const Results& results) {
  return by_scene(results, [&](const PlannedScene& scene) {
    const auto classes = [&](Method m) {
      return results.of(table_setting(scene), single(m)).row.counters.shadow;
    };
    const ShadowCounters full = classes(Method::offset), reduced = classes(Method::reduced),
                         umbra = classes(Method::umbra);
    return Verdict{{},
                   fmt::format("{} > {} > {}", grouped(full.penumbra), grouped(reduced.penumbra),
                               grouped(umbra.penumbra)),
                   full.penumbra > reduced.penumbra && reduced.penumbra > umbra.penumbra};
  });
}

std::vector<Verdict> small_lights_gain_most(const Results& results) {
  std::vector<Verdict> verdicts;
  double before = 0;
  for (std::size_t i = 0; i < paper_lights.size(); ++i) {
    const Setting s = table4_setting(i);
    const double ratio = results.of(s, single(Method::stochastic)).row.render.median /
                         best_proof(results, s).row.render.median;
    verdicts.push_back({fmt::format("r = {}", paper_lights[i].radius), rounded(ratio) + " times",
                        i == 0 || ratio < before});
    before = ratio;
  }
  return verdicts;
}

std::vector<Verdict> smaller_slopes(const Results& results) {
  std::vector<Verdict> verdicts;
  for (const PaperSceneIndex i : {cylinders, molecule, bust}) {
    const auto slope = [&](Method m) {
      return fitted_time(results, results.plan.scenes[i], single(m)).slope;
    };
    const double ratio =
        slope(Method::stochastic) / slope(i == bust ? Method::reduced : Method::umbra);
    verdicts.push_back({title_of(results.plan, i), rounded(ratio), ratio > 1});
  }
  return verdicts;
}

std::vector<Verdict> at_most_twice_the_memory(const Results& results) {
  return by_scene(results, [&](const PlannedScene& scene) {
    const BenchRow& row = results.of(table_setting(scene), single(Method::umbra)).row;
    const double ratio =
        1 + static_cast<double>(row.shadow_bytes) / static_cast<double>(row.geometry_bytes);
    return Verdict{{}, rounded(ratio), ratio <= paper_most_memory};
  });
}

/// `reason`: why it may fail, known from experience with other machines and scenes.
struct Claim {
  const char *text, *paper, *reason;
  std::vector<Verdict> verdicts;
};

std::vector<Claim> claims_of(const Results& results) {
  return {
      {"Each step leaves fewer shadow rays: (b) > (c) ≥ (d) ≥ (e); how many times fewer by (e)",
       "3.6, 6.6, 6.8, 3.9, 3.7", "", fewer_rays(results)},
      {"Each step leaves fewer points in doubt: (c) > (d) > (e)", "", "", reduced_helps(results)},
      {"The best of (c) to (e) is faster than (b)", "2.31, 2.53, 3.07, 1.67, 1.56",
       "Proofs cost time, too: where light and scene leave little to save, they may cost more "
       "than the rays.",
       faster(results)},
      {"Hard shadows stay the cheapest", "yes",
       "A proof that all of a light is hidden spares even the one ray that hard shadows trace.",
       hard_is_fastest(results)},
      {"The smaller the light, the larger the gain", "7.83 to 1.76",
       "Times of neighbouring sizes lie within the spread of the measurement.",
       small_lights_gain_most(results)},
      {"Time grows more slowly with d: ratio of slopes", "2.1, 2.7, 1.8",
       "The samples of points in doubt cost as much as before, and the doubt grows with the light.",
       smaller_slopes(results)},
      {"At most twice the memory", "≤ 2", "", at_most_twice_the_memory(results)},
  };
}

}  // namespace

Claims check_claims(const Results& results) {
  Claims claims{{"claims",
                 "What the paper found, and what we find",
                 "Our figures in the order of the scenes, or of the lights.",
                 "claim",
                 {"figures", "holds"},
                 {}},
                {}};
  for (const Claim& claim : claims_of(results)) {
    std::vector<std::string> figures, failing;
    for (const Verdict& v : claim.verdicts) {
      figures.push_back(v.figure);
      if (!v.holds) failing.push_back(v.subject);
    }
    const std::string holds =
        failing.empty() ? "yes" : fmt::format("not for {}", fmt::join(failing, ", "));
    claims.table.rows.push_back(
        {claim.text,
         {{fmt::format("{}", fmt::join(figures, ", ")), claim.paper, {}}, {holds, {}, {}}}});
    if (!failing.empty() && *claim.reason)
      claims.reasons.push_back(
          fmt::format("{}: not for {}. {}", claim.text, fmt::join(failing, ", "), claim.reason));
  }
  return claims;
}

}  // namespace penumbra::reproduce
