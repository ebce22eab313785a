// SPDX-License-Identifier: MIT
#include "penumbra/scene/gallery.h"

#include <charconv>

#include <fmt/format.h>

#include "penumbra/scene/error.h"
#include "penumbra/scene/gallery_scenes.h"

namespace penumbra {

namespace {

/// The N of "name:N" in [1, most]; `usual` when there is none.
int size_factor(std::string_view name, std::string_view digits, int usual, int most) {
  if (digits.data() == nullptr) return usual;
  int n = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), n);
  if (error != std::errc{} || end != digits.data() + digits.size() || n < 1 || n > most)
    throw Error({}, fmt::format("{}:{} is no built-in scene", name, digits),
                fmt::format("use {}:1 to {}:{}", name, name, most));
  return n;
}

std::optional<Scene> make(std::string_view name) {
  const std::size_t colon = name.find(':');
  const std::string_view base = name.substr(0, colon);
  const bool has_factor = colon != std::string_view::npos;
  const std::string_view factor = has_factor ? name.substr(colon + 1) : std::string_view{};
  if (base == "balls") return detail::balls_scene(size_factor(base, factor, 4, 6));
  if (base == "rings") return detail::rings_scene(size_factor(base, factor, 1, 7));
  if (name == "cylinders") return detail::cylinders_scene();
  if (name == "molecule") return detail::molecule_scene();
  if (name == "bust") return detail::bust_scene();
  return std::nullopt;
}

}  // namespace

std::optional<Scene> gallery_scene(std::string_view name) {
  std::optional<Scene> scene = make(name);
  if (scene) {
    scene->name = name;
    validate(*scene);
  }
  return scene;
}

std::vector<GalleryEntry> gallery_help() {
  return {
      {"balls:N",
       "sphereflake of (9^(N+1) - 1) / 8 mirroring balls on a floor, N from 1 to 6; balls "
       "is balls:4"},
      {"rings:N",
       "interlocked rings of balls and cylinders, N layers, N from 1 to 7; rings is rings:1"},
      {"cylinders", "nine cylinders on a floor, two lights"},
      {"molecule", "a turn and more of B-DNA as balls and sticks"},
      {"bust", "a closed mesh of about 98,500 triangles: head and shoulders on a plinth"},
  };
}

namespace detail {

float as_printed(double value) {
  const std::string digits = fmt::format("{:.6g}", value);
  float read_back = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), read_back);
  return read_back;
}

Vec3f as_printed(Vec3d p) { return {as_printed(p.x), as_printed(p.y), as_printed(p.z)}; }

Mesh backdrop_quad(Vec3f a, Vec3f b, Vec3f c, Vec3f d, std::uint32_t surface) {
  Mesh mesh;
  mesh.positions = {a, b, c, d};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  mesh.surface = surface;
  mesh.is_backdrop = true;
  return mesh;
}

Light ball_light(Vec3f center, float radius, float intensity) {
  return {BallLight{center, radius}, {intensity, intensity, intensity}, Falloff::none};
}

Material matte(std::string name, Color diffuse) {
  Material material;
  material.name = std::move(name);
  material.diffuse = diffuse;
  return material;
}

}  // namespace detail

}  // namespace penumbra
