// SPDX-License-Identifier: MIT
#include "evaluation.h"

#include <fmt/format.h>

#include <cstddef>
#include <string_view>
#include <utility>

#include "beyond_curves.h"
#include "claims.h"
#include "paper_tables.h"
#include "sample_curves.h"

namespace penumbra::reproduce {
namespace {

std::string scenes_text(const Plan& plan) {
  std::string text;
  for (const PlannedScene& scene : plan.scenes)
    text += fmt::format("{}{} ({})", text.empty() ? "" : ", ", scene.scene, scene.light_radius);
  return text;
}

std::vector<std::pair<std::string, std::string>> setting(const Results& results,
                                                         const Machine& machine) {
  const Plan& plan = results.plan;
  const Measurement& any = results.journal.all().front();
  return {
      {"Paper's picture",
       fmt::format("{0} × {0} pixels, rays through pixels' corners, ray trees of "
                   "at most 5, d = {1}, lights that are balls",
                   plan.paper_size, paper_samples)},
      {"Scenes (light radius)", scenes_text(plan)},
      {"Rounds",
       fmt::format("{} at the paper's size, {} beyond; all methods in turn in each round, "
                   "one thread; medians, ± half the distance of the quartiles",
                   plan.rounds, plan.large_rounds)},
      {"Machine", fmt::format("{}, {} cores, instruction set {}", machine.cpu, machine.cores,
                              machine.instruction_set)},
      {"Built with", fmt::format("{} {}", machine.compiler, machine.flags)},
      {"Versions", fmt::format("penumbra {}, Embree {}", machine.version, machine.embree)},
      {"Date", any.date},
      {"Command", command_of(plan)},
  };
}

/// How many answers of our methods were held against the judge's, all equal.
std::uint64_t answers_compared(const Journal& journal) {
  std::uint64_t answers = 0;
  for (const Measurement& m : journal.all()) {
    const bool is_ours = m.row.variant.empty();
    const bool is_hard = m.row.method.starts_with("hard");
    const bool is_judge = m.row.method == name_of(Contender{Method::stochastic});
    if (is_ours && !is_hard && !is_judge) answers += m.questions;
  }
  return answers;
}

Section findings(const Results& results) {
  Claims claims = check_claims(results);
  return {
      "findings",
      "What holds",
      {fmt::format("The paper proves, by occluders that are grown or shrunk by what the light "
                   "requires, which points see all of a light, and which see nothing of it; "
                   "only the others are sampled. It speaks of essentially the same images. Here "
                   "they are the same, bit for bit: while this page was measured, {} answers were "
                   "compared with those of plain stochastic tracing, and none differed.",
                   grouped(answers_compared(results.journal)))},
      {},
      {std::move(claims.table)},
      {},
      std::move(claims.notes)};
}

Section tables(const Results& results) {
  return {
      "tables",
      "Tables 1 to 4",
      {"Rows (a) to (e) do what the paper did: every shadow ray is traced by itself, after the "
       "queue of two occluders was asked. Ratios compare, seconds don't: three decades "
       "lie between the machines. Below them stands what one would do today: the same samples "
       "in packets of 32 rays, our shaft method, and Embree's packets."},
      {},
      {run_times(results), rays_traced(results), tests_per_ray(results), memory_taken(results),
       light_sizes(results)},
      {},
      {"Which of (c) to (e) was fastest for each scene, the figures that we have of the paper do "
       "not tell; its best is held against our best.",
       "Where a cell shows no figure of the paper's, we have none to compare with: it was not "
       "printed, or is not at hand.",
       "The paper's row (a) of the bust has 32,136 shadow rays for one light, 16,384 primary and "
       "no reflected rays; that cannot be, since each point sends one. Ours has one a point."}};
}

Section figures(const Results& results) {
  return {"samples",
          "Figures 6 to 8: time against d",
          {"Each sample costs the same, so that times lie on lines; what proofs cost is "
           "where the lines begin, and what they save is the slope."},
          {},
          {slopes(results)},
          times_against_samples(results),
          {}};
}

Section pictures(std::vector<Gallery> galleries) {
  return {"pictures",
          "Figures 9 to 13: pictures and classes",
          {"Each scene under its own lights, larger than in the tables, so that shadows are soft "
           "to look at. In the maps pale yellow is lit, vermilion penumbra, dark blue umbra; under "
           "several lights colours mix. By the samples: what d samples found at the centre of each "
           "pixel. Proven: what needs no samples; vermilion is what remains to be sampled."},
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
      {"The shaft method asks the scene itself, for a tile of points at a time. It is "
       "held against the fastest way to ask Embree for the same samples: packets of 8 or 16, or "
       "streams, coherent or not, whichever is fastest on each scene."},
      {},
      {},
      std::move(plots),
      {}};
}

/// One a paragraph.
constexpr std::string_view where_we_differ = R"(
Balls and rings are made by the recipes of Haines' Standard Procedural Databases (sizes 4, 3 and 1,
coordinates rounded to the 6 digits of its files). The generator has changed since 1998: 90 of the
7,381 balls sit elsewhere. Counts of objects and of reflected rays agree none the less.

Cylinders, molecule and bust were not published. Ours have the same kind and number of objects (the
bust to within 0.1 %), but other shapes, cameras and lights: of them only the order of the methods
compares. So the paper's 105,153 shadow rays of the molecule would be some 3,300 points and lights,
as of one light and a molecule that fills a fifth of its picture; ours has two lights and a floor.

Objects: a quad counts as two triangles, lights don't count. Of the rules we tried this one gives
the paper's 7,383, 822 and 62.

Reflected rays: through pixels' corners, at most 5 rays deep with the camera ray as the first,
geometry gives 10,976 for balls with hits in double precision; ours are in single, and four rays on
outlines fall to the other side. For rings the same rule gives some 3,132 where the paper has 2,962;
four rays deep it gives 2,988. Rings reflect a fifth of the light, so that the paper's tracer may
have cut off weak rays.

Shadow rays of (a) and (b): 59,496 times a surface of balls faces a light and asks for a shadow ray.
What the queues of two occluders leave of them depends on the order of the pixels; ours start empty
in every block of 16 × 16.

Light radii of Tables 1 to 3 are ours: that of the smallest balls, two thirds of a ring's, 1 % of
the extent. Those of Table 4 are the radii of the scene's balls.

Our hierarchy is eight wide, and boxes are tested eight at a time, for single rays too; the paper's
tracer was scalar. What a proof costs beside a ray is not what it was.

Our offsets are exact where the paper's are supersets, the inner offset is asked at any distance,
and meshes prove umbra, which the paper left open: more rays are saved than the paper saved.

The time of a picture by Embree is that of stochastic packets with its shadow time replaced by
Embree's.

Building is not part of the times, as in the paper; measurements.csv has it.
)";

/// Paragraphs end at empty lines; other line ends are blanks.
std::vector<std::string> paragraphs(std::string_view text) {
  std::vector<std::string> all(1);
  for (std::size_t i = 1; i < text.size(); ++i) {
    if (text[i] != '\n')
      all.back() += text[i];
    else if (i + 1 < text.size() && text[i + 1] == '\n')
      all.emplace_back(), ++i;
    else if (i + 1 < text.size())
      all.back() += ' ';
  }
  return all;
}

Section notes(const Plan& plan) {
  Section section{"notes", "Where we differ", {}, {}, {}, {}, paragraphs(where_we_differ)};
  if (plan.effort != Effort::full)
    section.notes.push_back(
        "This was no full run: few rounds, small pictures, few points on the curves.");
  return section;
}

}  // namespace

Report evaluate(const Results& results, const Machine& machine, std::vector<Gallery> galleries) {
  return {
      "Fast Penumbra Calculation in Ray Tracing, reproduced",
      "The evaluation of A. Formella and A. Lukaszewski (WSCG 1998), repeated with penumbra, and "
      "our own method and today's competitor beside it",
      setting(results, machine),
      {findings(results), pictures(std::move(galleries)), tables(results), figures(results),
       beyond(results), notes(results.plan)}};
}

}  // namespace penumbra::reproduce
