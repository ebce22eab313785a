// SPDX-License-Identifier: MIT
// Private to the layer: head and shoulders on a plinth as an implicit surface.
#pragma once

#include "penumbra/geometry/vec.h"

namespace penumbra::detail {

/// Below 0 inside. Nearly a distance: around the surface it changes by at most
/// `bust_steepness` a unit. z is up, the
/// face looks to -y, the chin is at height 0 and the crown at 2.3; the plinth stands on
/// `bust_bottom`.
double bust_field(Vec3d p);

constexpr double bust_steepness = 1.8;
constexpr double bust_bottom = -3.05;

}  // namespace penumbra::detail
