// SPDX-License-Identifier: MIT
// Private to the layer: the makers of the built-in scenes, one file each, and what they share.
#pragma once

#include "penumbra/scene/scene.h"

namespace penumbra::detail {

/// The "sphereflake" of size factor n >= 1.
Scene balls_scene(int n);
/// Pyramid of n layers of six interlocked pentagons each, n >= 1.
Scene rings_scene(int n);
Scene cylinders_scene();
Scene molecule_scene();
Scene bust_scene();

/// A number as NFF files carry it: printed with 6 significant digits and read back.
float as_printed(double value);
Vec3f as_printed(Vec3d p);

/// A floor or wall of two triangles over four corners in a row.
Mesh backdrop_quad(Vec3f a, Vec3f b, Vec3f c, Vec3f d, std::uint32_t surface);

/// A ball light without falloff.
Light ball_light(Vec3f center, float radius, float intensity);

/// A matte material of this linear colour.
Material matte(std::string name, Color diffuse);

}  // namespace penumbra::detail
