// SPDX-License-Identifier: MIT
#include "penumbra/shadow/light_form.h"

namespace penumbra {

LightForm::LightForm(const LightHull& light)
    : is_sun(light.is_sun()),
      center(Vec3f(light.center({}))),
      center_rest(Vec3f(light.center({}) - Vec3d(center))),
      size(static_cast<float>(light.size() * (1 + 0x1p-22))) {
  if (light.is_disk()) {
    form = Form::disk;
    axis = Vec3f(light.normal());
  } else if (!light.is_ball() && light.corners().size() <= corner.size()) {
    form = Form::corners;
    for (const Vec3d& point : light.corners()) corner[corner_count++] = Vec3f(point);
  }
}

}  // namespace penumbra
