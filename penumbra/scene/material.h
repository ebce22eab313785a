// SPDX-License-Identifier: MIT
// How a surface reflects: Lambert and Phong for light, mirror and refraction for rays (Whitted
// 1980).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "penumbra/geometry/vec.h"

namespace penumbra {

using Color = Vec3f;  ///< linear RGB, Rec. 709 primaries

/// By a factor in double, rounded once.
inline Color scaled(Color c, double factor) { return Color(Vec3d(c) * factor); }

/// Of a surface.
struct Material {
  std::string name;
  Color diffuse{0.8f, 0.8f, 0.8f};  ///< Lambert reflectance
  Color highlight{};                ///< Phong highlight coefficient
  float shininess = 0;              ///< Phong exponent; no highlight where `highlight` is 0
  Color mirror{};                   ///< coefficient of the reflected ray
  Color transmission{};             ///< coefficient of the refracted ray
  float refraction_index = 1;       ///< of the side the normal points away from
  Color emission{};                 ///< added to the surface's own colour
  bool emits_from_back = true;      ///< false: the front alone (counter-clockwise) shines
  std::int32_t texture = -1;        ///< index of the texture that multiplies `diffuse`, or -1
  bool casts_shadow = true;         ///< false: takes no part in any shadow
};

/// Base colour image, linear RGB, rows from top to bottom; repeats outside [0, 1].
struct Texture {
  std::uint32_t width = 0, height = 0;
  std::vector<Color> pixels;
};

/// Bilinear look-up; white for an empty texture.
Color sample(const Texture& texture, Vec2f uv);

}  // namespace penumbra
