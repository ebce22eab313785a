// SPDX-License-Identifier: MIT
// The SCENE argument: a file, or the name of a built-in scene.
#pragma once

#include <string>

#include "penumbra/render.h"

namespace penumbra {

/// Help text of the argument.
extern const char* const scene_argument_help;

/// A file that exists, else the built-in scene of that name. Warnings go to stderr. Throws Error,
/// with the names of the built-in scenes when it is neither.
Scene load_scene(const std::string& name, const ReadOptions& options);

}  // namespace penumbra
