// SPDX-License-Identifier: MIT
// A pinhole camera. Right = forward x up: x grows to the right, y downwards in the picture.
#pragma once

#include <cstdint>

#include "penumbra/geometry/vec.h"

namespace penumbra {

struct Camera {
  Vec3d from{0, -4, 1}, at{}, up{0, 0, 1};
  double fov_deg =
      45;  ///< full vertical field of view, from the top edge of the picture to the bottom one
  double near = 0;  ///< rays start this far along the viewing axis (NFF "hither")
  std::uint32_t width = 512,
                height = 512;  ///< the file's own resolution, unless the user gives another
};

/// The ray frame: direction of image position (x, y) in [0, 1]², (0, 0) the upper left corner, is
/// forward + (2x - 1) right - (2y - 1) up, not normalised; its component along the axis is 1.
struct CameraFrame {
  Vec3d origin, forward, right, up;
};

/// For a picture of this aspect (width / height).
CameraFrame frame(const Camera& camera, double aspect);

}  // namespace penumbra
