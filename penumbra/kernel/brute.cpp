// SPDX-License-Identifier: MIT
// The judge: every record against every ray, one at a time, on the compiler's baseline instruction
// set.
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

}  // namespace

NearestRecord nearest_brute(std::span<const Record> records, const Ray& ray) {
  const auto lanes = lanes_of(ray.direction);
  target::Search search{{}, ray.t_min, ray.t_max};
  for (const Record& record : records)
    target::search_record(one, record, ray.origin, lanes, search);
  search.nearest.tests = static_cast<std::uint32_t>(records.size());
  return search.nearest;
}

OccludedReport occluded_brute(std::span<const Record> records, const LightSamples& rays,
                              std::span<const std::uint32_t> active,
                              std::span<std::uint32_t> blocked) {
  OccludedReport report;
  const auto always = hn::FirstN(one, 1);
  std::fill(blocked.begin(), blocked.end(), 0u);
  for (std::uint32_t i = 0; i < rays.count; ++i) {
    const std::uint32_t bit = 1u << i % 32;
    if (!(active[i / 32] & bit)) continue;
    const auto lanes = lanes_of({rays.x[i], rays.y[i], rays.z[i]});
    for (const Record& record : records) {
      if (!record.casts_shadow) continue;
      ++report.tests;
      if (hn::AllFalse(one, target::meets(one, record, rays.origin, lanes, hn::Set(one, rays.t_max),
                                          always)))
        continue;
      blocked[i / 32] |= bit;
      report.blocker = static_cast<std::uint32_t>(&record - records.data());
      break;
    }
  }
  return report;
}

}  // namespace penumbra
