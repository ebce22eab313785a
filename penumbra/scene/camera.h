// SPDX-License-Identifier: MIT
// A camera: pinhole or parallel rays. Right = forward x up: x grows to the right, y downwards in
// the picture.
#pragma once

#include <cstdint>

#include "penumbra/geometry/vec.h"

namespace penumbra {

/// The part of the whole picture that is drawn, in image positions: (0, 0) the upper left corner of
/// the whole, (1, 1) the lower right one. May reach beyond it (shifted lenses); a left edge beyond
/// the right one, or a top below the bottom, mirrors the picture.
struct ImageWindow {
  double left = 0, top = 0, right = 1, bottom = 1;
};

/// Where a picture is taken from.
struct Camera {
  Vec3d from{0, -4, 1}, at{}, up{0, 0, 1};
  double fov_deg =
      45;  ///< full vertical field of view, from the top edge of the picture to the bottom one
  /// Height of the whole picture in scene units where all rays are parallel; 0: perspective.
  double parallel_height = 0;
  ImageWindow window{};
  double near = 0;  ///< rays start this far along the viewing axis (NFF "hither")
  std::uint32_t width = 512,
                height = 512;  ///< the file's own resolution, unless the user gives another
};

/// The ray frame. At image position (x, y) in [0, 1]² of what is drawn, (0, 0) its upper left
/// corner, let s = (2x - 1) right - (2y - 1) up. Perspective rays start at the origin along
/// forward + s, not normalised; parallel ones at origin + s along forward. Either direction's
/// component along the viewing axis is 1.
struct CameraFrame {
  Vec3d origin, forward, right, up;
  bool is_parallel = false;
};

/// A camera ray, not normalised.
struct CameraLine {
  Vec3d origin, direction;
};

/// For a drawn picture of this aspect (width / height). The whole picture has this times the height
/// of the window over its width (both without sign), so that the window is drawn undistorted and
/// the field of view, or the parallel height, is the whole picture's vertical one.
CameraFrame frame(const Camera& camera, double aspect);

/// The ray at an image position as above, given as 2x - 1 and 2y - 1.
CameraLine line_at(const CameraFrame& frame, double right, double down);

}  // namespace penumbra
