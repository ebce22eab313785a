// SPDX-License-Identifier: MIT
#include "bench_report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "machine.h"

namespace penumbra {
namespace {

using Json = nlohmann::ordered_json;

constexpr double suspicious_share = 1e-3;  // of samples that Embree and we decide differently

double share(std::uint64_t part, const ShadowCounters& n) {
  const std::uint64_t all = n.lit + n.umbra + n.penumbra;
  return all == 0 ? 0 : static_cast<double>(part) / static_cast<double>(all);
}

Json machine_json() {
  const Machine machine = this_machine();
  return {{"cpu", machine.cpu},
          {"cores", machine.cores},
          {"instruction_set", machine.instruction_set},
          {"embree", machine.embree},
          {"penumbra", machine.version},
          {"compiler", machine.compiler},
          {"flags", machine.flags}};
}

Json radius_json(const BenchCell& cell) {
  return cell.light_radius ? Json(*cell.light_radius) : Json(nullptr);
}

Json row_json(const BenchCell& cell, const BenchRow& row) {
  const ShadowCounters& n = row.counters.shadow;
  return {{"scene", cell.scene},
          {"method", row.method},
          {"shadow_samples", cell.shadow_samples},
          {"light_radius", radius_json(cell)},
          {"threads", cell.threads},
          {"seconds_shadow", row.shadow.median},
          {"seconds_render", row.render.median},
          {"speedup", row.speedup},
          {"speedup_over_stochastic", row.speedup_over_stochastic},
          {"ratio_to_hard", row.ratio_to_hard},
          {"lit", share(n.lit, n)},
          {"umbra", share(n.umbra, n)},
          {"penumbra", share(n.penumbra, n)},
          {"seconds_shadow_quartiles", {row.shadow.low, row.shadow.high}},
          {"seconds_render_quartiles", {row.render.low, row.render.high}},
          {"size", {cell.size.width, cell.size.height}},
          {"seed", cell.seed},
          {"seconds_build", row.seconds_build},
          {"memory_bytes", row.geometry_bytes + row.shadow_bytes}};
}

Json baseline_json(const BenchCell& cell, const BenchRow& row) {
  return {{"scene", cell.scene},
          {"method", row.method},
          {"shadow_samples", cell.shadow_samples},
          {"light_radius", radius_json(cell)},
          {"threads", cell.threads},
          {"variant", row.variant},
          {"different_samples", row.different_samples}};
}

std::string row_text(const BenchRow& row) {
  const ShadowCounters& n = row.counters.shadow;
  return fmt::format(
      "  {:<12}{:>10.4f} s{:>9.2f}{:>9.2f}{:>8.2f}{:>8.1f}{:>8.1f}{:>8.1f}{:>10.3f} s{:>9.3f} "
      "s{:>9.1f}\n",
      row.method, row.shadow.median, row.speedup, row.speedup_over_stochastic, row.ratio_to_hard,
      100 * share(n.lit, n), 100 * share(n.penumbra, n), 100 * share(n.umbra, n), row.render.median,
      row.seconds_build, static_cast<double>(row.geometry_bytes + row.shadow_bytes) / 1e6);
}

}  // namespace

std::string to_text(const BenchCell& cell) {
  std::string text =
      fmt::format("{}{}, d = {}, {} thread{}, {} questions\n", cell.scene,
                  cell.light_radius ? ", light radius " + *cell.light_radius : "",
                  cell.shadow_samples, cell.threads, cell.threads == 1 ? "" : "s", cell.queries);
  text += fmt::format("  {:<12}{:>12}{:>9}{:>9}{:>8}{:>8}{:>8}{:>8}{:>12}{:>11}{:>9}\n", "method",
                      "shadow", "x embree", "x stoch", "/ hard", "lit %", "pen. %", "umbra %",
                      "render", "build", "MB");
  for (const BenchRow& row : cell.rows) text += row_text(row);
  for (const BenchRow& row : cell.rows)
    if (!row.variant.empty())
      text += fmt::format("  {}: {}; {:.2g} of the samples differ from ours{}\n", row.method,
                          row.variant, row.different_samples,
                          row.different_samples > suspicious_share ? " (WARNING: too many)" : "");
  return text;
}

std::string to_json(const std::vector<BenchCell>& cells) {
  Json rows = Json::array(), baselines = Json::array();
  for (const BenchCell& cell : cells)
    for (const BenchRow& row : cell.rows) {
      rows.push_back(row_json(cell, row));
      if (!row.variant.empty()) baselines.push_back(baseline_json(cell, row));
    }
  const Json json = {{"machine", machine_json()}, {"rows", rows}, {"baselines", baselines}};
  return json.dump(2) + "\n";
}

}  // namespace penumbra
