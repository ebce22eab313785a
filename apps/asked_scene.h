// SPDX-License-Identifier: MIT
// The scene of commands that ask what points or surfaces see of its lights: unlike for pictures,
// nothing is added to it.
#pragma once

#include <string>

#include "penumbra/scene/scene.h"
#include "scene_options.h"

namespace penumbra {

/// The file's scene, or the built-in one, with the wished lights and ground. Throws Error, also
/// where there is no light.
Scene load_asked_scene(const std::string& name, const SceneWishes& wishes);

/// Says on stderr which number is which light.
void name_lights(const Scene& scene);

}  // namespace penumbra
