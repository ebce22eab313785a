// SPDX-License-Identifier: MIT
#include "paper_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <span>

#include "../render_report.h"
#include "number_text.h"
#include "paper.h"

namespace penumbra::reproduce {
namespace {

constexpr Contender plain = single(Method::stochastic);

using SceneCell = std::function<Cell(const Setting&, const PaperScene&)>;
using VariantCell = std::function<Cell(const Variant&, const Setting&, const PaperScene&)>;

/// A row of one cell a scene; no figures of the paper beside files that stand in.
void add_row(const Results& results, Table& table, std::string label, const SceneCell& cell,
             bool is_beyond = false) {
  Row row{std::move(label), {}, is_beyond};
  for (const PaperSceneIndex scene : paper_order) {
    const PlannedScene& planned = results.plan.scenes[scene];
    row.cells.push_back(cell(table_setting(results.plan, planned), paper_scenes[scene]));
    if (planned.is_stand_in) row.cells.back().paper.clear();
  }
  table.rows.push_back(std::move(row));
}

enum class Whose { papers, ours };

/// One row a variant.
void add_rows(const Results& results, Table& table, const std::string& label, Whose whose,
              std::span<const Variant> variants, const VariantCell& cell) {
  for (const Variant& variant : variants)
    add_row(
        results, table, label + variant.label,
        [&](const Setting& s, const PaperScene& paper) { return cell(variant, s, paper); },
        whose == Whose::ours);
}

/// Time over that of (b).
Cell relative_time(const Results& results, const Setting& setting, const Measurement& m) {
  const double whole = results.of(setting, plain).row.render.median;
  return {rounded(m.row.render.median / whole), {}, with_spread(m.row.render, m.rounds)};
}

/// Ours, and of these with Embree's one for each thing that is built.
std::span<const Variant> our_variants() { return std::span(todays_variants()).first(3); }
std::span<const Variant> built_variants() { return std::span(todays_variants()).subspan(2, 2); }

std::string text_of(const std::optional<std::uint64_t>& printed) {
  return printed ? grouped(*printed) : std::string();
}

}  // namespace

Table run_times(const Results& results) {
  Table table{
      "table1",
      "Table 1: run times",
      fmt::format("Time of a whole picture over that of (b), {0} × {0} pixels, d = {1}, one "
                  "thread, without building; in small print the time, ± half the distance of its "
                  "quartiles over {2} rounds. (a) to (e) trace ray by ray, as in 1998. Embree's "
                  "rows are estimates: those of stochastic packets, with the shadow work, which "
                  "is timed by itself too, replaced by Embree's.",
                  results.plan.paper_size, paper_samples, results.plan.rounds),
      "variant",
      scene_titles(results.plan),
      {}};
  const VariantCell time = [&](const Variant& variant, const Setting& s, const PaperScene& paper) {
    Cell cell = relative_time(results, s, results.of(s, variant.method));
    if (variant.method == name_of(plain)) cell.paper = fmt::format("1 ({} s)", paper.seconds_plain);
    return cell;
  };
  add_rows(results, table, "", Whose::papers, paper_variants(), time);
  add_row(results, table, "best of (c) to (e)", [&](const Setting& s, const PaperScene& paper) {
    Cell cell = relative_time(results, s, best_proof(results, s));
    cell.paper = fmt::format("{} ({} s)", rounded(paper.seconds_best / paper.seconds_plain),
                             paper.seconds_best);
    return cell;
  });
  add_rows(results, table, "", Whose::ours, todays_variants(), time);
  return table;
}

Table rays_traced(const Results& results) {
  Table table{"table2",
              "Table 2: objects, lights, rays",
              "A quad counts as two triangles, lights do not count. Shadow rays are those traced "
              "after the queue of recent occluders was asked; of shaft, most of them are held "
              "against a short list of candidates, not traced through the scene.",
              "",
              scene_titles(results.plan),
              {}};
  const auto of_plain = [&](const char* label, auto cell) {
    add_row(results, table, label, [&](const Setting& s, const PaperScene& paper) {
      return cell(results.of(s, plain), paper);
    });
  };
  of_plain("objects", [](const Measurement& m, const PaperScene& paper) {
    return Cell{grouped(m.objects), grouped(paper.objects), {}};
  });
  of_plain("lights", [](const Measurement& m, const PaperScene&) {
    return Cell{grouped(m.lights), {}, {}};
  });
  const bool is_paper_size = results.plan.effort != Effort::smoke;
  of_plain("primary rays", [&](const Measurement& m, const PaperScene&) {
    return Cell{grouped(m.row.counters.primary),
                is_paper_size ? grouped(paper_primary_rays) : std::string(),
                {}};
  });
  of_plain("reflected rays", [](const Measurement& m, const PaperScene& paper) {
    return Cell{grouped(m.row.counters.reflected), text_of(paper.reflected), {}};
  });
  const VariantCell rays = [&](const Variant& variant, const Setting& s, const PaperScene& paper) {
    Cell cell{grouped(results.of(s, variant.method).row.counters.shadow.rays), {}, {}};
    if (variant.method == name_of(single(Method::hard)))
      cell.paper = text_of(paper.shadow_rays_hard);
    if (variant.method == name_of(plain)) cell.paper = grouped(paper.shadow_rays_plain);
    return cell;
  };
  add_rows(results, table, "shadow rays, ", Whose::papers, paper_variants(), rays);
  add_row(results, table, "shadow rays, fewest of (c) to (e)",
          [&](const Setting& s, const PaperScene& paper) {
            std::uint64_t fewest = UINT64_MAX;
            for (const Contender contender : paper_contenders())
              if (has_shadow_set(contender.method))
                fewest = std::min(fewest, results.of(s, contender).row.counters.shadow.rays);
            return Cell{grouped(fewest), grouped(paper.shadow_rays_best), {}};
          });
  add_rows(results, table, "shadow rays, ", Whose::ours, our_variants(), rays);
  return table;
}

Table tests_per_ray(const Results& results) {
  Table table{
      "table2b",
      "Table 2b: intersection tests a ray",
      "I_geom: primitives tested a ray in the geometry set, over primary, reflected and "
      "traced shadow rays; tests for rays that a recent occluder decided count, too. It "
      "rises from (b) to (d) since the rays that remain are those near occluders. "
      "I_shadow: grown occluders tested a ray in the shadow set; of shaft, records gathered "
      "a query. Hierarchies differ, so these compare among our rows alone.",
      "",
      scene_titles(results.plan),
      {}};
  const VariantCell geometry = [&](const Variant& variant, const Setting& s, const PaperScene&) {
    return Cell{
        fmt::format("{:.2f}", geometry_tests_per_ray(results.of(s, variant.method).row.counters)),
        {},
        {}};
  };
  const VariantCell shadow = [&](const Variant& variant, const Setting& s, const PaperScene&) {
    return Cell{
        fmt::format("{:.2f}", shadow_tests_per_ray(results.of(s, variant.method).row.counters)),
        {},
        {}};
  };
  add_rows(results, table, "I_geom, ", Whose::papers, paper_variants(), geometry);
  add_rows(results, table, "I_shadow, ", Whose::papers, std::span(paper_variants()).subspan(2),
           shadow);
  add_rows(results, table, "I_geom, ", Whose::ours, our_variants(), geometry);
  add_rows(results, table, "I_shadow, ", Whose::ours, our_variants().subspan(1), shadow);
  return table;
}

Table memory_taken(const Results& results) {
  Table table{"table3",
              "Table 3: memory",
              "Over that of (b), which has the geometry set alone; in small print itself. The "
              "paper gives an upper bound in its text.",
              "variant",
              scene_titles(results.plan),
              {}};
  const VariantCell memory = [&](const Variant& variant, const Setting& s, const PaperScene&) {
    const BenchRow& row = results.of(s, variant.method).row;
    const auto bytes = static_cast<double>(row.geometry_bytes + row.shadow_bytes);
    const auto geometry = static_cast<double>(results.of(s, plain).row.geometry_bytes);
    const bool is_bounded = variant.method == name_of(single(Method::umbra));
    return Cell{fmt::format("{:.2f}", bytes / geometry),
                is_bounded ? fmt::format("≤ {}", paper_most_memory) : std::string(),
                bytes < 1e5 ? rounded(bytes / 1e3) + " kB" : rounded(bytes / 1e6) + " MB"};
  };
  add_rows(results, table, "", Whose::papers, paper_variants(), memory);
  add_rows(results, table, "", Whose::ours, built_variants(), memory);
  return table;
}

Table building(const Results& results) {
  Table table{"building",
              "Beside Table 1: building",
              "Milliseconds before the first ray, on one thread: hierarchy and what the method "
              "prepares. The paper does not time it.",
              "variant",
              scene_titles(results.plan),
              {}};
  const VariantCell time = [&](const Variant& variant, const Setting& s, const PaperScene&) {
    return Cell{rounded(1000 * results.of(s, variant.method).row.seconds_build), {}, {}};
  };
  add_rows(results, table, "", Whose::papers, paper_variants(), time);
  add_rows(results, table, "", Whose::ours, built_variants(), time);
  return table;
}

Table light_sizes(const Results& results) {
  Table table{
      "table4",
      "Table 4: light sizes",
      "Balls3: time over that of (b), for lights as large as each of the scene's four sizes "
      "of balls.",
      "variant",
      {},
      {}};
  for (const PaperLight& light : paper_lights)
    table.columns.push_back(fmt::format("r = {}", light.radius));
  const auto add = [&](const std::string& label, bool is_beyond, auto measured) {
    Row row{label, {}, is_beyond};
    for (std::size_t i = 0; i < paper_lights.size(); ++i) {
      const Setting s = table4_setting(results.plan, i);
      row.cells.push_back(relative_time(results, s, measured(s)));
    }
    table.rows.push_back(std::move(row));
  };
  const auto add_variants = [&](const std::vector<Variant>& variants, bool is_beyond) {
    for (const Variant& variant : variants)
      add(variant.label, is_beyond,
          [&](const Setting& s) { return results.of(s, variant.method); });
  };
  add_variants(paper_variants(), false);
  add("best of (c) to (e)", false, [&](const Setting& s) { return best_proof(results, s); });
  for (std::size_t i = 0; i < paper_lights.size(); ++i)
    if (paper_lights[i].speedup)
      table.rows.back().cells[i].paper = rounded(1 / *paper_lights[i].speedup);
  add_variants(todays_variants(), true);
  return table;
}

}  // namespace penumbra::reproduce
