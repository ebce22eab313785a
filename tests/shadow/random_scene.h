// SPDX-License-Identifier: MIT
// Small random scenes for fuzzing the methods: all shapes, closed and broken meshes, all lights.
#pragma once

#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "penumbra/geometry/surface_point.h"
#include "penumbra/shadow/visibility.h"
#include "tests/kernel/nasty_shapes.h"
#include "tests/shadow/light_kinds.h"

namespace penumbra::nasty {

struct RandomScene {
  ShapeSet shapes;
  std::vector<LightShape> lights;
  Place place;
};

/// A box, or a ball or torus of facets; sometimes with a face missing.
inline Mesh random_solid(const Place& place, Random& random) {
  Mesh mesh;
  const Vec3f middle = random_point(random);
  const float size = std::pow(10.0f, random.uniform(-1.5f, 0));
  if (random.one_in(2)) {
    const Vec3f half = Vec3f{random.uniform(0.1f, 1), random.uniform(0.1f, 1), 1} * size;
    for (int i = 0; i < 8; ++i)
      mesh.positions.push_back(
          place(middle + Vec3f{i & 1 ? half.x : -half.x, i & 2 ? half.y : -half.y,
                               i & 4 ? half.z : -half.z}));
    mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  } else {  // a torus, whose inner radius may be negative: then it meets itself
    constexpr std::uint32_t n = 8;
    const float tube = size * random.uniform(0.2f, 0.7f), ring = size * random.uniform(0.1f, 1);
    for (std::uint32_t i = 0; i < n; ++i)
      for (std::uint32_t k = 0; k < n; ++k) {
        const float a = 2 * std::numbers::pi_v<float> * static_cast<float>(i) / n;
        const float b = 2 * std::numbers::pi_v<float> * static_cast<float>(k) / n;
        const float r = ring + tube * std::cos(b);
        mesh.positions.push_back(
            place(middle + Vec3f{r * std::cos(a), r * std::sin(a), tube * std::sin(b)}));
        const std::uint32_t i1 = (i + 1) % n, k1 = (k + 1) % n;
        mesh.triangles.push_back({i * n + k, i1 * n + k, i1 * n + k1});
        mesh.triangles.push_back({i * n + k, i1 * n + k1, i * n + k1});
      }
  }
  if (random.one_in(3)) mesh.triangles.erase(mesh.triangles.begin() + random.below(12));
  drop_degenerate_triangles(mesh);
  return mesh;
}

inline RandomScene random_scene(Random& random) {
  RandomScene scene;
  scene.place = random_place(random);
  for (std::uint32_t i = 0, n = 1 + random.below(4); i < n; ++i) {
    const auto kind = static_cast<ShapeKind>(random.below(4));
    ShapeSet some = random_shapes(kind, 1 + random.below(8), scene.place, random);
    ShapeSet& all = scene.shapes;
    all.spheres.insert(all.spheres.end(), some.spheres.begin(), some.spheres.end());
    all.cones.insert(all.cones.end(), some.cones.begin(), some.cones.end());
    all.rings.insert(all.rings.end(), some.rings.begin(), some.rings.end());
    for (Mesh& mesh : some.meshes) {
      drop_degenerate_triangles(mesh);
      all.meshes.push_back(std::move(mesh));
    }
  }
  if (random.one_in(2)) scene.shapes.meshes.push_back(random_solid(scene.place, random));
  for (std::uint32_t i = 0, n = 1 + random.below(3); i < n; ++i) {
    const Vec3f at = scene.place(random_point(random) * random.uniform(0.2f, 4));
    const float size = scene.place.scale * std::pow(10.0f, random.uniform(-3, 0.5f));
    scene.lights.push_back(light_of_kind(light_kinds[random.below(light_kinds.size())], at, size,
                                         scene.place(random.in_cube())));
  }
  return scene;
}

/// A point to ask about: where a random ray hits something, else anywhere.
inline Receiver random_receiver(const RandomScene& scene, const Kernel& kernel, Random& random) {
  const Vec3f from = scene.place(random.in_cube() * 3.0f);
  const Vec3f direction = scene.place(random_point(random)) - from;
  const auto found = kernel.closest({from, direction}).hit;
  if (!found || random.one_in(10))
    return {scene.place(random_point(random)), normalize(random.in_cube())};
  const SurfacePoint point =
      surface_point(scene.shapes, found->shape, Vec3d(from), Vec3d(direction), double(found->t));
  if (random.one_in(4)) return {behind_position(point), -Vec3f(point.normal)};
  return {receiver_position(point), Vec3f(point.normal)};
}

}  // namespace penumbra::nasty
