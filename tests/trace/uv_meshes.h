// SPDX-License-Identifier: MIT
// Meshes with texture coordinates, and scenes to bake.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

#include "penumbra/scene/complete_scene.h"
#include "penumbra/scene/image.h"
#include "penumbra/scene/material.h"
#include "penumbra/scene/scene.h"

namespace penumbra {

/// The square [0, 4]^2 at z = 0, facing up, which fills [lo, hi]^2 of its texture; u is x, v is y.
inline Mesh floor_mesh(float lo = 0, float hi = 1) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}};
  mesh.uvs = {{lo, lo}, {hi, lo}, {hi, hi}, {lo, hi}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

/// The side of a cylinder of radius 1 around z, 0 <= z <= 2, cut open along +x: u goes around.
inline Mesh tube_mesh(std::uint32_t segments, float lo, float hi) {
  Mesh mesh;
  for (std::uint32_t i = 0; i <= segments; ++i) {
    const double share = double(i) / segments, angle = 2 * std::numbers::pi * share;
    // The seam's ends are the same points, to the bit.
    const double x = i == segments ? 1 : std::cos(angle), y = i == segments ? 0 : std::sin(angle);
    for (const float z : {0.0f, 2.0f}) {
      mesh.positions.push_back({static_cast<float>(x), static_cast<float>(y), z});
      mesh.uvs.push_back({lo + (hi - lo) * static_cast<float>(share), z == 0 ? lo : hi});
    }
  }
  for (std::uint32_t i = 0; i < segments; ++i) {
    const std::uint32_t a = 2 * i;
    mesh.triangles.push_back({a, a + 2, a + 3});
    mesh.triangles.push_back({a, a + 3, a + 1});
  }
  return mesh;
}

/// These meshes, a ball that throws a shadow, and a light; complete.
inline Scene scene_to_bake(std::vector<Mesh> meshes, Sphere ball, LightShape light) {
  Scene scene;
  scene.shapes.meshes = std::move(meshes);
  scene.shapes.spheres.push_back(ball);
  scene.lights.push_back({std::move(light)});
  return complete_scene(std::move(scene), {});
}

/// A ball over the quarter of the floor that is near its origin, under a ball light.
inline Scene floor_scene(float lo = 0, float hi = 1) {
  return scene_to_bake({floor_mesh(lo, hi)}, {{1, 1, 1}, 0.5f}, BallLight{{1, 1, 5}, 0.6f});
}

/// A plane of a picture as what materials look up, bilinearly.
inline Texture texture_of(const Image& image, const char* channel) {
  Texture texture;
  texture.width = image.width, texture.height = image.height;
  for (const float value : find_channel(image, channel)->values)
    texture.pixels.push_back({value, value, value});
  return texture;
}

}  // namespace penumbra
