// SPDX-License-Identifier: MIT
// What only assimp reads (COLLADA, FBX, 3DS, OFF, X3D, ...): in a process of its own, since its
// importers crash, hang and allocate without limit on damaged files.
#include <charconv>
#include <string>
#include <system_error>

#include <fmt/format.h>

#include "penumbra/scene_io/assimp_import.h"
#include "penumbra/scene_io/child_process.h"
#include "penumbra/scene_io/exposure.h"
#include "penumbra/scene_io/light_emitters.h"
#include "penumbra/scene_io/source.h"
#include "penumbra/scene_io/texture_io.h"

namespace penumbra {

namespace {

void load_textures(const AssimpScene& read, TextureLoader& textures, Scene& scene) {
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    const std::string& name = read.texture_names[i];
    if (name.empty()) continue;
    std::size_t image = read.images.size();
    if (name[0] == '*') std::from_chars(name.data() + 1, name.data() + name.size(), image);
    scene.materials[i].texture = image < read.images.size()
                                     ? textures.from_bytes(name, read.images[image])
                                     : textures.from_file(name);
  }
}

}  // namespace

Scene read_assimp(const Source& source, Warnings& warnings) {
  const std::string file = source.path.string();
  const ChildResult child = run_in_child([&] { return import_with_assimp(source); });
  const std::string hint = "is it damaged? else convert it to OBJ or glTF";
  if (!child.failure.empty())
    throw Error({file, {}, {}}, fmt::format("assimp could not read it: {}", child.failure), hint);
  AssimpScene read = unpack_assimp_scene(child.output, file);
  if (!read.error.empty())
    throw Error({file, {}, {}}, fmt::format("assimp could not read it: {}", read.error), hint);
  Scene scene = std::move(read.scene);
  scene.name = file;
  scene.up = {0, 1, 0};
  if (scene.shapes.meshes.empty())
    throw Error({file, {}, {}}, "there are no triangles in the file",
                "does it show anything in a viewer?");
  TextureLoader textures(source, scene, warnings);
  load_textures(read, textures, scene);
  balance_lights(scene);
  light_emitters(scene, warnings);
  scene.wants_ground = !scene.camera && scene.lights.empty();
  return scene;
}

}  // namespace penumbra
