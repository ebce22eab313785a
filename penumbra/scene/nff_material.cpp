// SPDX-License-Identifier: MIT
#include "penumbra/scene/nff_material.h"

#include <cmath>

#include "penumbra/scene/image.h"

namespace penumbra {

Color nff_color(Color display_rgb) {
  return {linear_from_srgb(display_rgb.x), linear_from_srgb(display_rgb.y),
          linear_from_srgb(display_rgb.z)};
}

float nff_light_intensity(std::size_t count) {
  return count == 0 ? 0.0f : 0.5f / std::sqrt(static_cast<float>(count));
}

Material nff_material(Color display_rgb, float kd, float ks, float shine, float t, float ior) {
  constexpr float no_highlight = 100000;
  Material material;
  material.diffuse = nff_color(display_rgb) * kd;
  material.mirror = {ks, ks, ks};
  material.transmission = {t, t, t};
  if (shine < no_highlight) {
    material.highlight = {ks, ks, ks};
    material.shininess = shine;
  }
  if (t > 0) material.refraction_index = ior;
  return material;
}

}  // namespace penumbra
