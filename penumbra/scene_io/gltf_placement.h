// SPDX-License-Identifier: MIT
// Where glTF's nodes put what hangs on them.
#pragma once

#include <vector>

#include "penumbra/geometry/transform.h"
#include "penumbra/scene_io/gltf_document.h"

namespace penumbra {

/// A node's own map: its matrix, or its translation, rotation and scale.
Transform transform_of(const GltfDocument& gltf, const Json& node);

/// Maps from the node's frame, one for each copy of its mesh (EXT_mesh_gpu_instancing); the
/// identity alone where the node has no such list.
std::vector<Transform> copies_of(GltfDocument& gltf, const Json& node);

}  // namespace penumbra
