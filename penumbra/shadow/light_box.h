// SPDX-License-Identifier: MIT
// Lights and hits seen from a whole box of receiver points.
#pragma once

#include "penumbra/geometry/box.h"
#include "penumbra/shadow/light_hull.h"

namespace penumbra {

/// A box in double.
struct ExtentBox {
  Vec3d lo, hi;
  /// The largest a . x.
  double most(Vec3d a) const {
    const Vec3d at_lo(a.x * lo.x, a.y * lo.y, a.z * lo.z),
        at_hi(a.x * hi.x, a.y * hi.y, a.z * hi.z);
    const Vec3d best = max(at_lo, at_hi);
    return best.x + best.y + best.z;
  }
  double least(Vec3d a) const { return -most(-a); }
};

/// Box of L - c.
ExtentBox spread_box(const LightHull& light);

/// Not below `light.doubt(p)` for any p in the box.
double greatest_doubt(const LightHull& light, const Box& receivers);

/// Not below `hit_bound` of any shape in the occluder's box for any p in the receivers' box.
double greatest_hit_bound(const Box& occluder, const Box& receivers);

}  // namespace penumbra
