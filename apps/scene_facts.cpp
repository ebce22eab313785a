// SPDX-License-Identifier: MIT
#include "scene_facts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>
#include <numbers>
#include <variant>

#include "penumbra/geometry/closed_surface.h"
#include "penumbra/geometry/mesh.h"
#include "penumbra/trace/prepare.h"

namespace penumbra {
namespace {

using Json = nlohmann::ordered_json;

MeshFacts mesh_facts(const Mesh& mesh) {
  const MeshTopology shape = topology(mesh);
  MeshFacts facts;
  facts.vertices = mesh.positions.size();
  facts.triangles = mesh.triangles.size();
  facts.closed_components =
      static_cast<std::size_t>(std::count(shape.is_closed.begin(), shape.is_closed.end(), true));
  for (const std::uint32_t component : shape.component)
    facts.closed_triangles += shape.is_closed[component];
  facts.open_components = shape.is_closed.size() - facts.closed_components;
  facts.boundary_edges = shape.boundary_edges;
  facts.nonmanifold_edges = shape.nonmanifold_edges;
  facts.has_normals = !mesh.normals.empty();
  facts.is_backdrop = mesh.is_backdrop;
  return facts;
}

SolidFacts solid_facts(const Scene& scene) {
  SolidFacts facts;
  for (const ClosedSurface& surface :
       closed_surfaces(scene.shapes.meshes, kernel_options(scene).casts_no_shadow)) {
    ++(surface.fills().empty() ? facts.closed : facts.filled);
    facts.fills += surface.fills().size();
    facts.triangles += surface.first_fill;
    facts.largest = std::max(facts.largest, surface.first_fill);
  }
  return facts;
}

void add(MeshFacts& sum, const MeshFacts& mesh) {
  sum.vertices += mesh.vertices;
  sum.triangles += mesh.triangles;
  sum.closed_components += mesh.closed_components;
  sum.open_components += mesh.open_components;
  sum.closed_triangles += mesh.closed_triangles;
  sum.boundary_edges += mesh.boundary_edges;
  sum.nonmanifold_edges += mesh.nonmanifold_edges;
}

template <typename Number>
std::string text(Vec3<Number> v) {
  return fmt::format("({:g}, {:g}, {:g})", v.x, v.y, v.z);
}

template <typename Number>
Json json(Vec3<Number> v) {
  return {v.x, v.y, v.z};
}

Json json(const std::vector<Vec3f>& points) {
  Json list = Json::array();
  for (const Vec3f point : points) list.push_back(json(point));
  return list;
}

double full_angle_deg(const SunLight& sun) {
  return 2.0 * sun.half_angle_rad * 180 / std::numbers::pi;
}

struct LightText {
  std::string operator()(const PointLight& l) const { return "point at " + text(l.center); }
  std::string operator()(const BallLight& l) const {
    return fmt::format("ball at {}, radius {:g}", text(l.center), l.radius);
  }
  std::string operator()(const ParallelogramLight& l) const {
    return fmt::format("parallelogram at {}, half edges {} and {}", text(l.center), text(l.u),
                       text(l.v));
  }
  std::string operator()(const DiskLight& l) const {
    return fmt::format("disk at {}, normal {}, radius {:g}", text(l.center), text(l.normal),
                       l.radius);
  }
  std::string operator()(const LineLight& l) const {
    return fmt::format("line from {} to {}", text(l.center - l.half), text(l.center + l.half));
  }
  std::string operator()(const PolygonLight& l) const {
    return fmt::format("polygon at {}, {} corners", text(l.center), l.corners.size());
  }
  std::string operator()(const MeshLight& l) const {
    return fmt::format("convex mesh at {}, {} corners, {} triangles", text(l.center),
                       l.corners.size(), l.triangles.size());
  }
  std::string operator()(const SunLight& l) const {
    return fmt::format("sun towards {}, {:.3g} degrees wide", text(l.direction), full_angle_deg(l));
  }
};

struct LightJson {
  Json operator()(const PointLight& l) const {
    return {{"shape", "point"}, {"center", json(l.center)}};
  }
  Json operator()(const BallLight& l) const {
    return {{"shape", "ball"}, {"center", json(l.center)}, {"radius", l.radius}};
  }
  Json operator()(const ParallelogramLight& l) const {
    return {
        {"shape", "parallelogram"}, {"center", json(l.center)}, {"u", json(l.u)}, {"v", json(l.v)}};
  }
  Json operator()(const DiskLight& l) const {
    return {{"shape", "disk"},
            {"center", json(l.center)},
            {"normal", json(l.normal)},
            {"radius", l.radius}};
  }
  Json operator()(const LineLight& l) const {
    return {{"shape", "line"}, {"from", json(l.center - l.half)}, {"to", json(l.center + l.half)}};
  }
  Json operator()(const PolygonLight& l) const {
    return {{"shape", "polygon"}, {"center", json(l.center)}, {"corners", json(l.corners)}};
  }
  Json operator()(const MeshLight& l) const {
    return {{"shape", "mesh"},
            {"center", json(l.center)},
            {"corners", json(l.corners)},
            {"triangles", l.triangles}};
  }
  Json operator()(const SunLight& l) const {
    return {{"shape", "sun"},
            {"direction", json(l.direction)},
            {"angular_diameter_deg", full_angle_deg(l)}};
  }
};

double angle_deg(float cosine) { return std::acos(double{cosine}) * 180 / std::numbers::pi; }

std::string beam_text(const std::optional<Beam>& beam) {
  if (!beam) return "";
  return fmt::format(", beam along {}, full up to {:.3g} degrees, none from {:.3g} on",
                     text(beam->axis), angle_deg(beam->cos_full), angle_deg(beam->cos_none));
}

std::string view_text(const Camera& camera) {
  std::string out = camera.parallel_height > 0
                        ? fmt::format("parallel, {:g} high", camera.parallel_height)
                        : fmt::format("{:g} degrees", camera.fov_deg);
  const ImageWindow& w = camera.window;
  if (w.left != 0 || w.top != 0 || w.right != 1 || w.bottom != 1)
    out += fmt::format(", window ({:g}, {:g}) to ({:g}, {:g})", w.left, w.top, w.right, w.bottom);
  return out;
}

Json camera_json(const Camera& camera) {
  const ImageWindow& w = camera.window;
  Json json_camera = {{"kind", camera.parallel_height > 0 ? "parallel" : "perspective"},
                      {"from", json(camera.from)},
                      {"at", json(camera.at)},
                      {"up", json(camera.up)},
                      {"fov_deg", camera.fov_deg},
                      {"window", {w.left, w.top, w.right, w.bottom}},
                      {"size", {camera.width, camera.height}}};
  if (camera.parallel_height > 0) json_camera["parallel_height"] = camera.parallel_height;
  return json_camera;
}

std::string mesh_line(const MeshFacts& mesh) {
  return fmt::format(
      "{} triangles, {} vertices; components: {} closed (of {} triangles), {} open (of {}); edges: "
      "{} on a boundary, {} non-manifold",
      mesh.triangles, mesh.vertices, mesh.closed_components, mesh.closed_triangles,
      mesh.open_components, mesh.triangles - mesh.closed_triangles, mesh.boundary_edges,
      mesh.nonmanifold_edges);
}

Json mesh_json(const MeshFacts& mesh) {
  return {{"triangles", mesh.triangles},
          {"vertices", mesh.vertices},
          {"closed_components", mesh.closed_components},
          {"closed_triangles", mesh.closed_triangles},
          {"open_components", mesh.open_components},
          {"boundary_edges", mesh.boundary_edges},
          {"nonmanifold_edges", mesh.nonmanifold_edges}};
}

Json box_json(const Box& box) {
  if (box.is_empty()) return nullptr;
  return {{"lo", json(box.lo)}, {"hi", json(box.hi)}};
}

std::string bytes_text(std::size_t bytes) {
  return bytes < 1000000 ? fmt::format("{:.1f} kB", static_cast<double>(bytes) / 1e3)
                         : fmt::format("{:.1f} MB", static_cast<double>(bytes) / 1e6);
}

void print_meshes(std::string& out, const SceneFacts& facts) {
  if (facts.meshes.empty()) return;
  const auto to = std::back_inserter(out);
  if (facts.meshes.size() > 1)
    fmt::format_to(to, "all meshes    {}: {}\n", facts.meshes.size(), mesh_line(facts.all_meshes));
  constexpr std::size_t most_lines = 20;  // a polygon soup may have thousands
  for (std::size_t i = 0; i < std::min(facts.meshes.size(), most_lines); ++i)
    fmt::format_to(to, "mesh          {}{}{}\n", mesh_line(facts.meshes[i]),
                   facts.meshes[i].has_normals ? "; smooth" : "",
                   facts.meshes[i].is_backdrop ? "; backdrop" : "");
  if (facts.meshes.size() > most_lines)
    fmt::format_to(to, "              and {} more\n", facts.meshes.size() - most_lines);
  const SolidFacts& solids = facts.solids;
  fmt::format_to(to,
                 "solids        {} closed, {} with holes that {} triangles fill: {} triangles, the "
                 "largest {}\n",
                 solids.closed, solids.filled, solids.fills, solids.triangles, solids.largest);
}

Json solids_json(const SolidFacts& solids) {
  return {{"closed", solids.closed},
          {"filled", solids.filled},
          {"fills", solids.fills},
          {"triangles", solids.triangles},
          {"largest", solids.largest}};
}

void add_shapes(SceneFacts& facts, const ShapeSet& shapes) {
  const auto cylinders = static_cast<std::size_t>(
      std::count_if(shapes.cones.begin(), shapes.cones.end(), is_cylinder));
  facts.spheres += shapes.spheres.size();
  facts.cylinders += cylinders;
  facts.cones += shapes.cones.size() - cylinders;
  facts.rings += shapes.rings.size();
  for (const Mesh& mesh : shapes.meshes) {
    facts.meshes.push_back(mesh_facts(mesh));
    add(facts.all_meshes, facts.meshes.back());
  }
}

}  // namespace

SceneFacts scene_facts(const Scene& scene) {
  const ShapeSet& shapes = scene.shapes;
  SceneFacts facts;
  add_shapes(facts, shapes);
  for (const ShapeSet& group : shapes.groups) add_shapes(facts, group);
  facts.primitives = primitive_count(shapes);
  facts.groups = shapes.groups.size();
  facts.instances = shapes.instances.size();
  facts.placed = facts.primitives - own_primitive_count(shapes);
  facts.triangles = facts.all_meshes.triangles;
  facts.solids = solid_facts(scene);
  facts.bounds = bounds(shapes);
  facts.object_bounds = object_bounds(shapes);
  return facts;
}

std::string to_text(const SceneFacts& facts, const Scene& scene) {
  std::string out;
  const auto to = std::back_inserter(out);
  fmt::format_to(to, "scene         {}\n", scene.name);
  fmt::format_to(to,
                 "primitives    {}: {} spheres, {} cylinders, {} cones, {} rings, {} triangles in "
                 "{} meshes\n",
                 facts.primitives, facts.spheres, facts.cylinders, facts.cones, facts.rings,
                 facts.triangles, facts.meshes.size());
  if (facts.instances > 0)
    fmt::format_to(to, "instances     {} of {} groups: {} primitives\n", facts.instances,
                   facts.groups, facts.placed);
  print_meshes(out, facts);
  fmt::format_to(to, "materials     {}, textures {}\n", scene.materials.size(),
                 scene.textures.size());
  for (const Light& light : scene.lights)
    fmt::format_to(to, "light         {}, intensity {}{}{}\n", std::visit(LightText{}, light.shape),
                   text(light.intensity),
                   light.falloff == Falloff::none ? "" : " / distance squared",
                   beam_text(light.beam));
  if (scene.lights.empty())
    fmt::format_to(to, "light         none: render adds a large and a small one\n");
  if (scene.ambient != Color{}) fmt::format_to(to, "ambient       {}\n", text(scene.ambient));
  if (scene.background) fmt::format_to(to, "background    {}\n", text(*scene.background));
  if (scene.ambient != Color{}) fmt::format_to(to, "ambient       {}\n", text(scene.ambient));
  if (scene.background) fmt::format_to(to, "background    {}\n", text(*scene.background));
  if (scene.camera)
    fmt::format_to(to, "camera        from {} at {}, up {}, {}, {}x{}\n", text(scene.camera->from),
                   text(scene.camera->at), text(scene.camera->up), view_text(*scene.camera),
                   scene.camera->width, scene.camera->height);
  else
    fmt::format_to(to, "camera        none: render frames the objects\n");
  fmt::format_to(to, "bounds        {} to {}\n", text(facts.bounds.lo), text(facts.bounds.hi));
  fmt::format_to(to, "extent        {:g} (objects, without floors and walls)\n",
                 facts.object_bounds.largest_extent());
  fmt::format_to(to, "memory        {} for the ray kernel, {} at most in all\n",
                 bytes_text(facts.memory_bytes), bytes_text(facts.peak_rss_bytes));
  fmt::format_to(to, "seconds       {:.3f} to load, {:.3f} to build\n", facts.load_seconds,
                 facts.build_seconds);
  return out;
}

std::string to_json(const SceneFacts& facts, const Scene& scene) {
  Json meshes = Json::array(), lights = Json::array();
  for (const MeshFacts& mesh : facts.meshes) {
    meshes.push_back(mesh_json(mesh));
    meshes.back()["normals"] = mesh.has_normals;
    meshes.back()["backdrop"] = mesh.is_backdrop;
  }
  for (const Light& light : scene.lights) {
    lights.push_back(std::visit(LightJson{}, light.shape));
    lights.back()["intensity"] = json(light.intensity);
    lights.back()["falloff"] = light.falloff == Falloff::none ? "none" : "inverse_square";
    if (light.beam)
      lights.back()["beam"] = {{"axis", json(light.beam->axis)},
                               {"full_deg", angle_deg(light.beam->cos_full)},
                               {"none_deg", angle_deg(light.beam->cos_none)}};
  }
  Json camera = nullptr;
  if (scene.camera) camera = camera_json(*scene.camera);
  const Json all = {
      {"scene", scene.name},
      {"primitives",
       {{"spheres", facts.spheres},
        {"cylinders", facts.cylinders},
        {"cones", facts.cones},
        {"rings", facts.rings},
        {"triangles", facts.triangles},
        {"total", facts.primitives}}},
      {"instances",
       {{"groups", facts.groups}, {"placements", facts.instances}, {"primitives", facts.placed}}},
      {"all_meshes", mesh_json(facts.all_meshes)},
      {"meshes", meshes},
      {"solids", solids_json(facts.solids)},
      {"materials", scene.materials.size()},
      {"textures", scene.textures.size()},
      {"lights", lights},
      {"ambient", json(scene.ambient)},
      {"camera", camera},
      {"bounds", box_json(facts.bounds)},
      {"object_bounds", box_json(facts.object_bounds)},
      {"object_extent", facts.object_bounds.largest_extent()},
      {"memory_bytes", {{"geometry", facts.memory_bytes}}},
      {"peak_rss_bytes", facts.peak_rss_bytes},
      {"seconds", {{"load", facts.load_seconds}, {"build", facts.build_seconds}}}};
  // A name from a file need not be UTF-8.
  return all.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace penumbra
