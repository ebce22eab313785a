// SPDX-License-Identifier: MIT
// glTF 2.0, as .gltf or .glb: nodes, and what hangs on them.
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "penumbra/geometry/transform.h"
#include "penumbra/scene_io/exposure.h"
#include "penumbra/scene_io/gltf_document.h"
#include "penumbra/scene_io/gltf_materials.h"
#include "penumbra/scene_io/gltf_meshes.h"
#include "penumbra/scene_io/light_emitters.h"
#include "penumbra/scene_io/source.h"
#include "penumbra/scene_io/texture_io.h"

namespace penumbra {

namespace {

/// Seen from the earth.
constexpr float sun_half_angle_rad = 0.53f / 2 * std::numbers::pi_v<float> / 180;

struct Builder {
  GltfDocument& gltf;
  Scene& scene;
  Warnings& warnings;
  std::vector<GltfUvUse> uv_uses;
  std::vector<std::optional<std::vector<Mesh>>> meshes;  ///< read once, placed many times
  std::size_t placed_left = std::size_t{1} << 27;        ///< vertices and triangles
};

Transform from_matrix(const std::vector<double>& m) {
  return {{m[0], m[1], m[2]}, {m[4], m[5], m[6]}, {m[8], m[9], m[10]}, {m[12], m[13], m[14]}};
}

Transform from_parts(const std::vector<double>& t, const std::vector<double>& q,
                     const std::vector<double>& s) {
  const double norm = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
  const double k = norm > 0 && std::isfinite(norm) ? 2 / norm : 0;
  const double x = q[0], y = q[1], z = q[2], w = q[3];
  const Vec3d ax{1 - k * (y * y + z * z), k * (x * y + z * w), k * (x * z - y * w)};
  const Vec3d ay{k * (x * y - z * w), 1 - k * (x * x + z * z), k * (y * z + x * w)};
  const Vec3d az{k * (x * z + y * w), k * (y * z - x * w), 1 - k * (x * x + y * y)};
  return {ax * s[0], ay * s[1], az * s[2], {t[0], t[1], t[2]}};
}

Transform transform_of(const GltfDocument& gltf, const Json& node) {
  if (const auto matrix = numbers_of(gltf, node, "matrix", 16)) return from_matrix(*matrix);
  return from_parts(numbers_of(gltf, node, "translation", 3).value_or(std::vector{0.0, 0.0, 0.0}),
                    numbers_of(gltf, node, "rotation", 4).value_or(std::vector{0.0, 0.0, 0.0, 1.0}),
                    numbers_of(gltf, node, "scale", 3).value_or(std::vector{1.0, 1.0, 1.0}));
}

void place_mesh(Builder& b, std::size_t index, const Transform& world) {
  if (index >= b.meshes.size()) b.gltf.fail(fmt::format("mesh {} does not exist", index));
  if (!b.meshes[index]) b.meshes[index] = read_meshes(b.gltf, index, b.uv_uses, b.warnings);
  for (const Mesh& mesh : *b.meshes[index]) {
    const std::size_t cost = mesh.positions.size() + mesh.triangles.size();
    if (cost > b.placed_left)
      b.gltf.fail("its nodes place more than 130 million vertices and triangles",
                  "split the scene");
    b.placed_left -= cost;
    b.scene.shapes.meshes.push_back(transformed(mesh, world));
  }
}

void add_camera(Builder& b, std::size_t index, const Transform& world) {
  if (b.scene.camera) return;
  const Json& json = element(b.gltf, "cameras", index);
  const Json* perspective = member(json, "perspective");
  if (!perspective) {
    b.warnings.add("an orthographic camera is not read");
    return;
  }
  Camera camera;
  camera.from = world.offset;
  camera.at = world.offset - normalize(world.z_axis);  // a camera looks along its -z
  camera.up = normalize(world.y_axis);
  camera.fov_deg = number_of(b.gltf, *perspective, "yfov", 0) * 180 / std::numbers::pi;
  const double view_length = length(cross(world.z_axis, world.y_axis));
  if (!(camera.fov_deg > 0 && camera.fov_deg < 180) || !(view_length > 0)) {
    b.warnings.add("a camera with no field of view or direction is not read");
    return;
  }
  b.scene.camera = camera;
}

/// KHR_lights_punctual: candela for points, lux for suns; `balance_lights` makes a picture of them.
void add_light(Builder& b, std::size_t index, const Transform& world) {
  const Json* lists = extension(b.gltf.root, "KHR_lights_punctual");
  const Json* lights = lists ? member(*lists, "lights") : nullptr;
  if (!lights || !lights->is_array() || index >= lights->size())
    b.gltf.fail(fmt::format("light {} does not exist", index));
  const Json& json = (*lights)[index];
  const auto color = numbers_of(b.gltf, json, "color", 3).value_or(std::vector{1.0, 1.0, 1.0});
  const double intensity = number_of(b.gltf, json, "intensity", 1);
  Light light;
  light.intensity = max(Color(Vec3d{color[0], color[1], color[2]} * intensity), Color{});
  const std::string type = string_of(b.gltf, json, "type");
  if (type == "directional") {
    const Vec3d direction = normalize(world.z_axis);  // it shines along its -z
    if (direction == Vec3d{}) return;
    light.shape = SunLight{Vec3f(direction), sun_half_angle_rad};
  } else if (type == "point" || type == "spot") {
    light.shape = PointLight{Vec3f(world.offset)};
    light.falloff = Falloff::inverse_square;
    if (type == "spot") b.warnings.add("a spot light shines in all directions");
  } else {
    b.warnings.add(fmt::format("a light of type '{:.20}' is not read", type));
    return;
  }
  if (max_abs(light.intensity) > 0) b.scene.lights.push_back(light);
}

void read_node(Builder& b, const Json& node, const Transform& world) {
  if (const auto mesh = index_of(b.gltf, node, "mesh")) place_mesh(b, *mesh, world);
  if (const auto camera = index_of(b.gltf, node, "camera")) add_camera(b, *camera, world);
  if (const Json* punctual = extension(node, "KHR_lights_punctual"))
    if (const auto light = index_of(b.gltf, *punctual, "light")) add_light(b, *light, world);
  if (member(node, "skin")) b.warnings.add("a skinned mesh is drawn in its rest pose");
  if (extension(node, "EXT_mesh_gpu_instancing"))
    b.warnings.add("instances (EXT_mesh_gpu_instancing) are not read: one of each is drawn");
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
    const Transform world = compose(visit.parent, transform_of(b.gltf, node));
    read_node(b, node, world);
    push(indices_of(b.gltf, node, "children"), world);
  }
}

}  // namespace

Scene read_gltf(const Source& source, Warnings& warnings) {
  GltfDocument gltf = open_gltf(source);
  Scene scene;
  scene.name = source.path.string();
  scene.up = {0, 1, 0};
  TextureLoader textures(source, scene, warnings);
  Builder builder{gltf, scene, warnings, add_materials(gltf, scene, textures, warnings), {}};
  builder.meshes.resize(element_count(gltf, "meshes"));
  read_nodes(builder);
  if (scene.shapes.meshes.empty())
    gltf.fail("there are no triangles in the scene", "does it show anything in a viewer?");
  balance_lights(scene);
  light_emitters(scene, warnings);
  scene.wants_ground = !scene.camera && scene.lights.empty();
  return scene;
}

}  // namespace penumbra
