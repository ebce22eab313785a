// SPDX-License-Identifier: MIT
#include "penumbra/shadow/visibility.h"

#include <cmath>

namespace penumbra {

void ShadowCounters::add(const ShadowCounters& other) {
  lit += other.lit, penumbra += other.penumbra, umbra += other.umbra;
  rays += other.rays, tests += other.tests;
}

std::uint64_t light_key(std::uint64_t point_key, std::uint32_t light_index) {
  return hash(point_key, light_index);
}

namespace {

/// The one ray of `hard`: to the centre.
void aim_at_center(const LightShape& light, Vec3f p, LightSamples& out) {
  const Vec3f to = towards_center(light, p);
  out.resize(1);
  out.origin = p;
  out.t_max = center(light) ? 1.0f : std::numeric_limits<float>::infinity();
  std::fill(out.x.begin(), out.x.end(), to.x);
  std::fill(out.y.begin(), out.y.end(), to.y);
  std::fill(out.z.begin(), out.z.end(), to.z);
}

/// Cosine of each sample, and a bit for each that lies above the horizon. NaN lies below it.
std::uint32_t weigh(const Vec3f normal, VisibilityScratch& scratch) {
  const LightSamples& s = scratch.samples;
  scratch.weight.resize(s.count);
  scratch.active.assign((s.count + 31) / 32, 0);
  scratch.blocked.resize(scratch.active.size());
  std::uint32_t above = 0;
  for (std::uint32_t i = 0; i < s.count; ++i) {
    const float along = normal.x * s.x[i] + normal.y * s.y[i] + normal.z * s.z[i];
    const float square = s.x[i] * s.x[i] + s.y[i] * s.y[i] + s.z[i] * s.z[i];
    scratch.weight[i] = along / std::sqrt(square);
    if (!(along > 0)) continue;
    scratch.active[i / 32] |= 1u << i % 32;
    ++above;
  }
  return above;
}

/// Sums in sample order.
Visibility sum_up(const VisibilityScratch& scratch) {
  double all = 0, free = 0;
  std::uint32_t free_count = 0;
  for (std::uint32_t i = 0; i < scratch.samples.count; ++i) {
    const std::uint32_t bit = 1u << i % 32;
    if (!(scratch.active[i / 32] & bit)) continue;
    all += scratch.weight[i];
    if (scratch.blocked[i / 32] & bit) continue;
    free += scratch.weight[i];
    ++free_count;
  }
  Visibility result;
  result.fraction = static_cast<float>(free_count) / static_cast<float>(scratch.samples.count);
  const double ratio = free / all;
  result.cosine_weighted =
      all > 0 && std::isfinite(ratio) ? static_cast<float>(ratio) : result.fraction;
  return result;
}

bool any(const std::vector<std::uint32_t>& words) {
  return std::any_of(words.begin(), words.end(), [](std::uint32_t word) { return word != 0; });
}

void count(ShadowClass shadow_class, ShadowCounters& counters) {
  switch (shadow_class) {
    case ShadowClass::lit: ++counters.lit; break;
    case ShadowClass::penumbra: ++counters.penumbra; break;
    case ShadowClass::umbra: ++counters.umbra; break;
  }
}

}  // namespace

Visibility visibility(const Kernel& kernel, const LightShape& light, const Receiver& receiver,
                      Method method, std::uint64_t key, VisibilityScratch& scratch,
                      ShadowCounters& counters) {
  const bool is_point = std::holds_alternative<PointLight>(light);
  switch (method) {
    case Method::hard: aim_at_center(light, receiver.position, scratch.samples); break;
    case Method::stochastic:
      sample_light(light, receiver.position, is_point ? scratch.center : scratch.pattern, key,
                   scratch.samples);
      break;
  }
  const std::uint32_t above = weigh(receiver.normal, scratch);
  const bool is_doubtful = !is_finite(receiver.position) || !is_finite(receiver.normal) ||
                           contains(light, receiver.position);
  if (above == 0) return {0, 0, is_doubtful ? ShadowClass::penumbra : ShadowClass::umbra};
  counters.rays += above;
  counters.tests += kernel.occluded(scratch.samples, scratch.active, scratch.blocked);
  Visibility result = sum_up(scratch);
  if (is_doubtful)
    result.shadow_class = ShadowClass::penumbra;
  else if (result.fraction == 0)
    result.shadow_class = ShadowClass::umbra;
  else
    result.shadow_class = any(scratch.blocked) ? ShadowClass::penumbra : ShadowClass::lit;
  count(result.shadow_class, counters);
  return result;
}

}  // namespace penumbra
