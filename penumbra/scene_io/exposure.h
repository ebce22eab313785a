// SPDX-License-Identifier: MIT
// Lights whose units are those of the real world, brought to what a picture shows.
#pragma once

#include "penumbra/scene/scene.h"

namespace penumbra {

/// Files give candela and lux (or watts), from a candle to the sun, and leave exposure to the
/// viewer. Scales all lights by one factor, so that together they give a surface at the centre of
/// the objects' box, facing them, an irradiance of 1 (the brightest of red, green and blue). A
/// light inside the box counts as if it were half the box's diagonal away.
void balance_lights(Scene& scene);

}  // namespace penumbra
