// SPDX-License-Identifier: MIT
#include "bake_report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "options.h"
#include "output_files.h"
#include "penumbra/version.h"
#include "resources.h"

namespace penumbra {
namespace {

double percent(std::uint64_t part, std::uint64_t whole) {
  return whole == 0 ? 0 : 100 * double(part) / double(whole);
}

}  // namespace

std::vector<std::string> warnings_of(const BakeObjects& objects) {
  std::vector<std::string> lines;
  if (objects.without_uvs > 0)
    lines.push_back(
        fmt::format("meshes without {}texture coordinates: {}; they cast shadows and are not baked",
                    objects.set == UvSet::second ? "a second set of " : "", objects.without_uvs));
  if (objects.instanced > 0)
    lines.push_back(fmt::format(
        "meshes that stand in several places, which would share their texels: {}; they cast "
        "shadows and are not baked, make them objects of their own (Blender: Make Single User)",
        objects.instanced));
  return lines;
}

std::vector<std::string> warnings_of(const BakeReport& r, bool is_atlas) {
  std::vector<std::string> lines;
  const auto add = [&](std::uint64_t count, const char* what) {
    if (count > 0) lines.push_back(fmt::format("{} of {} {}", count, r.triangles, what));
  };
  add(r.faults.outside,
      "triangles reach out of the texture (coordinates beyond [0, 1]) and are cut off there; pack "
      "the charts into it");
  add(r.faults.flat, "triangles have no area in the texture and are not baked");
  add(r.faults.not_finite,
      "triangles have coordinates that are no numbers, or beyond 1000, and are not baked");
  if (r.counters.overlapping > 0)
    lines.push_back(fmt::format(
        "{} texels lie in two triangles or more, and got a mean of them; {}",
        r.counters.overlapping,
        is_atlas ? "try --per-mesh (a texture for each mesh), --mesh, or unwrap them together"
                 : "unwrap it without overlaps (Blender: Lightmap Pack; xatlas)"));
  return lines;
}

std::string stats_json(const BakeReport& r) {
  const BakeCounters& n = r.counters;
  const nlohmann::ordered_json json = {
      {"version", PENUMBRA_VERSION},
      {"scene", r.scene},
      {"method", name_of(r.method)},
      {"shadow_samples", r.options.shadow_samples},
      {"texel_samples", r.options.texel_samples},
      {"size", {r.options.width, r.options.height}},
      {"padding", r.options.padding},
      {"weight", r.options.value == BakeValue::fraction ? "none" : "cosine"},
      {"seed", r.options.seed},
      {"threads", r.threads},
      {"lights", r.lights},
      {"files", r.files},
      {"uv_set", r.set == UvSet::first ? 1 : 2},
      {"seconds", {{"load", r.load_seconds}, {"build", r.build_seconds}, {"bake", r.bake_seconds}}},
      {"texels", {{"covered", n.covered}, {"padded", n.padded}, {"overlapping", n.overlapping}}},
      {"texel_classes", {{"lit", n.lit}, {"penumbra", n.penumbra}, {"umbra", n.umbra}}},
      {"samples", {{"proven", n.proven_samples}, {"asked", n.asked_samples}}},
      {"shadow_rays", n.shadow.rays},
      {"triangles",
       {{"all", r.triangles},
        {"outside", r.faults.outside},
        {"flat", r.faults.flat},
        {"not_finite", r.faults.not_finite}}},
      {"peak_rss_bytes", peak_rss_bytes()}};
  return json.dump(2) + "\n";
}

void add_metadata(const BakeReport& r, Image& image) {
  image.metadata = {{"Software", "penumbra " PENUMBRA_VERSION},
                    {"Command", command_text(r.arguments)},
                    {"Scene", without_folders(r.scene)},
                    {"Method", std::string(name_of(r.method))},
                    {"ShadowSamples", std::to_string(r.options.shadow_samples)},
                    {"TexelSamples", std::to_string(r.options.texel_samples)},
                    {"Seed", std::to_string(r.options.seed)}};
}

std::string summary(const BakeReport& r) {
  const BakeCounters& n = r.counters;
  const std::uint64_t classes = n.lit + n.penumbra + n.umbra;
  const std::string more =
      r.files.size() > 1 ? fmt::format(" and {} more", r.files.size() - 1) : std::string();
  return fmt::format(
      "wrote {}{}: {}x{}, {} light{}, {} texels; lit {:.0f} %, penumbra {:.0f} %, umbra {:.0f} %; "
      "{:.1f} s",
      r.files.front(), more, r.options.width, r.options.height, r.lights, r.lights == 1 ? "" : "s",
      n.covered, percent(n.lit, classes), percent(n.penumbra, classes), percent(n.umbra, classes),
      r.bake_seconds);
}

}  // namespace penumbra
