// SPDX-License-Identifier: MIT
// Which of the extensions that a glTF file requires can be done without.
#pragma once

#include <string_view>

#include "penumbra/scene_io/gltf_document.h"

namespace penumbra {

/// Throws Error for an extension that is required and would change geometry or placement: what
/// compresses meshes, and what is not known. What only changes how surfaces look is a warning.
void check_required_extensions(const GltfDocument& gltf, Warnings& warnings);

/// Throws Error that says how to unpack the file.
[[noreturn]] void refuse_compression(const GltfDocument& gltf, std::string_view name);

}  // namespace penumbra
