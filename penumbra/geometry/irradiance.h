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
/// (3) parallelogram, disk, polygon and mesh: E / solid angle, the mean cosine; 0 for p in the
///     plane of a flat light, 1/2 for p inside a mesh (what it is on its skin);
/// (4) line: the mean of max(0, n·ω) over the angle it subtends, as of a row of points; 0 for p
///     on it.
/// All are exact where the horizon cuts the light, too, but for flat lights and meshes of less than
/// 10⁻⁹ steradians, which count as their centre. Cost: some 0.1 microseconds, 0.5 for disks, 0.1 a
/// triangle of polygons and meshes.
double irradiance(const LightShape& light, Vec3f p, Vec3f n);

/// What to multiply `irradiance` by for a light with inverse-square falloff, whose radiant
/// intensity (of flat lights along their normal, of meshes the mean over all directions) is 1:
/// point and ball: 1 / distance² to the centre, distance not below the ball's radius, and 0 for p
///   on the point: radiance 1 / (pi R²) times E = pi sin² s · irradiance, with sin s = R /
///   distance;
/// parallelogram, disk and polygon: solid angle / area: radiance 1 / area times E = solid angle ·
///   irradiance;
/// mesh: solid angle, not above 2 pi, / (surface / 4), since by Cauchy a convex body's projected
///   area is a quarter of its surface in the mean;
/// line: the mean of 1 / distance² over its points, and 0 for p on it: angle / (length · distance
///   from its axis);
/// sun: 1, it has no falloff.
double inverse_square_factor(const LightShape& light, Vec3f p);

}  // namespace penumbra
