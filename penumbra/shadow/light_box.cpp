// SPDX-License-Identifier: MIT
#include "penumbra/shadow/light_box.h"

#include <algorithm>

namespace penumbra {

double greatest_doubt(const LightHull& light, const Box& receivers) {
  // Convex in p: one of the corners has the greatest.
  double greatest = 0;
  for (int corner = 0; corner < 8; ++corner)
    greatest = std::max(greatest, light.doubt({corner & 1 ? receivers.hi.x : receivers.lo.x,
                                               corner & 2 ? receivers.hi.y : receivers.lo.y,
                                               corner & 4 ? receivers.hi.z : receivers.lo.z}));
  return greatest;
}

double greatest_hit_bound(const Box& occluder, const Box& receivers) {
  // The largest of all kinds is that of triangles, 64 ulp. Spheres, cones and rings take the radius
  // for their extent along every axis.
  Box both = occluder;
  both.add(receivers);
  return 64 * 0x1p-24 * 2 * max_abs(Vec3d(both.hi) - Vec3d(both.lo)) + underflow_bound;
}

}  // namespace penumbra
