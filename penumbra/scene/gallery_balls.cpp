// SPDX-License-Identifier: MIT
// "Balls" of Haines' Standard Procedural Databases (A Proposal for Standard Graphics Environments,
// 1987; package version 3.14): each ball carries nine of a third its size.
#include <array>
#include <cmath>
#include <numbers>

#include "penumbra/scene/gallery_scenes.h"
#include "penumbra/scene/nff_material.h"

namespace penumbra::detail {

namespace {

using Children = std::array<Vec3d, 9>;

/// v turned about the unit vector `axis`, by the matrix, summed in the order of x, y and z.
Vec3d turned(Vec3d v, Vec3d axis, double angle_rad) {
  const double c = std::cos(angle_rad), s = std::sin(angle_rad);
  const Vec3d t = axis * (1 - c), a = axis;
  return {(t.x * a.x + c) * v.x + (t.x * a.y - s * a.z) * v.y + (t.x * a.z + s * a.y) * v.z,
          (t.x * a.y + s * a.z) * v.x + (t.y * a.y + c) * v.y + (t.y * a.z - s * a.x) * v.z,
          (t.x * a.z - s * a.y) * v.x + (t.y * a.z + s * a.x) * v.y + (t.z * a.z + c) * v.z};
}

/// Directions of a ball's children where its own direction is +z: three times one above the equator
/// and two on it. They are three neighbours of a close packing, set upright; to make them so, and
/// not from their angles, gives the SPD's own last bits.
Children child_directions() {
  const double r = 1 / std::sqrt(2.0);
  const std::array<Vec3d, 3> neighbours{{{r, r, 0}, {r, 0, -r}, {0, r, -r}}};
  Children directions;
  for (int k = 0; k < 3; ++k)
    for (int i = 0; i < 3; ++i) {
      const Vec3d upright = turned(neighbours[i], {r, -r, 0}, std::asin(2 / std::sqrt(6.0)));
      directions[3 * k + i] = turned(upright, {0, 0, 1}, 2 * std::numbers::pi / 3 * k);
    }
  return directions;
}

/// v under the smallest rotation that takes +z to d.
Vec3d carried(Vec3d v, Vec3d d) {
  constexpr double almost_one = 0.9999;
  if (d.z >= almost_one) return v;
  if (d.z <= -almost_one) return {-v.x, v.y, -v.z};
  const Vec3d axis{-d.y, d.x, 0};
  return turned(v, axis / length(axis), std::acos(d.z));
}

void add_balls(std::vector<Sphere>& spheres, const Children& children, Vec3d center, double radius,
               Vec3d direction, int depth) {
  constexpr std::uint32_t ball_surface = 1;
  spheres.push_back({as_printed(center), as_printed(radius), ball_surface});
  if (depth == 0) return;
  for (Vec3d child : children) {
    const Vec3d d = carried(child, direction);
    add_balls(spheres, children, center + d * (radius * 4 / 3), radius / 3, d, depth - 1);
  }
}

}  // namespace

Scene balls_scene(int n) {
  Scene scene;
  Camera camera;
  camera.from = {2.1, 1.3, 1.7};
  camera.near = 0.01;
  scene.camera = camera;
  scene.background = nff_color({0.078f, 0.361f, 0.753f});
  scene.ambient = {0.1f, 0.1f, 0.1f};
  for (Vec3f center : {Vec3f{4, 3, 2}, Vec3f{1, -4, 4}, Vec3f{-3, 1, 5}})
    scene.lights.push_back(ball_light(center, 0.3f, nff_light_intensity(3)));
  scene.materials = {nff_material({1, 0.75f, 0.33f}, 0.8f, 0, 100000, 0, 1),
                     nff_material({1, 0.9f, 0.7f}, 0.5f, 0.5f, 3.0827f, 0, 1)};
  scene.materials[0].name = "floor";
  scene.materials[1].name = "ball";
  scene.shapes.meshes.push_back(
      backdrop_quad({12, 12, -0.5f}, {-12, 12, -0.5f}, {-12, -12, -0.5f}, {12, -12, -0.5f}, 0));
  add_balls(scene.shapes.spheres, child_directions(), {}, 0.5, {0, 0, 1}, n);
  return scene;
}

}  // namespace penumbra::detail
