// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>
#include <string>
#include <type_traits>

#include <fmt/format.h>

#include "penumbra/geometry/placed_shape.h"
#include "penumbra/scene/check_light.h"
#include "penumbra/scene/coordinates.h"
#include "penumbra/scene/error.h"
#include "penumbra/scene/scene.h"
#include "penumbra/scene/settle_instances.h"

namespace penumbra {

namespace {

bool is_color(Color c) { return is_finite(c) && c.x >= 0 && c.y >= 0 && c.z >= 0; }

/// Names the scene in the errors that its checks throw.
class Checker {
 public:
  explicit Checker(std::string scene_name) : scene_name_(std::move(scene_name)) {}

  void require(bool holds, const char* thing, std::size_t index, const char* problem,
               const char* hint) const {
    if (!holds)
      throw Error({scene_name_, {}, {}}, fmt::format("{} {} {}", thing, index, problem), hint);
  }
  void require(bool holds, const char* problem, const char* hint) const {
    if (!holds) throw Error({scene_name_, {}, {}}, problem, hint);
  }

 private:
  std::string scene_name_;
};

constexpr const char* coordinate_problem = "has a coordinate that is not a number within ±1e15";
constexpr const char* coordinate_hint = "mend the number, or scale the scene";
constexpr const char* radius_problem = "has a radius that is not above 0 and within 1e15";
constexpr const char* radius_hint = "give it a size, or leave it out";
constexpr const char* surface_problem = "names a material that does not exist";
constexpr const char* surface_hint = "number materials from 0";
constexpr const char* color_problem = "has a colour that is negative or not finite";
constexpr const char* color_hint = "give numbers from 0 up";

void check_materials(const Scene& scene, const Checker& check) {
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    const Material& m = scene.materials[i];
    for (Color c : {m.diffuse, m.highlight, m.mirror, m.transmission, m.emission})
      check.require(is_color(c), "material", i, color_problem, color_hint);
    check.require(m.shininess >= 0 && std::isfinite(m.shininess), "material", i,
                  "has a shininess that is negative or not finite", color_hint);
    check.require(m.refraction_index > 0 && std::isfinite(m.refraction_index), "material", i,
                  "has a refraction index that is not above 0", "use 1 for none");
    check.require(m.texture >= -1 && m.texture < static_cast<std::int64_t>(scene.textures.size()),
                  "material", i, "names a texture that does not exist", "use -1 for none");
  }
  for (std::size_t i = 0; i < scene.textures.size(); ++i) {
    const Texture& t = scene.textures[i];
    check.require(t.pixels.size() == std::uint64_t{t.width} * t.height, "texture", i,
                  "has more or fewer pixels than its size says", "give width x height of them");
  }
}

void check_shapes(ShapeSet& shapes, std::size_t materials, const Checker& check) {
  constexpr std::size_t most = std::numeric_limits<std::uint32_t>::max();
  check.require(shapes.spheres.size() < most && shapes.cones.size() < most &&
                    shapes.rings.size() < most && shapes.meshes.size() < most,
                "more shapes of a kind than 32 bits can count", "split the scene");
  for (std::size_t i = 0; i < shapes.spheres.size(); ++i) {
    const Sphere& s = shapes.spheres[i];
    check.require(is_coordinate(s.center), "sphere", i, coordinate_problem, coordinate_hint);
    check.require(is_radius(s.radius), "sphere", i, radius_problem, radius_hint);
    check.require(s.surface < materials, "sphere", i, surface_problem, surface_hint);
  }
  for (std::size_t i = 0; i < shapes.cones.size(); ++i) {
    const Cone& c = shapes.cones[i];
    check.require(is_coordinate(c.base) && is_coordinate(c.apex), "cone", i, coordinate_problem,
                  coordinate_hint);
    check.require((is_radius(c.base_radius) || c.base_radius == 0) &&
                      (is_radius(c.apex_radius) || c.apex_radius == 0) &&
                      (c.base_radius > 0 || c.apex_radius > 0),
                  "cone", i, "has a radius that is negative or beyond 1e15, or two that are 0",
                  radius_hint);
    check.require(c.base != c.apex, "cone", i, "has its base where its apex is", radius_hint);
    check.require(c.surface < materials, "cone", i, surface_problem, surface_hint);
  }
  for (std::size_t i = 0; i < shapes.rings.size(); ++i) {
    Ring& r = shapes.rings[i];
    check.require(is_coordinate(r.center), "ring", i, coordinate_problem, coordinate_hint);
    check.require(is_radius(r.radius), "ring", i, radius_problem, radius_hint);
    check.require(r.inner_radius >= 0 && r.inner_radius < r.radius, "ring", i,
                  "has an inner radius that is not within its radius", radius_hint);
    r.normal = unit(r.normal);
    check.require(r.normal != Vec3f{}, "ring", i, "has no normal", "give it a direction");
    check.require(r.surface < materials, "ring", i, surface_problem, surface_hint);
  }
}

/// Unit normals; where one is zero or not finite, the mean of the faces around the vertex.
void mend_normals(Mesh& mesh) {
  std::vector<std::uint32_t> missing;
  for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
    mesh.normals[i] = unit(mesh.normals[i]);
    if (mesh.normals[i] == Vec3f{}) missing.push_back(static_cast<std::uint32_t>(i));
  }
  if (missing.empty()) return;

  std::vector<Vec3d> faces(mesh.positions.size());
  for (const Triangle& t : mesh.triangles) {
    const Vec3d a(mesh.positions[t[0]]), b(mesh.positions[t[1]]), c(mesh.positions[t[2]]);
    for (std::uint32_t corner : t) faces[corner] += cross(b - a, c - a);
  }
  for (std::uint32_t vertex : missing) {
    const Vec3f normal(normalize(faces[vertex]));
    mesh.normals[vertex] = normal == Vec3f{} ? Vec3f{0, 0, 1} : normal;
  }
}

void check_mesh(const Mesh& mesh, std::size_t i, std::size_t materials, const Checker& check) {
  const std::size_t vertices = mesh.positions.size();
  constexpr std::size_t most = std::numeric_limits<std::uint32_t>::max();
  check.require(vertices < most && mesh.triangles.size() < most, "mesh", i,
                "has more parts than 32 bits can count", "split it");
  const auto fits = [&](std::size_t size) { return size == 0 || size == vertices; };
  check.require(fits(mesh.normals.size()) && fits(mesh.uvs.size()) && fits(mesh.colors.size()) &&
                    fits(mesh.lightmap_uvs.size()),
                "mesh", i, "has normals, texture coordinates or colours for some vertices only",
                "give each vertex one, or none at all");
  check.require(mesh.surfaces.empty() || mesh.surfaces.size() == mesh.triangles.size(), "mesh", i,
                "has materials for some triangles only", "give each triangle one, or none at all");
  for (Vec3f p : mesh.positions)
    check.require(is_coordinate(p), "mesh", i, coordinate_problem, coordinate_hint);
  for (Color c : mesh.colors) check.require(is_color(c), "mesh", i, color_problem, color_hint);
  for (const Triangle& t : mesh.triangles)
    check.require(t[0] < vertices && t[1] < vertices && t[2] < vertices, "mesh", i,
                  "has a triangle with a vertex that does not exist", "number vertices from 0");
  check.require(mesh.surface < materials, "mesh", i, surface_problem, surface_hint);
  for (std::uint32_t surface : mesh.surfaces)
    check.require(surface < materials, "mesh", i, surface_problem, surface_hint);
}

/// Checks all meshes, then mends them; returns how many degenerate triangles went.
std::size_t check_meshes(std::vector<Mesh>& meshes, std::size_t materials, const Checker& check) {
  std::size_t dropped = 0;
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    check_mesh(meshes[i], i, materials, check);
    dropped += drop_degenerate_triangles(meshes[i]);
    mend_normals(meshes[i]);
  }
  std::erase_if(meshes, [](const Mesh& mesh) { return mesh.triangles.empty(); });
  return dropped;
}

/// Instances that place something, as the kernel can have it.
void check_instances(ShapeSet& shapes, const Checker& check) {
  for (std::size_t i = 0; i < shapes.instances.size(); ++i) {
    const auto& [group, map] = shapes.instances[i];
    check.require(group < shapes.groups.size(), "instance", i, "places a group that does not exist",
                  "number groups from 0");
    check.require(is_coordinate(map.offset) && can_place(map), "instance", i,
                  "has a placement that flattens, or numbers below 1e-15 or beyond 1e15",
                  "use settle_instances");
    check.require(!has_quadrics(shapes.groups[group]) || similarity_scale(map) > 0, "instance", i,
                  "stretches spheres, cones or rings", "use settle_instances");
  }
  std::erase_if(shapes.instances, [&](const Instance& instance) {
    return own_primitive_count(shapes.groups[instance.group]) == 0;
  });
  if (shapes.instances.empty()) return;
  check.require(primitive_count(shapes) < 1u << 31, "instances place more than 2^31 primitives",
                "split the scene");
  const Box box = bounds(shapes);
  check.require(box.is_empty() || (is_coordinate(box.lo) && is_coordinate(box.hi)),
                "an instance reaches beyond 1e15", coordinate_hint);
}

void check_lights(Scene& scene, const Checker& check) {
  const double extent = bounds(scene.shapes).largest_extent();
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    Light& light = scene.lights[i];
    check.require(is_color(light.intensity), "light", i, color_problem, color_hint);
    const std::optional<LightProblem> problem = problem_of(light.shape);
    if (problem) check.require(false, "light", i, problem->what, problem->hint);
    check.require(!is_too_large(light.shape, extent), "light", i,
                  "is more than a million times as large as the scene", "use sun, or a sphere");
    if (auto* sun = std::get_if<SunLight>(&light.shape)) sun->direction = unit(sun->direction);
    if (auto* disk = std::get_if<DiskLight>(&light.shape)) disk->normal = unit(disk->normal);
    if (!light.beam) continue;
    const std::optional<LightProblem> beam_problem = problem_of(*light.beam, light.shape);
    if (beam_problem) check.require(false, "light", i, beam_problem->what, beam_problem->hint);
    light.beam->axis = unit(light.beam->axis);
  }
}

// Comparisons are written so that NaN fails them.
void check_camera(const Camera& camera, const Checker& check) {
  check.require(is_coordinate(camera.from) && is_coordinate(camera.at) &&
                    is_coordinate(camera.up) && std::isfinite(camera.fov_deg),
                "the camera has a number that is not finite and within ±1e15", coordinate_hint);
  check.require(camera.near >= 0 && camera.near <= largest_coordinate,
                "the camera's near distance is negative or not finite", "use 0 for none");
  check.require(camera.parallel_height >= 0 && camera.parallel_height <= largest_coordinate,
                "the height of the camera's parallel view is negative or not finite",
                "use 0 for perspective");
  const ImageWindow& w = camera.window;
  constexpr double most = 1e6;  // pictures away from the middle, or across
  for (const double edge : {w.left, w.top, w.right, w.bottom})
    check.require(std::abs(edge) <= most, "the camera's window has an edge beyond ±1e6",
                  "use 0 0 1 1 for the whole picture");
  check.require(std::abs(w.right - w.left) >= 1 / most && std::abs(w.bottom - w.top) >= 1 / most,
                "the camera's window is empty", "use 0 0 1 1 for the whole picture");
  check.require(camera.width > 0 && camera.height > 0, "the camera's resolution is 0",
                "use 512 x 512");
}

void check_surroundings(Scene& scene, const Checker& check) {
  check.require(is_color(scene.ambient) && (!scene.background || is_color(*scene.background)),
                "the background or the ambient light is negative or not finite", color_hint);
  scene.up = normalize(scene.up);
  check.require(scene.up != Vec3d{}, "no direction is up", "give one that is not 0");
  if (scene.camera) check_camera(*scene.camera, check);
}

}  // namespace

ValidationReport validate(Scene& scene) {
  const Checker check(scene.name);
  if (scene.materials.empty()) scene.materials.emplace_back();
  check_materials(scene, check);
  ValidationReport report;
  const auto check_set = [&](ShapeSet& shapes) {
    check_shapes(shapes, scene.materials.size(), check);
    report.degenerate_triangles += check_meshes(shapes.meshes, scene.materials.size(), check);
  };
  check_set(scene.shapes);
  for (ShapeSet& group : scene.shapes.groups) {
    check.require(group.groups.empty() && group.instances.empty(), "a group holds groups",
                  "compose the placements");
    check_set(group);
  }
  check_instances(scene.shapes, check);
  check.require(primitive_count(scene.shapes) > 0, "nothing to draw",
                "give it a sphere, a cone or a triangle that is not degenerate");
  check_lights(scene, check);
  check_surroundings(scene, check);
  return report;
}

}  // namespace penumbra
