// SPDX-License-Identifier: MIT
#include "penumbra/shadow/t_max.h"

#include <algorithm>
#include <array>
#include <limits>

#include "penumbra/shadow/light_box.h"

namespace penumbra {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// An occluder point q blocks p = q + v (q - l) for a finite light, p = q - v (l - p) for a sun,
/// whose l - p do not depend on p: then v is s itself.
struct Blocking {
  const LightHull& light;
  ExtentBox occluder;  // with all points where it may be hit
  double doubt;
  Vec3d center;  // of the l, for suns of the l - p

  /// Extents of the l (suns: of the l - p), samples' errors included.
  double least_light(Vec3d a) const {
    return dot(a, center + light.spread(-a)) - doubt * length(a);
  }
  double most_light(Vec3d a) const { return -least_light(-a); }

  /// The greatest v of receivers in the box, as far as one axis tells (our form of Eq. 6);
  /// negative where there are none in the shadow. In doubt infinite.
  double bound_along(Vec3d a, const ExtentBox& receivers) const {
    const double most = occluder.most(a), way = most - receivers.least(a);
    const double fall = least_light(a) - (light.is_sun() ? 0 : most);
    return fall > 0 ? way / fall : infinity;
  }

  /// What of the receivers lies in the shadow up to v.
  ExtentBox clip(const ExtentBox& receivers, double v) const {
    ExtentBox clipped = receivers;
    const auto shift = [v](double by) { return by > 0 ? by * v : 0; };  // inf * 0 would be NaN
    for (int axis = 0; axis < 3; ++axis) {
      Vec3d a;
      a[axis] = 1;
      const double from_lo = light.is_sun() ? 0 : occluder.lo[axis],
                   from_hi = light.is_sun() ? 0 : occluder.hi[axis];
      clipped.lo[axis] =
          std::max(receivers.lo[axis], occluder.lo[axis] - shift(most_light(a) - from_lo));
      clipped.hi[axis] =
          std::min(receivers.hi[axis], occluder.hi[axis] + shift(from_hi - least_light(a)));
    }
    return clipped;
  }
};

}  // namespace

double t_max(const Box& occluder, const LightHull& light, const Box& receivers) {
  if (receivers.is_empty() || occluder.is_empty()) return 1;
  const double pad = greatest_hit_bound(occluder, receivers);
  const Vec3d all(pad, pad, pad);
  const Blocking blocking{light,
                          {Vec3d(occluder.lo) - all, Vec3d(occluder.hi) + all},
                          greatest_doubt(light, receivers),
                          light.center({})};
  const Vec3d middle = (Vec3d(occluder.lo) + Vec3d(occluder.hi)) * 0.5;
  const std::array<Vec3d, 7> axes{
      Vec3d{1, 0, 0},
      {-1, 0, 0},
      {0, 1, 0},
      {0, -1, 0},
      {0, 0, 1},
      {0, 0, -1},
      normalize(light.is_sun() ? blocking.center : blocking.center - middle)};
  ExtentBox shadowed{Vec3d(receivers.lo), Vec3d(receivers.hi)};
  double v = infinity;
  constexpr int rounds = 3;  // what one axis clips brings the others nearer
  for (int round = 0; round < rounds; ++round) {
    for (Vec3d a : axes) v = std::min(v, blocking.bound_along(a, shadowed));
    if (v < 0) return 0;
    shadowed = blocking.clip(shadowed, v);
  }
  const double s = light.is_sun() ? v : v / (1 + v);
  return s < 1 ? std::min(1.0, s * (1 + 1e-9)) : 1;  // NaN (infinite / infinite) gives 1
}

}  // namespace penumbra
