// SPDX-License-Identifier: MIT
#include "penumbra/scene/camera.h"

#include <cmath>
#include <numbers>

namespace penumbra {

CameraFrame frame(const Camera& camera, double aspect) {
  Vec3d forward = normalize(camera.at - camera.from);
  if (forward == Vec3d{}) forward = {0, 1, 0};
  // Looking along `up` leaves the roll open: any right angle will do.
  Vec3d right = cross(forward, normalize(camera.up));
  right = length(right) > 1e-9 ? normalize(right) : frame_around(forward).u;
  const double half_height = std::tan(camera.fov_deg * (std::numbers::pi / 360));
  return {camera.from, forward, right * (half_height * aspect),
          cross(right, forward) * half_height};
}

}  // namespace penumbra
