// SPDX-License-Identifier: MIT
// glTF's physical materials in our model of Lambert, Phong, mirror and refraction.
#pragma once

#include <cstddef>
#include <vector>

#include "penumbra/scene/scene.h"
#include "penumbra/scene_io/gltf_document.h"
#include "penumbra/scene_io/texture_io.h"

namespace penumbra {

/// Which texture coordinates a material uses, and how they are moved (KHR_texture_transform).
struct GltfUvUse {
  std::size_t set = 0;  ///< TEXCOORD_<set>
  double offset_u = 0, offset_v = 0, rotation_rad = 0, scale_u = 1, scale_v = 1;

  bool is_moved() const {
    return offset_u != 0 || offset_v != 0 || rotation_rad != 0 || scale_u != 1 || scale_v != 1;
  }
};

/// Ours from glTF's coordinates, whose v grows downwards.
Vec2f to_uv(const GltfUvUse& use, float u, float v);

/// Appends the file's materials to the scene, in order, and after them the one for primitives
/// without. Returns the use of each.
/// (1) Base colour times what is not metal is Lambert's; rough metal is, too, since a Phong lobe
/// has no environment to show. (2) Metal mirrors base colour times (1 - roughness)². (3) The
/// highlight is F0 with Phong's exponent for the roughness, normalised, at most 8 F0. (4)
/// Transmission takes its part of the Lambert share; it refracts where the material has a volume.
std::vector<GltfUvUse> add_materials(const GltfDocument& gltf, Scene& scene,
                                     TextureLoader& textures, Warnings& warnings);

}  // namespace penumbra
