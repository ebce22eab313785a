// SPDX-License-Identifier: MIT
#include "penumbra/shadow/shadow_set.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "penumbra/kernel/kernel.h"
#include "penumbra/shadow/offset.h"
#include "penumbra/shadow/t_max.h"

namespace penumbra {
namespace {

float largest_t(const Box& occluder, std::span<const LightHull> lights, Offsets offsets,
                const Box& receivers) {
  if (offsets == Offsets::full) return 1;
  double t = 0;
  for (const LightHull& light : lights) t = std::max(t, t_max(occluder, light, receivers));
  return std::min(1.0f, round_up(t));
}

}  // namespace

ShadowSet build_shadow_set(std::span<const Record> records, std::span<const LightHull> lights,
                           Offsets offsets, const Box& receivers) {
  std::vector<GrownOccluder> grown;
  for (std::uint32_t i = 0; i < records.size(); ++i)
    if (records[i].casts_shadow) grown.push_back({i, 1});
  std::vector<Box> boxes(grown.size());
  tbb::parallel_for(std::size_t{0}, grown.size(), [&](std::size_t i) {
    const Box box = bounds(records[grown[i].record]);
    grown[i].t = largest_t(box, lights, offsets, receivers);
    for (const LightHull& light : lights)
      boxes[i].add(offset_bounds(box, light, grown[i].t, receivers));
  });
  BoxTree tree = build_box_tree(boxes);
  ShadowSet set{std::move(tree.nodes), {}};
  set.occluders.reserve(grown.size());
  for (const std::uint32_t i : tree.order) set.occluders.push_back(grown[i]);
  return set;
}

std::uint64_t visit_occluders(const ShadowSet& set, std::span<const Record> records,
                              const LightHull& light, Vec3f p, VisitOccluder visit, void* context) {
  std::uint64_t tests = 0;
  // To the centre and, for what float loses of it, a little beyond.
  const Ray ray{p, Vec3f(light.center(p) - Vec3d(p)), 0, 1.001f};
  walk(set.nodes, ray, [&](std::uint32_t first, std::uint32_t count) {
    for (std::uint32_t i = first; i < first + count; ++i) {
      const GrownOccluder& occluder = set.occluders[i];
      ++tests;
      const bool is_candidate =
          !surely_misses_offset(records[occluder.record], light, p, occluder.t);
      if (visit(context, occluder.record, is_candidate) == Visit::stop) return true;
    }
    return false;
  });
  return tests;
}

}  // namespace penumbra
