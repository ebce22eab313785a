// SPDX-License-Identifier: MIT
#include "penumbra/shadow/samples.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace penumbra {
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

}  // namespace

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

/// Directions to the light's samples, and which lie above the horizon; returns their number.
std::uint32_t take_samples(const ShadowScene& scene, std::uint32_t light, const Receiver& receiver,
                           std::uint64_t key, VisibilityScratch& scratch) {
  const LightShape& shape = scene.lights[light];
  const SamplePattern& pattern =
      std::holds_alternative<PointLight>(shape) ? scratch.center : scratch.pattern;
  if (scene.method == Method::hard)
    aim_at_center(shape, receiver.position, scratch.samples);
  else
    sample_light(shape, receiver.position, pattern, key, scratch.samples);
  return weigh(receiver.normal, scratch);
}

/// All samples are sure to be above the horizon, in float too, however they will be rounded.
bool is_surely_above(const LightHull& light, const Receiver& receiver) {
  const double distance = length(light.center(receiver.position) - Vec3d(receiver.position));
  const bool is_safe = distance > 1e-15 && distance < 1e15;  // squares stay in float's range
  return is_safe && light.least_height(receiver.position, Vec3d(receiver.normal)) > 0;
}

}  // namespace penumbra
