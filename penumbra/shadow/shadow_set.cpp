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

/// How far boxes within `occluder` reach beyond themselves when they are grown as it is. Float
/// loses an ulp of the coordinates here, and another one where the growth is added.
Growth growth_of(const Box& occluder, const Box& grown) {
  const double loss = 0x1p-22 * double(std::max(max_abs(grown.lo), max_abs(grown.hi)));
  const Vec3d pad{loss, loss, loss};
  return {Vec3f(Vec3d(occluder.lo) - Vec3d(grown.lo) + pad),
          Vec3f(Vec3d(grown.hi) - Vec3d(occluder.hi) + pad)};
}

Box box_of(const RecordTable& records, std::uint32_t caster) {
  const std::size_t own = records.own().size();
  return caster < own ? bounds(records.own()[caster]) : records.placements()[caster - own].box;
}

}  // namespace

ShadowSet build_shadow_set(const RecordTable& records, std::span<const LightHull> lights,
                           Offsets offsets, const Box& receivers) {
  const auto own = static_cast<std::uint32_t>(records.own().size());
  const auto placements = static_cast<std::uint32_t>(records.placements().size());
  std::vector<GrownOccluder> grown;
  for (std::uint32_t i = 0; i < own; ++i)
    if (records.own()[i].casts_shadow) grown.push_back({i, 1});
  for (std::uint32_t i = 0; i < placements; ++i) grown.push_back({own + i, 1});
  ShadowSet set;
  set.growth.resize(placements);
  std::vector<Box> boxes(grown.size());
  tbb::parallel_for(std::size_t{0}, grown.size(), [&](std::size_t i) {
    const Box box = box_of(records, grown[i].caster);
    grown[i].t = largest_t(box, lights, offsets, receivers);
    for (const LightHull& light : lights)
      boxes[i].add(offset_bounds(box, light, grown[i].t, receivers));
    if (grown[i].caster >= own && !lights.empty())
      set.growth[grown[i].caster - own] = growth_of(box, boxes[i]);
  });
  BoxTree tree = build_box_tree(boxes);
  set.nodes = std::move(tree.nodes);
  set.occluders.reserve(grown.size());
  for (const std::uint32_t i : tree.order) set.occluders.push_back(grown[i]);
  return set;
}

std::uint64_t visit_occluders(const ShadowSet& set, const RecordTable& records,
                              const LightHull& light, Vec3f p, VisitOccluder visit, void* context) {
  std::uint64_t tests = 0;
  // To the centre and, for what float loses of it, a little beyond.
  const Ray ray{p, Vec3f(light.center(p) - Vec3d(p)), 0, 1.001f};
  const auto is_enough = [&](const Record& record, std::uint32_t index, float t) {
    ++tests;
    return visit(context, index, !surely_misses_offset(record, light, p, t)) == Visit::stop;
  };
  const auto visit_placed = [&](std::uint32_t placement, float t) {
    const auto visit_run = [&](std::span<const Record> run, std::uint32_t first) {
      for (std::uint32_t i = 0; i < run.size(); ++i)
        if (run[i].casts_shadow && is_enough(run[i], first + i, t)) return true;
      return false;
    };
    return walk(*records.tree(), records.placements()[placement], set.growth[placement], ray,
                visit_run);
  };
  const auto own = static_cast<std::uint32_t>(records.own().size());
  walk(set.nodes, ray, [&](std::uint32_t first, std::uint32_t count) {
    for (std::uint32_t i = first; i < first + count; ++i) {
      const auto [caster, t] = set.occluders[i];
      if (caster < own ? is_enough(records.own()[caster], caster, t)
                       : visit_placed(caster - own, t))
        return true;
    }
    return false;
  });
  return tests;
}

}  // namespace penumbra
