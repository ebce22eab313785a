// SPDX-License-Identifier: MIT
// The light that arrives when nothing is in the way, in closed form: what a Lambertian surface
// makes of a whole light.
#pragma once

#include "penumbra/geometry/light_shape.h"
#include "penumbra/geometry/vec.h"

namespace penumbra {

/// Irradiance at p on a surface with unit normal n under the unoccluded light, without falloff: a
/// small or far light straight above gives 1, and so a light's power does not depend on its size.
/// In [0, 1]. With E the integral of max(0, n·ω) over the directions ω of the light:
/// (1) point: max(0, n·ω);
/// (2) ball of half angle s at p, and sun: E / (pi sin² s), which is n·ω of the centre wherever the
///     light is wholly above the horizon; 1 for p inside a ball;
/// (3) parallelogram: E / solid angle, the mean cosine; 0 for p in its plane.
double irradiance(const LightShape& light, Vec3f p, Vec3f n);

/// What to multiply `irradiance` by for a light with inverse-square falloff, whose radiant
/// intensity (of parallelograms along their normal) is 1:
/// point and ball: 1 / distance² to the centre, distance not below the ball's radius, and 0 for p
///   on the point: radiance 1 / (pi R²) times E = pi sin² s · irradiance, with sin s = R /
///   distance;
/// parallelogram: solid angle / area: radiance 1 / area times E = solid angle · irradiance;
/// sun: 1, it has no falloff.
double inverse_square_factor(const LightShape& light, Vec3f p);

}  // namespace penumbra
