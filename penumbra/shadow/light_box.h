// SPDX-License-Identifier: MIT
// Lights and hits seen from a whole box of receiver points.
#pragma once

#include "penumbra/geometry/box.h"
#include "penumbra/shadow/light_hull.h"

namespace penumbra {

/// Not below `light.doubt(p)` for any p in the box.
double greatest_doubt(const LightHull& light, const Box& receivers);

/// Not below `hit_bound` of any shape in the occluder's box for any p in the receivers' box.
double greatest_hit_bound(const Box& occluder, const Box& receivers);

}  // namespace penumbra
