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
  const bool is_parallel = camera.parallel_height > 0;
  const double half_height = is_parallel ? camera.parallel_height / 2
                                         : std::tan(camera.fov_deg * (std::numbers::pi / 360));
  // Of the whole picture; the window is a part of it.
  const ImageWindow& w = camera.window;
  const double width = w.right - w.left, height = w.bottom - w.top;
  const double whole_aspect = aspect * std::abs(height) / std::abs(width);
  const Vec3d whole_right = right * (half_height * whole_aspect);
  const Vec3d whole_up = cross(right, forward) * half_height;
  const Vec3d shift = whole_right * (w.left + w.right - 1) - whole_up * (w.top + w.bottom - 1);
  if (is_parallel)
    return {camera.from + shift, forward, whole_right * width, whole_up * height, true};
  return {camera.from, forward + shift, whole_right * width, whole_up * height, false};
}

CameraLine line_at(const CameraFrame& frame, double right, double down) {
  const Vec3d from_middle = frame.right * right - frame.up * down;
  if (frame.is_parallel) return {frame.origin + from_middle, frame.forward};
  return {frame.origin, frame.forward + from_middle};
}

}  // namespace penumbra
