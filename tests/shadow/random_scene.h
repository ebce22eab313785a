// SPDX-License-Identifier: MIT
// Small random scenes for fuzzing the methods: all shapes, closed and broken meshes, all lights.
#pragma once

#include <utility>
#include <vector>

#include "penumbra/geometry/surface_point.h"
#include "penumbra/shadow/visibility.h"
#include "tests/shadow/light_kinds.h"
#include "tests/shadow/nasty_meshes.h"
#include "tests/shadow/shape_forms.h"

namespace penumbra::nasty {

struct RandomScene {
  ShapeSet shapes;  ///< surface 1 casts no shadow
  KernelOptions options{KernelKind::wide, {false, true}};
  std::vector<LightShape> lights;
  Place place;
};

inline void append(ShapeSet&& from, ShapeSet& to) {
  to.spheres.insert(to.spheres.end(), from.spheres.begin(), from.spheres.end());
  to.cones.insert(to.cones.end(), from.cones.begin(), from.cones.end());
  to.rings.insert(to.rings.end(), from.rings.begin(), from.rings.end());
  for (Mesh& mesh : from.meshes) to.meshes.push_back(std::move(mesh));
}

/// Some shapes, and some triangles of meshes, cast no shadow.
inline void make_some_clear(ShapeSet& shapes, Random& random) {
  const auto clear = [&] { return random.one_in(8) ? 1u : 0u; };
  for (Sphere& sphere : shapes.spheres) sphere.surface = clear();
  for (Cone& cone : shapes.cones) cone.surface = clear();
  for (Ring& ring : shapes.rings) ring.surface = clear();
  for (Mesh& mesh : shapes.meshes)
    if (random.one_in(3))
      for (std::size_t t = 0; t < mesh.triangles.size(); ++t) mesh.surfaces.push_back(clear());
}

inline RandomScene random_scene(Random& random) {
  RandomScene scene;
  scene.place = random_place(random);
  for (std::uint32_t i = 0, forms = 1 + random.below(4); i < forms; ++i) {
    const ShapeForm& form = shape_forms[random.below(shape_forms.size())];
    for (std::uint32_t k = 0, shapes = 1 + random.below(8); k < shapes; ++k)
      append(random_shape(form, scene.place, random), scene.shapes);
  }
  if (random.one_in(2))
    if (Mesh mesh = nasty_mesh(scene.place, random); !mesh.triangles.empty())
      scene.shapes.meshes.push_back(std::move(mesh));
  if (random.one_in(3)) make_some_clear(scene.shapes, random);
  for (std::uint32_t i = 0, lights = 1 + random.below(3); i < lights; ++i) {
    const Vec3f at = scene.place(random_point(random) * random.uniform(0.2f, 4));
    const double size = double(scene.place.scale * random.power(-3, 0.5f));
    const char* kind = light_kinds[random.below(light_kinds.size())];
    const Vec3f target = scene.place(random.in_cube());
    scene.lights.push_back(make_light(kind, random_form(random), Vec3d(at), size, target));
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
