// SPDX-License-Identifier: MIT
// The judge's rays: samples of a light, and what lies farthest out on it.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <vector>

#include "penumbra/geometry/light_sampling.h"
#include "penumbra/kernel/traverse.h"
#include "tests/kernel/nasty_shapes.h"

namespace penumbra {

/// From p to the light's farthest point along `across`, a unit vector across the way to its centre:
/// to its edge as p sees it.
inline Vec3d extreme_way(const LightShape& light, Vec3f p, const Frame<double>& frame,
                         Vec3d across) {
  if (const auto* sun = std::get_if<SunLight>(&light))
    return frame.n * std::cos(double(sun->half_angle_rad)) +
           across * std::sin(double(sun->half_angle_rad));
  const auto* ball = std::get_if<BallLight>(&light);
  const double distance = length(Vec3d(towards_center(light, p)));
  const double sine = ball ? std::min(1.0, ball->radius / distance) : 0;
  return *support(light, across * std::sqrt(1 - sine * sine) - frame.n * sine) - Vec3d(p);
}

/// Adds rays to the light's edge, to its axes and diagonals often.
inline void add_extreme_rays(const LightShape& light, Vec3f p, std::uint32_t count,
                             nasty::Random& random, LightSamples& rays) {
  const std::uint32_t before = rays.count;
  rays.resize(before + count);
  const Frame<double> frame = frame_around(normalize(Vec3d(towards_center(light, p))));
  for (std::uint32_t i = before; i < rays.x.size(); ++i) {
    const double angle =
        random.one_in(2) ? random.below(8) * std::numbers::pi / 4 : random.uniform(0, 6.2831853f);
    const Vec3f way(
        extreme_way(light, p, frame, frame.u * std::cos(angle) + frame.v * std::sin(angle)));
    rays.x[i] = way.x, rays.y[i] = way.y, rays.z[i] = way.z;
  }
}

/// Samples by the pattern, and as many as `extremes` to the edge.
inline LightSamples judging_rays(const LightShape& light, Vec3f p, const SamplePattern& pattern,
                                 std::uint32_t extremes, nasty::Random& random) {
  LightSamples rays;
  sample_light(light, p, pattern, random.below(1u << 30), rays);
  if (extremes > 0) add_extreme_rays(light, p, extremes, random, rays);
  return rays;
}

/// Which rays the record blocks, as bits.
inline std::vector<std::uint32_t> blocked_rays(const Record& record, const LightSamples& rays) {
  std::vector<std::uint32_t> active((rays.count + 31) / 32, ~0u), blocked(active.size());
  if (rays.count % 32 != 0) active.back() = (1u << rays.count % 32) - 1;
  const std::uint32_t only = 0;
  occluded_among({&record, 1}, {&only, 1}, rays, active, blocked);
  return blocked;
}

inline std::uint32_t free_rays(const Record& record, const LightSamples& rays) {
  std::uint32_t free = rays.count;
  for (const std::uint32_t word : blocked_rays(record, rays))
    free -= static_cast<std::uint32_t>(std::popcount(word));
  return free;
}

}  // namespace penumbra
