// SPDX-License-Identifier: MIT
// Where the samples of a light fall, and how far they are from it.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "penumbra/geometry/light_sampling.h"

namespace penumbra {

/// How many samples minus p fall into each bin: one sample a key, so that counts are independent,
/// every sample of the pattern in turn.
inline std::vector<double> sample_counts(const LightShape& light, Vec3f p, std::uint32_t d,
                                         std::size_t bins, std::uint64_t keys,
                                         const std::function<std::size_t(Vec3d)>& bin_of) {
  const SamplePattern pattern(d);
  LightSamples samples;
  std::vector<double> counts(bins);
  for (std::uint64_t key = 0; key < keys; ++key) {
    sample_light(light, p, pattern, key, samples);
    const std::size_t i = key % d;
    ++counts[std::min(bin_of({samples.x[i], samples.y[i], samples.z[i]}), bins - 1)];
  }
  return counts;
}

inline double distance_to_segment(Vec3d p, Vec3d a, Vec3d b) {
  const double s = std::clamp(dot(p - a, b - a) / length_squared(b - a), 0.0, 1.0);
  return length(p - a - (b - a) * s);
}

inline double distance_to_triangle(Vec3d p, const std::array<Vec3d, 3>& t) {
  const Vec3d n = normalize(cross(t[1] - t[0], t[2] - t[0]));
  double nearest = INFINITY;
  bool is_over_it = true;
  for (int i = 0; i < 3; ++i) {
    const Vec3d a = t[i], b = t[(i + 1) % 3];
    if (dot(cross(n, b - a), p - a) < 0) is_over_it = false;
    nearest = std::min(nearest, distance_to_segment(p, a, b));
  }
  return is_over_it ? std::abs(dot(p - t[0], n)) : nearest;
}

}  // namespace penumbra
