// SPDX-License-Identifier: MIT
// Solids that hide a whole light: balls, cylinders, cones.
#pragma once

#include "penumbra/shadow/sight.h"

namespace penumbra {

/// True only if every ray from p to the light's samples passes deeper than `sight.margin` through
/// the ball, before the sample.
bool ball_hides(Vec3d center, double radius, const Sight& sight);

/// `surely_covers` for spheres.
bool sphere_covers(const Record& record, const Sight& sight);

/// `surely_covers` for cones and cylinders no flatter than 1 : 4; other ones never cover. Capped:
/// the solid. Open: the solid's surface is crossed twice, and each of the missing caps takes at
/// most one crossing: one that the shaft misses is enough for p outside, else both.
bool cone_covers(const Record& record, const Sight& sight);

}  // namespace penumbra
