// SPDX-License-Identifier: MIT
#include "penumbra/trace/bake_objects.h"

#include <fmt/format.h>

#include <algorithm>

#include "penumbra/scene/error.h"

namespace penumbra {
namespace {

UvSet choose_set(const ShapeSet& shapes, UvChoice choice) {
  switch (choice) {
    case UvChoice::first: return UvSet::first;
    case UvChoice::second: return UvSet::second;
    case UvChoice::automatic: break;
  }
  const auto has_second = [](const Mesh& mesh) { return !mesh.lightmap_uvs.empty(); };
  return std::any_of(shapes.meshes.begin(), shapes.meshes.end(), has_second) ? UvSet::second
                                                                             : UvSet::first;
}

[[noreturn]] void refuse(const Scene& scene, const BakeObjects& found) {
  const Error::Place place{scene.name, {}, {}};
  if (found.instanced > 0)
    throw Error(place,
                fmt::format("its {} meshes with texture coordinates stand in several places each, "
                            "which would share their texels",
                            found.instanced),
                "make them objects of their own (Blender: Object > Relations > Make Single User) "
                "and unwrap them together");
  if (found.without_uvs == 0)
    throw Error(place, "it has no triangle mesh, and nothing else has texture coordinates (UVs)",
                "bake a mesh: OBJ, PLY, glTF");
  throw Error(place,
              fmt::format("no mesh has {}texture coordinates (UVs), which say where in the texture "
                          "a triangle lies",
                          found.set == UvSet::second ? "a second set of " : ""),
              "make them, without overlaps: Blender (UV > Lightmap Pack, or Smart UV Project), "
              "xatlas; and save as glTF or OBJ");
}

}  // namespace

BakeObjects bake_objects(const Scene& scene, UvChoice choice) {
  const ShapeSet& shapes = scene.shapes;
  BakeObjects found;
  found.set = choose_set(shapes, choice);
  for (std::uint32_t i = 0; i < shapes.meshes.size(); ++i) {
    const Mesh& mesh = shapes.meshes[i];
    if (uvs_of(mesh, found.set).empty()) {
      if (!mesh.is_backdrop) ++found.without_uvs;
      continue;
    }
    const bool is_part = !found.objects.empty() && !mesh.name.empty() &&
                         found.objects.back().name == mesh.name &&
                         found.objects.back().meshes.back() + 1 == i;
    if (!is_part) found.objects.push_back({mesh.name, {}});
    found.objects.back().meshes.push_back(i);
  }
  for (const ShapeSet& group : shapes.groups)
    for (const Mesh& mesh : group.meshes) {
      const bool has_any = !mesh.uvs.empty() || !mesh.lightmap_uvs.empty();
      ++(has_any ? found.instanced : found.without_uvs);
    }
  if (found.objects.empty()) refuse(scene, found);
  return found;
}

}  // namespace penumbra
