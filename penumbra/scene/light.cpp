// SPDX-License-Identifier: MIT
#include "penumbra/scene/light.h"

#include <algorithm>

namespace penumbra {

float beam_factor(const Light& light, Vec3f p) {
  if (!light.beam) return 1;
  const Beam& beam = *light.beam;
  const std::optional<Vec3f> from = center(light.shape);
  if (!from) return 1;
  const Vec3d way = Vec3d(p) - Vec3d(*from);
  const double distance = length(way);
  if (!(distance > 0)) return 1;
  const double full = beam.cos_full, none = beam.cos_none;
  const double cosine = dot(way, Vec3d(beam.axis)) / distance;
  if (cosine <= none && none > -1) return 0;
  if (cosine >= full || !(full > none)) return 1;
  const double x = std::max(0.0, (cosine - none) / (full - none));
  return static_cast<float>(x * x * (3 - 2 * x));
}

}  // namespace penumbra
