// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/exposure.h"

#include <algorithm>
#include <cmath>

namespace penumbra {

void balance_lights(Scene& scene) {
  const Box box = object_bounds(scene.shapes);
  if (scene.lights.empty() || box.is_empty()) return;
  const Vec3f middle = box.center();
  const double nearest = std::max(0.5 * length(Vec3d(box.size())), 1e-30);
  Vec3d irradiance;
  for (const Light& light : scene.lights) {
    double factor = 1;
    if (light.falloff == Falloff::inverse_square) {
      const double distance = std::max(length(Vec3d(towards_center(light.shape, middle))), nearest);
      factor = 1 / (distance * distance);
    }
    irradiance += Vec3d(light.intensity) * factor;
  }
  const double scale = 1 / max_abs(irradiance);
  if (!std::isfinite(scale) || !(scale > 0)) return;
  for (Light& light : scene.lights) light.intensity = Color(Vec3d(light.intensity) * scale);
}

}  // namespace penumbra
