// SPDX-License-Identifier: MIT
// The SCENE argument: a file, or the name of a built-in scene.
#pragma once

#include <string>

#include "penumbra/scene/scene.h"
#include "penumbra/scene_io/read_scene.h"

namespace penumbra {

/// Help text of the argument.
extern const char* const scene_argument_help;

/// A file that exists, else the built-in scene of that name. Warnings go to stderr. Throws Error,
/// with the names of the built-in scenes when it is neither.
Scene load_scene(const std::string& name, const ReadOptions& options);

/// The built-in scene of that name; throws Error with the names there are.
Scene load_built_in_scene(const std::string& name);

}  // namespace penumbra
