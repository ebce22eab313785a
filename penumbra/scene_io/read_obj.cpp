// SPDX-License-Identifier: MIT
// Wavefront OBJ: statements (obj_parse), meshes (obj_meshes), materials (read_mtl).
#include <iterator>
#include <map>
#include <string>

#include <fmt/format.h>

#include "penumbra/scene_io/light_emitters.h"
#include "penumbra/scene_io/obj_data.h"
#include "penumbra/scene_io/read_mtl.h"
#include "penumbra/scene_io/source.h"
#include "penumbra/scene_io/text_lines.h"
#include "penumbra/scene_io/texture_io.h"

namespace penumbra {

namespace {

using MaterialsByName = std::map<std::string, Material, std::less<>>;

void add_library(std::string_view name, std::size_t line, const Source& source,
                 TextureLoader& textures, Warnings& warnings, MaterialsByName& materials) {
  const auto path = find_beside(source.path, name);
  if (!path) {
    warnings.add(fmt::format("the material file '{}' is missing; its materials are grey", name),
                 line);
    return;
  }
  const Source library = load(*path);
  for (Material& material : read_mtl(library.bytes, library.path.string(), textures, warnings))
    materials.emplace(material.name, std::move(material));  // the first of a name counts
}

/// The materials of all mtllib lines. A line names several files, or one with spaces.
MaterialsByName read_libraries(const ObjData& data, const Source& source, TextureLoader& textures,
                               Warnings& warnings) {
  MaterialsByName materials;
  for (const ObjMention& mention : data.libraries) {
    if (find_beside(source.path, mention.text)) {
      add_library(mention.text, mention.line, source, textures, warnings, materials);
      continue;
    }
    std::string_view rest = mention.text;
    for (auto name = next_word(rest); !name.empty(); name = next_word(rest))
      add_library(name, mention.line, source, textures, warnings, materials);
  }
  return materials;
}

}  // namespace

Scene read_obj(const Source& source, Warnings& warnings) {
  Scene scene;
  scene.name = source.path.string();
  scene.up = {0, 1, 0};
  const ObjData data = parse_obj(source, warnings);
  if (data.faces.empty())
    throw Error({scene.name, {}, {}}, "there are no faces in the file", "is this an OBJ file?");

  TextureLoader textures(source, scene, warnings);
  const MaterialsByName materials = read_libraries(data, source, textures, warnings);
  for (const std::string& name : data.material_names) {
    const auto known = materials.find(name);
    Material material = known == materials.end() ? Material{} : known->second;
    material.name = name;
    if (known == materials.end() && !name.empty())
      warnings.add("a material that no material file defines; it is grey", data.first_use.at(name));
    // Vertex colours are the surface's whole colour where there is no material.
    if (known == materials.end() && !data.colors.empty()) material.diffuse = {1, 1, 1};
    scene.materials.push_back(std::move(material));
  }
  scene.shapes.meshes = obj_meshes(data, scene.name);
  light_emitters(scene, warnings);
  scene.wants_ground = scene.lights.empty();
  return scene;
}

}  // namespace penumbra
