// SPDX-License-Identifier: MIT
// Eric Haines' Neutral File Format, by tokens, with our own comments (nff_state.h).
// What the format leaves open: lights without a colour get `nff_light_intensity`, the ambient light
// is 0.1, objects before any `f` are white and matte, polygons are seen and block
// from both sides.
#include <cmath>
#include <cstdlib>

#include "penumbra/geometry/polygon.h"
#include "penumbra/scene/nff_material.h"
#include "penumbra/scene_io/faces.h"
#include "penumbra/scene_io/nff_state.h"
#include "penumbra/scene_io/numbers.h"
#include "penumbra/scene_io/source.h"
#include "penumbra/scene_io/tokens.h"
#include "penumbra/scene_io/weld.h"

namespace penumbra {
namespace {

struct Reader {
  Tokens tokens;
  Warnings& warnings;
  NffState state;
};

Vec3f read_vector(Tokens& tokens, std::string_view what) {
  const float x = tokens.number(what), y = tokens.number(what), z = tokens.number(what);
  return {x, y, z};
}

Vec3d read_vector_double(Tokens& tokens, std::string_view what) {
  const double x = tokens.number_double(what), y = tokens.number_double(what),
               z = tokens.number_double(what);
  return {x, y, z};
}

/// A number that must not be below 0; one that is becomes 0, with a warning.
float read_positive(Reader& reader, std::string_view what) {
  const std::size_t line = reader.tokens.peek().line;
  const float value = reader.tokens.number(what);
  if (value >= 0) return value;
  reader.warnings.add(std::string(what) + " below 0 is taken as 0", line);
  return 0;
}

Color read_display_color(Reader& reader) {
  const float r = read_positive(reader, "a colour"), g = read_positive(reader, "a colour"),
              b = read_positive(reader, "a colour");
  return {r, g, b};
}

std::uint32_t read_resolution(Tokens& tokens) {
  const Token token = tokens.peek();
  const double value = tokens.number_double("a resolution");
  if (!(value >= 1 && value <= 65536 && value == std::floor(value)))
    throw Error(tokens.place(token),
                "a resolution of " + in_quotes(token.text) + " makes no picture",
                "give whole numbers from 1 to 65536");
  return static_cast<std::uint32_t>(value);
}

void check_camera(const Camera& camera, const Tokens& tokens, const Token& view) {
  if (camera.from == camera.at)
    throw Error(tokens.place(view), "the view looks from a point at the same point",
                "move `from` or `at`");
  if (!(camera.fov_deg > 0 && camera.fov_deg < 180))
    throw Error(tokens.place(view), "the view's angle is not between 0 and 180 degrees");
  if (cross(camera.at - camera.from, camera.up) == Vec3d{})
    throw Error(tokens.place(view), "the view's `up` is 0 or along its line of sight",
                "give another direction");
}

void read_view(Reader& reader, const Token& view) {
  Tokens& tokens = reader.tokens;
  Camera camera;
  bool has_from = false, has_at = false;
  for (;;) {
    const std::string_view key = tokens.peek().text;
    if (key != "from" && key != "at" && key != "up" && key != "angle" && key != "hither" &&
        key != "resolution")
      break;
    tokens.next();
    if (key == "from")
      camera.from = read_vector_double(tokens, "a point to look from"), has_from = true;
    if (key == "at") camera.at = read_vector_double(tokens, "a point to look at"), has_at = true;
    if (key == "up") camera.up = read_vector_double(tokens, "a direction");
    if (key == "angle") camera.fov_deg = tokens.number_double("an angle");
    if (key == "hither") camera.near = std::max(0.0, tokens.number_double("a distance"));
    if (key == "resolution") {
      camera.width = read_resolution(tokens);
      camera.height = read_resolution(tokens);
    }
  }
  if (!has_from || !has_at) tokens.fail(tokens.peek(), has_from ? "`at`" : "`from`");
  check_camera(camera, tokens, view);
  if (reader.state.scene.camera) reader.warnings.add("a second view replaces the first", view.line);
  reader.state.scene.camera = camera;
}

bool is_number(const Token& token) { return parse_double(token.text).has_value(); }

void read_light(Reader& reader) {
  const Vec3f position = read_vector(reader.tokens, "a light's position");
  const bool has_color = is_number(reader.tokens.peek());
  const Color color = has_color ? nff_color(read_display_color(reader)) : Color{};
  reader.state.scene.lights.push_back({PointLight{position}, color, Falloff::none});
  reader.state.light_has_intensity.push_back(has_color);
}

void read_fill(Reader& reader) {
  // Also where nothing is drawn with it: a file may list its materials first.
  if (!reader.state.surface && reader.state.has_fill) current_surface(reader.state);
  const Color color = read_display_color(reader);
  const float kd = read_positive(reader, "Kd"), ks = read_positive(reader, "Ks"),
              shine = read_positive(reader, "Shine"), t = read_positive(reader, "T");
  const float ior = read_positive(reader, "an index of refraction");
  reader.state.material = nff_material(color, kd, ks, shine, t, ior > 0 ? ior : 1);
  reader.state.surface.reset();
  reader.state.has_fill = true;
}

float read_radius(Reader& reader, std::string_view what) {
  const std::size_t line = reader.tokens.peek().line;
  const float radius = reader.tokens.number(what);
  if (radius < 0)
    reader.warnings.add(
        "a negative radius (only the inside is to be seen) is drawn from both sides", line);
  return std::abs(radius);
}

void read_sphere(Reader& reader, const Token& keyword) {
  Sphere sphere;
  sphere.center = read_vector(reader.tokens, "a sphere's centre");
  sphere.radius = read_radius(reader, "a sphere's radius");
  sphere.surface = current_surface(reader.state);
  if (sphere.radius > 0) return reader.state.scene.shapes.spheres.push_back(sphere);
  reader.warnings.add("a sphere of radius 0 is left out", keyword.line);
}

/// A `c` whose centres are equal: flat, between its two radii.
void add_ring(Reader& reader, const Token& keyword, const Cone& cone) {
  if (cone.base_radius == cone.apex_radius)
    return reader.warnings.add("a cone without height and width is left out", keyword.line);
  Ring ring;
  ring.center = cone.base;
  ring.radius = std::max(cone.base_radius, cone.apex_radius);
  ring.inner_radius = std::min(cone.base_radius, cone.apex_radius);
  ring.surface = cone.surface;
  if (reader.state.next_ring_normal)
    ring.normal = *reader.state.next_ring_normal;
  else
    reader.warnings.add("a cone without height is a ring, drawn facing z", keyword.line);
  reader.state.scene.shapes.rings.push_back(ring);
}

void read_cone(Reader& reader, const Token& keyword) {
  Cone cone;
  cone.base = read_vector(reader.tokens, "a cone's base");
  cone.base_radius = read_radius(reader, "a cone's base radius");
  cone.apex = read_vector(reader.tokens, "a cone's apex");
  cone.apex_radius = read_radius(reader, "a cone's apex radius");
  cone.caps = reader.state.next_caps;
  cone.surface = current_surface(reader.state);
  if (cone.base == cone.apex)
    add_ring(reader, keyword, cone);
  else if (cone.base_radius > 0 || cone.apex_radius > 0)
    reader.state.scene.shapes.cones.push_back(cone);
  else
    reader.warnings.add("a cone of radius 0 is left out", keyword.line);
  reader.state.next_caps = Caps::open;
  reader.state.next_ring_normal.reset();
}

/// The mesh that the next polygon belongs to.
Mesh& target_mesh(NffState& state, bool has_normals) {
  std::vector<Mesh>& meshes = state.scene.shapes.meshes;
  std::size_t& current = has_normals ? state.smooth_mesh : state.flat_mesh;
  if (state.next_is_backdrop || current == NffState::none) {
    if (!state.next_is_backdrop) current = meshes.size();
    meshes.emplace_back().is_backdrop = state.next_is_backdrop || state.mesh_is_backdrop;
    state.next_is_backdrop = false;
    return meshes.back();
  }
  return meshes[current];
}

void read_polygon(Reader& reader, bool has_normals) {
  Tokens& tokens = reader.tokens;
  const Token token = tokens.peek();
  const std::int64_t count = tokens.integer("a number of corners");
  if (count < 3)
    throw Error(tokens.place(token), "a polygon of " + std::to_string(count) + " corners",
                "give 3 or more");
  // A number takes two bytes or more, the separator included.
  const std::int64_t bytes_each = has_normals ? 12 : 6;
  if (count > (static_cast<std::int64_t>(tokens.remaining()) + 1) / bytes_each)
    throw Error(tokens.place(token),
                "a polygon claims " + std::to_string(count) + " corners, but only " +
                    std::to_string(tokens.remaining()) + " bytes follow",
                "the file may be cut off");
  std::vector<Vec3f> corners, normals;
  for (std::int64_t i = 0; i < count; ++i) {
    corners.push_back(read_vector(tokens, "a corner's coordinate"));
    if (has_normals) normals.push_back(read_vector(tokens, "a normal's coordinate"));
  }
  const std::uint32_t surface = current_surface(reader.state);
  Mesh& mesh = target_mesh(reader.state, has_normals);
  const auto base = static_cast<std::uint32_t>(mesh.positions.size());
  check_vertex_count(tokens.place(token), mesh.positions.size() + corners.size());
  mesh.positions.insert(mesh.positions.end(), corners.begin(), corners.end());
  mesh.normals.insert(mesh.normals.end(), normals.begin(), normals.end());
  // A triangle stays as it is, so that a degenerate one is counted when it is dropped.
  const std::vector<Triangle> triangles =
      count == 3 ? std::vector<Triangle>{{0, 1, 2}} : triangulate(corners);
  for (const Triangle& t : triangles) {
    mesh.triangles.push_back({base + t[0], base + t[1], base + t[2]});
    mesh.surfaces.push_back(surface);
  }
}

void read_entity(Reader& reader, const Token& keyword) {
  const std::string_view word = keyword.text;
  if (word == "v") return read_view(reader, keyword);
  if (word == "b") {
    reader.state.scene.background = nff_color(read_display_color(reader));
    return;
  }
  if (word == "l") return read_light(reader);
  if (word == "f") return read_fill(reader);
  if (word == "c") return read_cone(reader, keyword);
  if (word == "s") return read_sphere(reader, keyword);
  if (word == "p" || word == "pp") return read_polygon(reader, word == "pp");
  throw Error(reader.tokens.place(keyword), "unknown keyword " + in_quotes(word),
              "NFF knows v, b, l, f, c, s, p and pp");
}

/// Where the view is upright along an axis, that axis is up; else z stays it.
void take_up_from_view(Scene& scene) {
  const Vec3d up = normalize(scene.camera->up);
  for (int axis = 0; axis < 3; ++axis)
    if (std::abs(up[axis]) == 1) scene.up = up;
}

void finish(NffState& state) {
  if (state.has_fill) current_surface(state);
  Scene& scene = state.scene;
  if (scene.camera && !state.has_up) take_up_from_view(scene);
  const float shared = nff_light_intensity(scene.lights.size());
  for (std::size_t i = 0; i < scene.lights.size(); ++i)
    if (!state.light_has_intensity[i]) scene.lights[i].intensity = {shared, shared, shared};
  for (Mesh& mesh : scene.shapes.meshes) {
    weld(mesh);
    const auto differs = [&](std::uint32_t surface) { return surface != mesh.surfaces[0]; };
    if (mesh.surfaces.empty() || std::any_of(mesh.surfaces.begin(), mesh.surfaces.end(), differs))
      continue;
    mesh.surface = mesh.surfaces[0];
    mesh.surfaces.clear();
  }
}

}  // namespace

Scene read_nff(const Source& source, Warnings& warnings) {
  Reader reader{{source.path.string(), source.bytes, Comments::hash}, warnings, {}};
  Tokens& tokens = reader.tokens;
  reader.state.scene.ambient = {0.1f, 0.1f, 0.1f};
  reader.state.scene.background = Color{};
  reader.state.material = nff_material({1, 1, 1}, 1, 0, 100000, 0, 1);
  for (;;) {
    const Token keyword = tokens.next();
    for (const Token& directive : tokens.take_directives())
      apply_directive(reader.state, directive, tokens.file(), warnings);
    if (keyword.text.empty()) break;
    read_entity(reader, keyword);
  }
  finish(reader.state);
  return std::move(reader.state.scene);
}

}  // namespace penumbra
