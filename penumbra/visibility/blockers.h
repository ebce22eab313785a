// SPDX-License-Identifier: MIT
// What stands between points and a light, by name.
#pragma once

#include "penumbra/geometry/light_shape.h"
#include "penumbra/visibility/committed.h"
#include "penumbra/visibility/occluders.h"

namespace penumbra {

/// For one receiver.
Blockers blockers_of_point(const Committed& occluders, const Receiver& receiver,
                           const LightShape& light);

/// For all of a box, without horizon.
Blockers blockers_of_box(const Committed& occluders, const Box& box, const LightShape& light);

}  // namespace penumbra
