// SPDX-License-Identifier: MIT
// A camera: pinhole or parallel rays. Right = forward x up: x grows to the right, y downwards in
// the picture.
#pragma once

#include <cstdint>

#include "penumbra/geometry/vec.h"

namespace penumbra {

/// The part of the whole picture that is drawn, in image positions: (0, 0) the upper left corner of
/// the whole, (1, 1) the lower right one. May reach beyond it (shifted lenses).
struct ImageWindow {
  double left = 0, top = 0, right = 1, bottom = 1;
};

struct Camera {
  Vec3d from{0, -4, 1}, at{}, up{0, 0, 1};
  double fov_deg =
      45;  ///< full vertical field of view, from the top edge of the picture to the bottom one
  /// Height of the whole picture in scene units where all rays are parallel; 0: perspective.
  double parallel_height = 0;
  ImageWindow window;
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
