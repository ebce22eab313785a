// SPDX-License-Identifier: MIT
#include "scene_argument.h"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <utility>

#include "penumbra/scene/error.h"
#include "penumbra/scene/gallery.h"

namespace penumbra {

const char* const scene_argument_help =
    "A file (NFF, OBJ, PLY, STL, glTF, pbrt, Radiance, PDB, mmCIF, ..., .gz of any) or a built-in "
    "scene (cylinders, balls:N, rings, molecule, bust)";

Scene load_scene(const std::string& name, const ReadOptions& options) {
  std::error_code ignored;  // read_scene says it better
  const std::filesystem::file_type type = std::filesystem::status(name, ignored).type();
  if (type == std::filesystem::file_type::not_found) return load_built_in_scene(name);
  if (type == std::filesystem::file_type::directory)
    if (std::optional<Scene> scene = gallery_scene(name)) return *std::move(scene);
  SceneFile file = read_scene(name, options);
  for (const std::string& warning : file.warnings) fmt::print(stderr, "warning: {}\n", warning);
  return std::move(file.scene);
}

Scene load_built_in_scene(const std::string& name) {
  if (std::optional<Scene> scene = gallery_scene(name)) return *std::move(scene);
  std::string names;
  for (const GalleryEntry& entry : gallery_help())
    names += (names.empty() ? "" : ", ") + entry.name;
  throw Error({name, {}, {}}, "no such file, and no built-in scene of that name",
              "built-in are " + names);
}

}  // namespace penumbra
