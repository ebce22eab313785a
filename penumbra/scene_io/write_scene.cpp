// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/write_scene.h"

#include "penumbra/geometry/placed_shape.h"
#include "penumbra/scene/error.h"
#include "penumbra/scene_io/ply.h"

namespace penumbra {

void write_scene(const std::filesystem::path& path, const Scene& scene) {
  if (!scene.shapes.instances.empty()) {
    Scene flat = scene;
    flat.shapes = flattened(scene.shapes);
    return write_scene(path, flat);
  }
  const std::string extension = path.extension().string();
  if (extension == ".nff") return write_file(path, to_nff(scene));
  if (extension == ".ply") return write_file(path, to_ply(scene, path.string()));
  throw Error({path.string(), {}, {}}, "scenes are not written as `" + extension + "`",
              "use .nff or .ply");
}

}  // namespace penumbra
