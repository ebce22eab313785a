// SPDX-License-Identifier: MIT
// OBJ's material files (Wavefront's MTL, and what exporters made of it).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "penumbra/scene/scene.h"
#include "penumbra/scene_io/source.h"
#include "penumbra/scene_io/texture_io.h"

namespace penumbra {

/// The materials of an MTL text, by our model:
/// (1) Kd and map_Kd are the diffuse colour (linear), Ks and Ns the highlight where illum is not 0
/// or 1, Ke the emission; (2) illum 3 to 8 mirror by Ks; (3) what d or Tr leave out of the diffuse
/// colour is transmitted, times Tf; glass (illum 4, 6, 7, 9) that is not dissolved transmits Tf;
/// (4) glass refracts by Ni, everything else lets rays pass straight.
/// Throws Error with `file` and line for numbers that are none.
std::vector<Material> read_mtl(std::string_view text, const std::string& file,
                               TextureLoader& textures, Warnings& warnings);

}  // namespace penumbra
