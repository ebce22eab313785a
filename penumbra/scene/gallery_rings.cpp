// SPDX-License-Identifier: MIT
// "Rings" of Haines' Standard Procedural Databases (A Proposal for Standard Graphics Environments,
// 1987; package version 3.14): each object is six pentagons, interlocked.
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "penumbra/scene/gallery_scenes.h"
#include "penumbra/scene/nff_material.h"

namespace penumbra::detail {

namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double tube_radius = 0.07412;
constexpr int pentagons = 6;
constexpr int corners = 5;

using Pentagon = std::array<Vec3d, corners>;

/// Pentagon 0 lies flat; the others are tilted about x, then spread about z.
Pentagon pentagon(int number) {
  const double size = 1 / (1 + tube_radius);
  const double tilt = 2 * std::acos(std::cos(60 * degree) / std::sin(36 * degree));
  const double turn = (36 + 72 * (number - 1)) * degree;
  Pentagon points;
  for (int k = 0; k < corners; ++k) {
    Vec3d p{size * std::cos(72 * k * degree), size * std::sin(72 * k * degree), 0};
    if (number > 0) {
      p = {p.x, p.y * std::cos(tilt), p.y * std::sin(tilt)};
      p = {p.x * std::cos(turn) - p.y * std::sin(turn), p.x * std::sin(turn) + p.y * std::cos(turn),
           p.z};
    }
    points[k] = p;
  }
  return points;
}

void add_object(ShapeSet& shapes, Vec3d center) {
  const float radius = as_printed(tube_radius);
  for (int j = 0; j < pentagons; ++j) {
    const auto surface = static_cast<std::uint32_t>(j + 1);
    const Pentagon points = pentagon(j);
    for (int k = 0; k < corners; ++k) {
      const Vec3f here = as_printed(center + points[k]);
      const Vec3f previous = as_printed(center + points[(k + corners - 1) % corners]);
      shapes.cones.push_back({here, previous, radius, radius, Caps::open, surface});
      shapes.spheres.push_back({here, radius, surface});
    }
  }
}

void add_materials(std::vector<Material>& materials) {
  constexpr std::array<Color, pentagons> colors{
      {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 1, 1}, {1, 0, 1}, {1, 1, 0}}};
  materials.push_back(nff_material({1, 1, 1}, 1, 0, 100000, 0, 0));
  materials.back().name = "backdrop";
  for (int j = 0; j < pentagons; ++j) {
    materials.push_back(nff_material(colors[j], 0.5f, 0.2f, 3.0827f, 0, 0));
    materials.back().name = "pentagon" + std::to_string(j);
  }
}

}  // namespace

Scene rings_scene(int n) {
  const double spacing = 1 / std::sin(22.5 * degree);
  const float eye_y = as_printed(-spacing);
  Scene scene;
  Camera camera;
  camera.from = {-1, eye_y, 0.5};
  camera.at = {-1, as_printed(1 - spacing), 0.5};
  camera.near = 1;
  scene.camera = camera;
  scene.background = nff_color({0.078f, 0.361f, 0.753f});
  scene.ambient = {0.1f, 0.1f, 0.1f};
  for (Vec3f center : {Vec3f{3, eye_y, 3}, Vec3f{-4, eye_y, 1}, Vec3f{2, eye_y, -4}})
    scene.lights.push_back(ball_light(center, 0.3f, nff_light_intensity(3)));
  add_materials(scene.materials);

  const double wall = spacing * (n + 1);
  const double half = 1.01 * (wall + spacing) * std::tan(22.5 * degree);
  scene.shapes.meshes.push_back(backdrop_quad(as_printed(Vec3d{half - 1, wall, half + 0.5}),
                                              as_printed(Vec3d{-half - 1, wall, half + 0.5}),
                                              as_printed(Vec3d{-half - 1, wall, -half + 0.5}),
                                              as_printed(Vec3d{half - 1, wall, -half + 0.5}), 0));
  for (int layer = 0; layer < n; ++layer)
    for (int iz = 0; iz <= layer; ++iz)
      for (int ix = 0; ix <= layer; ++ix)
        add_object(scene.shapes, {2.0 * ix - layer, spacing * (layer + 1), 2.0 * iz - layer});
  return scene;
}

}  // namespace penumbra::detail
