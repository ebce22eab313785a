// SPDX-License-Identifier: MIT
// glTF 2.0, as .gltf or .glb: nodes, and what hangs on them.
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "penumbra/geometry/transform.h"
#include "penumbra/scene_io/exposure.h"
#include "penumbra/scene_io/gltf_document.h"
#include "penumbra/scene_io/gltf_materials.h"
#include "penumbra/scene_io/gltf_meshes.h"
#include "penumbra/scene_io/gltf_placement.h"
#include "penumbra/scene_io/gltf_views.h"
#include "penumbra/scene_io/light_emitters.h"
#include "penumbra/scene_io/source.h"
#include "penumbra/scene_io/texture_io.h"

namespace penumbra {

namespace {

struct Builder {
  GltfDocument& gltf;
  Scene& scene;
  Warnings& warnings;
  std::vector<GltfUvUse> uv_uses;
  std::vector<std::vector<Transform>> placements;  ///< of each mesh
  std::size_t copies_left = std::size_t{1} << 21;  ///< of meshes
  std::size_t flat_left = std::size_t{1} << 23;    ///< vertices and triangles of flattened ones
};

/// A mesh where a node puts it.
void add_copies(Builder& b, std::size_t mesh, const Json& node, const Transform& world) {
  if (mesh >= b.placements.size()) b.gltf.fail(fmt::format("mesh {} does not exist", mesh));
  const std::vector<Transform> copies = copies_of(b.gltf, node);
  if (copies.size() > b.copies_left)
    b.gltf.fail("its nodes place more than 2 million meshes", "split the scene");
  b.copies_left -= copies.size();
  for (const Transform& copy : copies) b.placements[mesh].push_back(compose(world, copy));
}

/// A copy of the meshes, moved: what no instance can be.
void place_flat(Builder& b, const std::vector<Mesh>& meshes, const Transform& world) {
  for (const Mesh& mesh : meshes) {
    const std::size_t cost = mesh.positions.size() + mesh.triangles.size();
    if (cost > b.flat_left)
      b.gltf.fail("its nodes flatten more than 8 million vertices and triangles",
                  "leave out what is scaled to nothing");
    b.flat_left -= cost;
    b.scene.shapes.meshes.push_back(transformed(mesh, world));
  }
}

/// Nothing is left of a volume under it: rays could not be brought back.
bool is_flat(const Transform& t) {
  const double box = length(t.x_axis) * length(t.y_axis) * length(t.z_axis);
  return !(std::abs(determinant(t)) > 1e-12 * box);
}

/// A mesh that is placed once is moved there; of the others there is one copy, as a group.
void place_meshes(Builder& b) {
  for (std::size_t i = 0; i < b.placements.size(); ++i) {
    const std::vector<Transform>& places = b.placements[i];
    if (places.empty()) continue;
    std::vector<Mesh> meshes = read_meshes(b.gltf, i, b.uv_uses, b.warnings);
    if (meshes.empty()) continue;
    ShapeSet& shapes = b.scene.shapes;
    if (places.size() == 1) {
      for (Mesh& mesh : meshes) shapes.meshes.push_back(transformed(std::move(mesh), places[0]));
      continue;
    }
    const auto group = static_cast<std::uint32_t>(shapes.groups.size());
    for (const Transform& world : places) {
      if (is_flat(world))
        place_flat(b, meshes, world);
      else
        shapes.instances.push_back({group, world});
    }
    shapes.groups.emplace_back().meshes = std::move(meshes);
  }
}

void read_node(Builder& b, const Json& node, const Transform& world) {
  if (const auto mesh = index_of(b.gltf, node, "mesh")) add_copies(b, *mesh, node, world);
  if (const auto camera = index_of(b.gltf, node, "camera"); camera && !b.scene.camera)
    b.scene.camera = read_camera(b.gltf, *camera, world, b.warnings);
  if (const Json* punctual = extension(node, "KHR_lights_punctual"))
    if (const auto index = index_of(b.gltf, *punctual, "light"))
      if (const auto light = read_light(b.gltf, *index, node, world, b.warnings))
        b.scene.lights.push_back(*light);
  if (member(node, "skin")) b.warnings.add("a skinned mesh is drawn in its rest pose");
}

/// KHR_node_visibility: with all that hangs on it.
bool is_hidden(const Json& node) {
  const Json* visibility = extension(node, "KHR_node_visibility");
  const Json* visible = visibility ? member(*visibility, "visible") : nullptr;
  return visible && *visible == false;
}

/// The nodes that nothing is above: those of the scene, or all without a parent.
std::vector<std::size_t> root_nodes(const GltfDocument& gltf) {
  const std::size_t count = element_count(gltf, "nodes");
  if (element_count(gltf, "scenes") > 0) {
    const std::size_t scene = index_of(gltf, gltf.root, "scene").value_or(0);
    return indices_of(gltf, element(gltf, "scenes", scene), "nodes");
  }
  std::vector<bool> has_parent(count);
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t child : indices_of(gltf, element(gltf, "nodes", i), "children"))
      if (child < count) has_parent[child] = true;
  std::vector<std::size_t> roots;
  for (std::size_t i = 0; i < count; ++i)
    if (!has_parent[i]) roots.push_back(i);
  return roots;
}

/// Depth first and in the file's order, on a stack of our own: hierarchies may be as deep as the
/// file is long.
void read_nodes(Builder& b) {
  struct Visit {
    std::size_t node = 0;
    Transform parent;
  };
  std::vector<Visit> stack;
  const auto push = [&](const std::vector<std::size_t>& nodes, const Transform& parent) {
    for (auto node = nodes.rbegin(); node != nodes.rend(); ++node) stack.push_back({*node, parent});
  };
  std::vector<bool> seen(element_count(b.gltf, "nodes"));
  push(root_nodes(b.gltf), {});
  while (!stack.empty()) {
    const Visit visit = stack.back();
    stack.pop_back();
    const Json& node = element(b.gltf, "nodes", visit.node);
    if (seen[visit.node])
      b.gltf.fail(fmt::format("node {} has two parents, or is its own ancestor", visit.node));
    seen[visit.node] = true;
    if (is_hidden(node)) continue;
    const Transform world = compose(visit.parent, transform_of(b.gltf, node));
    read_node(b, node, world);
    push(indices_of(b.gltf, node, "children"), world);
  }
}

}  // namespace

Scene read_gltf(const Source& source, Warnings& warnings) {
  GltfDocument gltf = open_gltf(source, warnings);
  Scene scene;
  scene.name = source.path.string();
  scene.up = {0, 1, 0};
  TextureLoader textures(source, scene, warnings);
  Builder builder{gltf, scene, warnings, add_materials(gltf, scene, textures, warnings), {}};
  builder.placements.resize(element_count(gltf, "meshes"));
  read_nodes(builder);
  place_meshes(builder);
  if (scene.shapes.meshes.empty() && scene.shapes.instances.empty())
    gltf.fail("there are no triangles in the scene", "does it show anything in a viewer?");
  light_emitters(scene, warnings);
  balance_lights(scene);
  scene.wants_ground = !scene.camera && scene.lights.empty();
  return scene;
}

}  // namespace penumbra
