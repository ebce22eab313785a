// SPDX-License-Identifier: MIT
// assimp's side of reading a file: it happens in a process of its own, so what it finds goes
// through plain bytes.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "penumbra/scene/scene.h"
#include "penumbra/scene_io/source.h"

namespace penumbra {

/// A scene whose textures are still names (one a material; "*3" is the fourth of `images`).
struct AssimpScene {
  std::string error;  ///< assimp's words, where it could not read the file
  Scene scene;
  std::vector<std::string> texture_names;  ///< empty: none
  std::vector<std::string> images;         ///< files inside the file
};

/// Imports with assimp, nodes' transforms applied, triangles alone, and packs the result.
std::string import_with_assimp(const Source& source);

/// What `import_with_assimp` packed; nothing is believed of sizes. Throws Error.
AssimpScene unpack_assimp_scene(const std::string& bytes, const std::string& file);

}  // namespace penumbra
