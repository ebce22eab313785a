// SPDX-License-Identifier: MIT
#include "scene_argument.h"

#include <fmt/format.h>

#include <cstdio>
#include <utility>

namespace penumbra {

const char* const scene_argument_help =
    "A file (NFF, OBJ, PLY, STL, glTF, pbrt, Radiance, PDB, mmCIF, ..., .gz of any) or a built-in "
    "scene (cylinders, balls:N, rings, molecule, bust)";

Scene load_scene(const std::string& name, const ReadOptions& options) {
  SceneFile file = find_scene(name, options);
  for (const std::string& warning : file.warnings) fmt::print(stderr, "warning: {}\n", warning);
  return std::move(file.scene);
}

}  // namespace penumbra
