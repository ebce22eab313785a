// SPDX-License-Identifier: MIT
// A light: a convex set from `geometry` and what it emits.
#pragma once

#include "penumbra/geometry/light_shape.h"
#include "penumbra/scene/material.h"

namespace penumbra {

/// How brightness goes with distance.
/// none: as NFF and suns have it, `intensity` is the irradiance of a surface that faces the centre;
/// inverse_square: `intensity` is radiant intensity, the irradiance is intensity / distance².
/// Either way a light's power does not depend on its size, so that exposure stays.
enum class Falloff { none, inverse_square };

struct Light {
  LightShape shape;
  Color intensity{1, 1, 1};
  Falloff falloff = Falloff::none;
};

}  // namespace penumbra
