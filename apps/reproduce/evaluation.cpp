// SPDX-License-Identifier: MIT
#include "evaluation.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <set>
#include <utility>

#include "beyond_curves.h"
#include "claims.h"
#include "notes.h"
#include "number_text.h"
#include "paper_tables.h"
#include "sample_curves.h"

namespace penumbra::reproduce {
namespace {

std::string scenes_text(const Plan& plan) {
  std::vector<std::string> scenes;
  for (const PlannedScene& scene : plan.scenes)
    scenes.push_back(fmt::format("{} ({})", scene.scene, scene.light_radius));
  return fmt::format("{}", fmt::join(scenes, ", "));
}

/// All values that measurements have of something.
std::string values(const Journal& journal, std::string Measurement::*member) {
  std::set<std::string> found;
  for (const Measurement& m : journal.all()) found.insert(m.*member);
  return fmt::format("{}", fmt::join(found, ", "));
}

std::vector<std::pair<std::string, std::string>> setting(const Results& results,
                                                         const Machine& machine) {
  const Plan& plan = results.plan;
  const std::string wide = machine.instruction_set == "AVX3" ? " (AVX-512)" : "";
  return {
      {"Paper", paper_reference},
      {"Its setting", fmt::format("{0} × {0} pixels, rays through pixels' corners, at most 5 rays "
                                  "deep, d = {1} samples a point and light, lights that are balls",
                                  plan.paper_size, paper_samples)},
      {"Scenes (light radius)", scenes_text(plan)},
      {"Rounds", fmt::format("{} for Tables 1 to 4, {} for curves; in each all methods take their "
                             "turn, on one thread; told are medians",
                             plan.rounds, plan.large_rounds)},
      {"Machine", fmt::format("{}, {} cores, {}{}", machine.cpu, machine.cores,
                              machine.instruction_set, wide)},
      {"Built with", fmt::format("{} {}", machine.compiler, machine.flags)},
      {"Program", fmt::format("penumbra {}, checksum {}; Embree {}", machine.version,
                              values(results.journal, &Measurement::program), machine.embree)},
      {"Measured on", values(results.journal, &Measurement::date)},
      {"Command", command_of(plan)},
  };
}

/// How many answers of our methods were held against the judge's, all equal.
std::uint64_t answers_compared(const Journal& journal) {
  std::uint64_t answers = 0;
  for (const Measurement& m : journal.all()) {
    const bool is_ours = m.row.variant.empty(), is_hard = m.row.method.starts_with("hard");
    const bool is_judge = m.row.method == name_of(Contender{Method::stochastic});
    if (is_ours && !is_hard && !is_judge) answers += m.questions;
  }
  return answers;
}

double most_different(const Journal& journal) {
  double most = 0;
  for (const Measurement& m : journal.all()) most = std::max(most, m.row.different_samples);
  return most;
}

Section methods(const Plan& plan) {
  Section section{"methods", "The methods", {}, {}, {}, {}, paragraphs(what_methods_are)};
  if (plan.effort != Effort::full)
    section.paragraphs.push_back(
        plan.effort == Effort::smoke
            ? "This is a smoke test: its pictures are smaller than the paper's, and its figures "
              "mean nothing."
            : "This is a quick run: few rounds, small pictures, few points on the curves.");
  return section;
}

/// "0.75 to 0.99 times"
std::string range_of(const Results& results, const std::function<double(const Setting&)>& ratio) {
  double least = 1e30, most = 0;
  for (const PlannedScene& scene : results.plan.scenes) {
    const double value = ratio(table_setting(results.plan, scene));
    least = std::min(least, value), most = std::max(most, value);
  }
  return fmt::format("{} to {} times", rounded(least), rounded(most));
}

std::string what_is_gained(const Results& results) {
  const auto time = [&](const Setting& s, Contender contender) {
    return results.of(s, contender).row.render.median;
  };
  constexpr Contender packets{Method::stochastic}, umbra{Method::umbra}, shaft{Method::shaft};
  return fmt::format(
      "Traced ray by ray, as in 1998, the best of the paper's methods draws a picture {} as fast "
      "as "
      "(b); the paper has 1.56 to 3.07 times. Beside packets, which make 32 rays of a point cost "
      "about what "
      "a proof costs, they save rays still, but no time: (e) in packets is {} as fast as (b) in "
      "packets. "
      "Shaft, which asks the scene for many points at once, is {} as fast as these.",
      range_of(results,
               [&](const Setting& s) {
                 return time(s, single(Method::stochastic)) /
                        best_proof(results, s).row.render.median;
               }),
      range_of(results, [&](const Setting& s) { return time(s, packets) / time(s, umbra); }),
      range_of(results, [&](const Setting& s) { return time(s, packets) / time(s, shaft); }));
}

Section findings(const Results& results) {
  Claims claims = check_claims(results);
  const std::string compared = fmt::format(
      "The paper speaks of essentially the same images. Ours are the same, bit for bit: while this "
      "was measured, {} answers and all pictures of (c) to (e), of shaft and of rays one by one "
      "were "
      "compared with those of (b) in packets, and none differed. Embree, whose intersection tests "
      "are others, decides at most {:.1g} of the samples otherwise.",
      grouped(static_cast<std::int64_t>(answers_compared(results.journal))),
      most_different(results.journal));
  return {"findings",
          "What holds",
          {compared, what_is_gained(results)},
          {},
          {std::move(claims.table), standing_today(results)},
          {},
          std::move(claims.notes)};
}

Section tables(const Results& results) {
  return {"tables",
          "Tables 1 to 4",
          {"Rows (a) to (e) do what the paper did: every shadow ray is traced by itself, after a "
           "queue of the two occluders that blocked last was asked. Ratios compare, seconds don't: "
           "28 years lie between the machines. Shaded rows are not the paper's."},
          {},
          {run_times(results), building(results), rays_traced(results), tests_per_ray(results),
           memory_taken(results), light_sizes(results)},
          {},
          paragraphs(about_tables)};
}

Section figures(const Results& results) {
  std::vector<Plot> plots = times_against_samples(results);
  for (Plot& plot : fast_times_against_samples(results)) plots.push_back(std::move(plot));
  return {"samples",
          "Figures 6 to 8: time against d",
          {"Ray by ray each sample costs the same, so that times lie on lines: where a line begins "
           "is what proofs cost, its slope is what they leave to be traced. Packets are filled by "
           "some 16 to 32 samples, and shaft chooses by d how it answers: theirs are lines only "
           "roughly. Of the paper's figures we hold the ratios of slopes."},
          {},
          {slopes(results)},
          std::move(plots),
          {}};
}

Section pictures(std::vector<Gallery> galleries) {
  return {
      "pictures",
      "Figures 9 to 13: pictures and classes",
      {"Each scene under its own lights, larger than in the tables, so that shadows are soft "
       "to look at. The maps are about the first of its lights and the middle of each pixel: "
       "pale yellow is lit, vermilion penumbra, dark blue umbra; surfaces that face away "
       "are dark blue, too. By the samples: what d samples found. Proven: what needs no samples; "
       "vermilion is what remains to be sampled. Shaft proves by tiles of pixels, hence the "
       "steps."},
      std::move(galleries),
      {},
      {},
      {}};
}

Section beyond(const Results& results) {
  std::vector<Plot> plots = speed_against_light(results);
  for (Plot& plot : speed_against_size(results)) plots.push_back(std::move(plot));
  plots.push_back(growth(results));
  for (Plot& plot : errors_against_time(results)) plots.push_back(std::move(plot));
  return {
      "beyond",
      "Beyond the paper",
      {"Embree is asked for the same samples in packets of 8, of 16, or in streams, coherent or "
       "not, with spheres of its own or as user geometry; cylinders and cones are user geometry, "
       "tested in lanes. What is fastest in each setting counts (embree_call in "
       "measurements.csv)."},
      {},
      {},
      std::move(plots),
      {}};
}

Section notes(const Plan& plan) {
  Section section{"notes", "Where we differ", {}, {}, {}, {}, paragraphs(where_we_differ)};
  for (const PlannedScene& scene : plan.scenes)
    if (scene.is_stand_in)
      section.notes.push_back(fmt::format(
          "{} stands in for a scene of the paper: nothing of it compares with the paper's figures.",
          scene.scene));
  return section;
}

}  // namespace

Report evaluate(const Results& results, const Machine& machine, std::vector<Gallery> galleries) {
  return {
      "Fast Penumbra Calculation in Ray Tracing, reproduced",
      "The evaluation of a paper of 1998, repeated with penumbra; beside it our own method, and "
      "Embree",
      setting(results, machine),
      {methods(results.plan), findings(results), pictures(std::move(galleries)), tables(results),
       figures(results), beyond(results), notes(results.plan)}};
}

}  // namespace penumbra::reproduce
