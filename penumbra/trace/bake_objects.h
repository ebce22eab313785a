// SPDX-License-Identifier: MIT
// What of a scene can be baked into textures.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "penumbra/scene/scene.h"
#include "penumbra/trace/uv_atlas.h"

namespace penumbra {

enum class UvChoice { automatic, first, second };

/// Meshes that are parts of one object: neighbours with one name.
struct BakeObject {
  std::string name;  ///< may be empty
  std::vector<std::uint32_t> meshes;
};

struct BakeObjects {
  std::vector<BakeObject> objects;
  UvSet set = UvSet::first;
  std::size_t without_uvs = 0;  ///< meshes that are left out, backdrops not counted
  std::size_t instanced = 0;    ///< meshes with coordinates that instances place: the same, as
                                ///< their places cannot share texels
};

/// Automatic: the second set if any mesh has one, then of those that do. Throws Error where nothing
/// is left, with what to do about it.
BakeObjects bake_objects(const Scene& scene, UvChoice choice = UvChoice::automatic);

}  // namespace penumbra
