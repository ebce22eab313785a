// SPDX-License-Identifier: MIT
// The judge: every record against every ray, one at a time, on the compiler's baseline instruction
// set.
#include <algorithm>

#include "penumbra/kernel/kernel.h"
#include "penumbra/kernel/search-inl.h"
#include "penumbra/kernel/traverse.h"

namespace penumbra {

namespace target = HWY_NAMESPACE;
namespace hn = hwy::HWY_NAMESPACE;

namespace {

constexpr hn::CappedTag<float, 1> one;

target::RayLanes<hn::CappedTag<float, 1>> lanes_of(Vec3f direction) {
  return target::make_ray_lanes(one, hn::Set(one, direction.x), hn::Set(one, direction.y),
                                hn::Set(one, direction.z));
}

/// Until f(record, index) says that it is enough.
template <class F>
bool each_record(const RecordTable& records, F&& f) {
  const auto each_of = [&](const RecordRun& run) {
    const auto end = run.first + static_cast<std::uint32_t>(run.stored.size());
    Record room;
    for (std::uint32_t i = run.first; i < end; ++i)
      if (f(run.get(i, room), i)) return true;
    return false;
  };
  if (each_of({records.own(), nullptr, 0})) return true;
  const auto placements = records.placements();
  return std::any_of(placements.begin(), placements.end(), [&](const Placement& placement) {
    return each_of(records.run_of(placement.first));
  });
}

}  // namespace

NearestRecord nearest_brute(const RecordTable& records, const Ray& ray) {
  const auto lanes = lanes_of(ray.direction);
  target::Search search{{}, ray.t_min, ray.t_max};
  each_record(records, [&](const Record& record, std::uint32_t index) {
    target::search_record(one, record, index, ray.origin, lanes, search);
    return false;
  });
  search.nearest.tests = static_cast<std::uint32_t>(records.size());
  return search.nearest;
}

OccludedReport occluded_brute(const RecordTable& records, const LightSamples& rays,
                              std::span<const std::uint32_t> active,
                              std::span<std::uint32_t> blocked) {
  OccludedReport report;
  const auto always = hn::FirstN(one, 1);
  std::fill(blocked.begin(), blocked.end(), 0u);
  for (std::uint32_t i = 0; i < rays.count; ++i) {
    const std::uint32_t bit = 1u << i % 32;
    if (!(active[i / 32] & bit)) continue;
    const auto lanes = lanes_of({rays.x[i], rays.y[i], rays.z[i]});
    const bool is_blocked = each_record(records, [&](const Record& record, std::uint32_t index) {
      if (!record.casts_shadow) return false;
      ++report.tests;
      if (hn::AllFalse(one, target::meets(one, record, rays.origin, lanes, hn::Set(one, rays.t_max),
                                          always)))
        return false;
      report.blocker = index;
      return true;
    });
    if (is_blocked) blocked[i / 32] |= bit;
  }
  return report;
}

}  // namespace penumbra
