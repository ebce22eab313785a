// SPDX-License-Identifier: MIT
// pbrt's Camera and Film as our camera.
#pragma once

#include "penumbra/scene_io/pbrt_scene.h"

namespace penumbra {

/// Gives the scene the camera that Camera and Film describe; none without Camera. pbrt's picture is
/// what its camera's x and y axes say, be they right-handed or left-handed; ours is right-handed,
/// so that a left-handed one (as LookAt makes it) becomes a window from right to left.
void finish_pbrt_camera(PbrtScene& pbrt);

}  // namespace penumbra
