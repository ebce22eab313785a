// SPDX-License-Identifier: MIT
// glTF's mesh primitives as meshes, in the mesh's own frame.
#pragma once

#include <cstddef>
#include <vector>

#include "penumbra/geometry/mesh.h"
#include "penumbra/scene_io/gltf_document.h"
#include "penumbra/scene_io/gltf_materials.h"

namespace penumbra {

/// One mesh for each primitive that has triangles (lists, strips, fans); others are a warning.
/// `uv_uses` is what `add_materials` returned. Throws Error for indices and arrays that do not fit.
std::vector<Mesh> read_meshes(GltfDocument& gltf, std::size_t mesh,
                              const std::vector<GltfUvUse>& uv_uses, Warnings& warnings);

}  // namespace penumbra
