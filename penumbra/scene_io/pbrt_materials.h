// SPDX-License-Identifier: MIT
// pbrt's materials, brought to ours.
#pragma once

#include <string>

#include "penumbra/scene_io/pbrt_scene.h"

namespace penumbra {

/// Index of the slot of a material by name, defined or not yet.
std::uint32_t named_pbrt_material(PbrtScene& pbrt, const std::string& name, PbrtPlace place);

/// A slot for this definition.
std::uint32_t add_pbrt_material(PbrtScene& pbrt, PbrtDefinition definition);

/// Makes the scene's materials of all slots, once everything is read: takes out the shapes whose
/// material is no surface, gives those that cannot carry an image its mean colour, and moves
/// texture coordinates as the images want them. Throws Error for names that are not defined.
void finish_pbrt_materials(PbrtScene& pbrt);

}  // namespace penumbra
