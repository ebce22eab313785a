// SPDX-License-Identifier: MIT
// Lights of glowing surfaces, for the readers.
#pragma once

#include "penumbra/scene/scene.h"
#include "penumbra/scene_io/source.h"

namespace penumbra {

/// `add_emitter_lights`, and a warning where what it made is not quite what glows. The last thing a
/// reader does to a scene: shapes, placements and materials must be there.
void light_emitters(Scene& scene, Warnings& warnings);

}  // namespace penumbra
