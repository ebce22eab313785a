// SPDX-License-Identifier: MIT
// A light: a convex set from `geometry` and what it emits.
#pragma once

#include <optional>

#include "penumbra/geometry/light_shape.h"
#include "penumbra/scene/material.h"

namespace penumbra {

/// How brightness goes with distance.
/// none: as NFF and suns have it, `intensity` is the irradiance of a surface that faces the centre;
/// inverse_square: `intensity` is radiant intensity, the irradiance is intensity / distance².
/// Either way a light's power does not depend on its size, so that exposure stays.
enum class Falloff { none, inverse_square };

/// Where a light shines: a factor of its unshadowed light by the angle at its centre between
/// `axis` and the way to p. 1 inside `cos_full`, 0 outside `cos_none`, smooth between (3x² - 2x³ of
/// the cosine). Flat lights that shine from their front alone have their normal as the axis and
/// both cosines 0. Visibility is of the whole light, and not asked where the factor is 0.
struct Beam {
  Vec3f axis{0, 0, 1};  ///< unit
  float cos_full = -1, cos_none = -1;
};

/// A light of a scene.
struct Light {
  LightShape shape;
  Color intensity{1, 1, 1};
  Falloff falloff = Falloff::none;
  std::optional<Beam> beam{};  ///< none: it shines all around; not for suns
};

/// Share of a light's unshadowed light that its beam sends to p, in [0, 1]; 1 without one, and at
/// the light's centre itself.
float beam_factor(const Light& light, Vec3f p);

}  // namespace penumbra
