// SPDX-License-Identifier: MIT
#include "paper_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "number_text.h"
#include "paper.h"

namespace penumbra::reproduce {
namespace {

constexpr Contender plain = single(Method::stochastic);

/// A row of one cell a scene; no figures of the paper beside files that stand in.
Row scene_row(const Results& results, std::string label,
              const std::function<Cell(const Setting&, const PaperScene&)>& cell) {
  Row row{std::move(label), {}, false};
  for (const PaperSceneIndex scene : paper_order) {
    row.cells.push_back(
        cell(table_setting(results.plan, results.plan.scenes[scene]), paper_scenes[scene]));
    if (results.plan.scenes[scene].is_stand_in) row.cells.back().paper.clear();
  }
  return row;
}

/// Time over that of (b).
Cell relative_time(const Results& results, const Setting& setting, const Measurement& m) {
  const double whole = results.of(setting, plain).row.render.median;
  return {rounded(m.row.render.median / whole), {}, with_spread(m.row.render, m.rounds)};
}

bool is_of_embree(const Variant& variant) {
  return variant.method == embree || variant.method == embree_hard;
}

std::string text_of(const std::optional<std::uint64_t>& printed) {
  return printed ? grouped(*printed) : std::string();
}

double tests_a_ray(const RenderCounters& n) {
  const std::uint64_t rays = n.primary + n.reflected + n.refracted + n.shadow.rays;
  return rays == 0
             ? 0
             : static_cast<double>(n.closest_tests + n.shadow.tests) / static_cast<double>(rays);
}

double set_tests_a_ray(const ShadowCounters& n) {
  return n.set_rays == 0 ? 0 : static_cast<double>(n.set_tests) / static_cast<double>(n.set_rays);
}

}  // namespace

Table run_times(const Results& results) {
  Table table{
      "table1",
      "Table 1: run times",
      fmt::format(
          "Time of a whole picture over that of (b), {0} × {0} pixels, d = {1}, one thread, "
          "without building; in small print the time, ± half the distance of its quartiles "
          "over {2} rounds. (a) to (e) trace ray by ray, as in 1998. Embree's rows are estimates: "
          "those "
          "of (b) in packets, with the shadow work, which is timed by itself too, replaced by "
          "Embree's.",
          results.plan.paper_size, paper_samples, results.plan.rounds),
      "variant",
      scene_titles(results.plan),
      {}};
  for (const Variant& variant : variants()) {
    if (variant.is_beyond && !table.rows.back().is_beyond) {
      table.rows.push_back(
          scene_row(results, "best of (c) to (e)", [&](const Setting& s, const PaperScene& paper) {
            Cell cell = relative_time(results, s, best_proof(results, s));
            cell.paper = fmt::format("{} ({} s)", rounded(paper.seconds_best / paper.seconds_plain),
                                     paper.seconds_best);
            return cell;
          }));
    }
    table.rows.push_back(
        scene_row(results, variant.label, [&](const Setting& s, const PaperScene& paper) {
          Cell cell = relative_time(results, s, results.of(s, variant.method));
          if (variant.method == name_of(plain))
            cell.paper = fmt::format("1 ({} s)", paper.seconds_plain);
          return cell;
        }));
    table.rows.back().is_beyond = variant.is_beyond;
  }
  return table;
}

Table rays_traced(const Results& results) {
  Table table{"table2",
              "Table 2: objects, lights, rays",
              "A quad counts as two triangles, lights do not count. Shadow rays are those traced "
              "after the queue of "
              "recent occluders was asked; of shaft, most of them are held against a short list of "
              "candidates, not traced through the scene.",
              "",
              scene_titles(results.plan),
              {}};
  const auto add = [&](const char* label, auto number) {
    table.rows.push_back(scene_row(results, label, [&](const Setting& s, const PaperScene& paper) {
      return number(results.of(s, plain), paper);
    }));
  };
  add("objects", [](const Measurement& m, const PaperScene& paper) {
    return Cell{grouped(m.objects), grouped(paper.objects), {}};
  });
  add("lights", [](const Measurement& m, const PaperScene&) {
    return Cell{grouped(m.lights), {}, {}};
  });
  const bool is_paper_size = results.plan.effort != Effort::smoke;
  add("primary rays", [&](const Measurement& m, const PaperScene&) {
    return Cell{grouped(m.row.counters.primary),
                is_paper_size ? grouped(paper_primary_rays) : std::string(),
                {}};
  });
  add("reflected rays", [](const Measurement& m, const PaperScene& paper) {
    return Cell{grouped(m.row.counters.reflected), text_of(paper.reflected), {}};
  });
  const auto fewest = [&](const Setting& s, const PaperScene& paper) {
    std::uint64_t rays = UINT64_MAX;
    for (const Contender contender : paper_contenders())
      if (has_shadow_set(contender.method))
        rays = std::min(rays, results.of(s, contender).row.counters.shadow.rays);
    return Cell{grouped(rays), grouped(paper.shadow_rays_best), {}};
  };
  for (const Variant& variant : variants()) {
    if (is_of_embree(variant)) continue;  // traces what our packets trace
    if (variant.is_beyond && !table.rows.back().is_beyond)
      table.rows.push_back(scene_row(results, "shadow rays, fewest of (c) to (e)", fewest));
    table.rows.push_back(scene_row(
        results, "shadow rays, " + variant.label, [&](const Setting& s, const PaperScene& paper) {
          Cell cell{grouped(results.of(s, variant.method).row.counters.shadow.rays), {}, {}};
          if (variant.label.starts_with("(a)")) cell.paper = text_of(paper.shadow_rays_hard);
          if (variant.label.starts_with("(b)")) cell.paper = grouped(paper.shadow_rays_plain);
          return cell;
        }));
    table.rows.back().is_beyond = variant.is_beyond;
  }
  return table;
}

Table tests_per_ray(const Results& results) {
  Table table{"table2b",
              "Table 2b: intersection tests a ray",
              "I_geom: primitives tested a ray in the geometry set, over primary, reflected and "
              "traced shadow "
              "rays; tests for rays that a recent occluder decided count, too. It rises from (b) "
              "to (d) since "
              "the rays that remain are those near occluders. I_shadow: "
              "grown occluders tested a ray in the shadow set; of shaft, records gathered a query. "
              "Hierarchies differ, so these compare among our rows alone.",
              "",
              scene_titles(results.plan),
              {}};
  const auto add = [&](const Variant& variant, const char* name, auto number) {
    table.rows.push_back(scene_row(results, fmt::format("{}, {}", name, variant.label),
                                   [&](const Setting& s, const PaperScene&) {
                                     const RenderCounters& n =
                                         results.of(s, variant.method).row.counters;
                                     return Cell{fmt::format("{:.2f}", number(n)), {}, {}};
                                   }));
    table.rows.back().is_beyond = variant.is_beyond;
  };
  for (const bool is_beyond : {false, true})
    for (const Variant& variant : variants()) {
      if (variant.is_beyond != is_beyond || is_of_embree(variant)) continue;
      add(variant, "I_geom", tests_a_ray);
      const Setting any = table_setting(results.plan, results.plan.scenes[balls4]);
      if (results.of(any, variant.method).row.counters.shadow.set_rays > 0)
        add(variant, "I_shadow", [](const RenderCounters& n) { return set_tests_a_ray(n.shadow); });
    }
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
  for (const Variant& variant : variants()) {
    const bool is_twice = variant.is_beyond &&
                          variant.method != name_of(Contender{Method::shaft}) &&
                          variant.method != embree;
    if (is_twice) continue;  // as with single rays, or Embree's other row
    table.rows.push_back(
        scene_row(results, variant.label, [&](const Setting& s, const PaperScene&) {
          const BenchRow& row = results.of(s, variant.method).row;
          const auto bytes = static_cast<double>(row.geometry_bytes + row.shadow_bytes);
          const auto geometry = static_cast<double>(results.of(s, plain).row.geometry_bytes);
          return Cell{fmt::format("{:.2f}", bytes / geometry),
                      variant.label.starts_with("(e)") ? fmt::format("≤ {}", paper_most_memory)
                                                       : std::string(),
                      bytes < 1e5 ? rounded(bytes / 1e3) + " kB" : rounded(bytes / 1e6) + " MB"};
        }));
    table.rows.back().is_beyond = variant.is_beyond;
  }
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
  for (const Variant& variant : variants()) {
    const bool is_said = variant.method == embree_hard || variant.label.ends_with(", packets");
    if (is_said) continue;  // as the row of the same method
    table.rows.push_back(
        scene_row(results, variant.label, [&](const Setting& s, const PaperScene&) {
          return Cell{rounded(1000 * results.of(s, variant.method).row.seconds_build), {}, {}};
        }));
    table.rows.back().is_beyond = variant.is_beyond;
  }
  return table;
}

Table light_sizes(const Results& results) {
  Table table{"table4",
              "Table 4: light sizes",
              "Balls3: time over that of (b), for lights as large as each of the "
              "scene's four sizes of balls.",
              "variant",
              {},
              {}};
  for (const PaperLight& light : paper_lights)
    table.columns.push_back(fmt::format("r = {}", light.radius));
  const auto add = [&](const std::string& label, bool is_beyond, auto measured) {
    Row row{label, {}, is_beyond};
    for (std::size_t i = 0; i < paper_lights.size(); ++i)
      row.cells.push_back(relative_time(results, table4_setting(results.plan, i),
                                        measured(table4_setting(results.plan, i))));
    table.rows.push_back(std::move(row));
  };
  for (const Variant& variant : variants()) {
    if (variant.is_beyond && !table.rows.back().is_beyond) {
      add("best of (c) to (e)", false, [&](const Setting& s) { return best_proof(results, s); });
      for (std::size_t i = 0; i < paper_lights.size(); ++i)
        if (paper_lights[i].speedup)
          table.rows.back().cells[i].paper = rounded(1 / *paper_lights[i].speedup);
    }
    add(variant.label, variant.is_beyond,
        [&](const Setting& s) { return results.of(s, variant.method); });
  }
  return table;
}

}  // namespace penumbra::reproduce
