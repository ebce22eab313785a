// SPDX-License-Identifier: MIT
// A simple test scene of eleven objects: nine cylinders on a floor of two triangles, two lights.
#include "penumbra/scene/gallery_scenes.h"

namespace penumbra::detail {

namespace {

enum Surface : std::uint32_t { floor_surface, terracotta, teal, ochre, ivory };

/// Stands upright on the floor.
Cone column(float x, float y, float height, float radius, Surface surface) {
  return {{x, y, 0}, {x, y, height}, radius, radius, Caps::capped, surface};
}

Material glossy(std::string name, Color diffuse) {
  Material material = matte(std::move(name), diffuse);
  material.highlight = {0.25f, 0.25f, 0.25f};
  material.shininess = 40;
  return material;
}

}  // namespace

Scene cylinders_scene() {
  Scene scene;
  Camera camera;
  camera.from = {1.6, -8.6, 4.9};
  camera.at = {0, 0.15, 0.75};
  camera.fov_deg = 36;
  scene.camera = camera;
  scene.background = Color{0.55f, 0.62f, 0.72f};
  scene.ambient = {0.14f, 0.14f, 0.15f};
  scene.lights = {ball_light({-5.5f, -4.5f, 7.5f}, 0.55f, 0.62f),
                  ball_light({5, -3.5f, 5.5f}, 0.3f, 0.3f)};
  scene.materials = {matte("floor", {0.58f, 0.56f, 0.52f}),
                     glossy("terracotta", {0.58f, 0.19f, 0.1f}),
                     glossy("teal", {0.06f, 0.3f, 0.34f}), glossy("ochre", {0.64f, 0.4f, 0.09f}),
                     glossy("ivory", {0.72f, 0.68f, 0.58f})};

  ShapeSet& shapes = scene.shapes;
  shapes.cones = {
      column(-1.75f, 1.1f, 2.5f, 0.36f, ivory),
      column(-0.55f, 1.75f, 3.1f, 0.36f, terracotta),
      column(0.85f, 1.6f, 2.1f, 0.36f, teal),
      column(2.05f, 0.85f, 1.4f, 0.36f, ochre),
      column(-0.15f, 0.1f, 0.5f, 0.85f, ivory),
      // On the drum
      column(-0.15f, 0.1f, 1.35f, 0.3f, teal),
  };
  shapes.cones.back().base.z = 0.5f;
  // An open tube that lies on the floor, and two rods that lean on drum and column.
  shapes.cones.push_back(
      {{0.95f, -1.55f, 0.42f}, {2.35f, -0.75f, 0.42f}, 0.42f, 0.42f, Caps::open, terracotta});
  shapes.cones.push_back(
      {{-2.35f, -1.5f, 0.11f}, {-0.62f, -0.42f, 0.62f}, 0.1f, 0.1f, Caps::capped, ochre});
  shapes.cones.push_back(
      {{-2.75f, -0.2f, 0.1f}, {-1.98f, 0.72f, 2.3f}, 0.1f, 0.1f, Caps::capped, teal});
  shapes.meshes.push_back(
      backdrop_quad({-60, -60, 0}, {60, -60, 0}, {60, 60, 0}, {-60, 60, 0}, floor_surface));
  return scene;
}

}  // namespace penumbra::detail
