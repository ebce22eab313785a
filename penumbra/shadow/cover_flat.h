// SPDX-License-Identifier: MIT
// Flat shapes that hide a whole light, which lies beyond their plane.
#pragma once

#include "penumbra/shadow/sight.h"

namespace penumbra {

/// `surely_covers` for triangles: the light is beyond the plane, and inside the three planes
/// through p and an edge. Exact but for the margins, for every light.
bool triangle_covers(const Record& record, const Sight& sight);

/// `surely_covers` for rings: every ray crosses the plane within the outer circle, and misses the
/// hole. Exact but for the margins, and for ball lights but for 2 % of their radius.
bool ring_covers(const Record& record, const Sight& sight);

}  // namespace penumbra
