// SPDX-License-Identifier: MIT
// Lights whose units are those of the real world, brought to what a picture shows.
#pragma once

#include <vector>

#include "penumbra/scene/scene.h"

namespace penumbra {

/// Irradiance (as `irradiance` and `intensity` count it: 1 shows white as white) at some points of
/// the surfaces that do not glow, of the side that the camera sees, if there is one, else of the
/// brighter one; of the points within the camera's view where these are enough. Nothing is in the
/// way. The brightest of red, green and blue; rising; without points that no light reaches. At most
/// some thousand points, fewer where there are hundreds of lights. Indices need not be valid.
std::vector<double> irradiances(const Scene& scene);

/// Files give candela and lux (or watts), from a candle to the sun, and leave exposure to the
/// viewer. Scales all lights by one factor, so that one in ten of those points shows more than
/// white. Returns the factor; 1, and nothing is done, where lights reach no surface.
double balance_lights(Scene& scene);

}  // namespace penumbra
