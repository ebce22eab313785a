// SPDX-License-Identifier: MIT
// Small random scenes for fuzzing the methods: all shapes, closed and broken meshes, all lights.
#pragma once

#include <utility>
#include <vector>

#include "penumbra/geometry/surface_point.h"
#include "penumbra/shadow/visibility.h"
#include "tests/kernel/nasty_instances.h"
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

/// As they are, or as a group that is placed a few times.
inline void add(ShapeSet&& shapes, RandomScene& scene, Random& random) {
  if (random.one_in(3)) make_some_clear(shapes, random);
  if (random.one_in(4) && own_primitive_count(shapes) > 0)
    add_group(std::move(shapes), scene.place, random, scene.shapes);
  else
    append(std::move(shapes), scene.shapes);
}

inline RandomScene random_scene(Random& random) {
  RandomScene scene;
  scene.place = random_place(random);
  for (std::uint32_t i = 0, forms = 1 + random.below(4); i < forms; ++i) {
    const ShapeForm& form = shape_forms[random.below(shape_forms.size())];
    ShapeSet some;
    for (std::uint32_t k = 0, shapes = 1 + random.below(8); k < shapes; ++k)
      append(random_shape(form, scene.place, random), some);
    add(std::move(some), scene, random);
  }
  if (random.one_in(2))
    if (Mesh mesh = nasty_mesh(scene.place, random); !mesh.triangles.empty()) {
      ShapeSet one;
      one.meshes.push_back(std::move(mesh));
      add(std::move(one), scene, random);
    }
  for (std::uint32_t i = 0, lights = 1 + random.below(3); i < lights; ++i) {
    const std::vector<ShapeRef> refs = all_primitives(scene.shapes);
    Vec3f at = scene.place(random_point(random) * random.uniform(0.2f, 4));
    if (!refs.empty() && random.one_in(5))  // in a shape, or next to it
      at = point_of_interest(scene.shapes, refs[random.below(std::uint32_t(refs.size()))], random) +
           random.in_cube() * (scene.place.scale * random.power(-6, 0));
    const double size = double(scene.place.scale * random.power(-3, 0.5f));
    const char* kind = light_kinds[random.below(light_kinds.size())];
    const Vec3f target = scene.place(random.in_cube());
    scene.lights.push_back(make_light(kind, random_figure(random), Vec3d(at), size, target));
  }
  return scene;
}

/// Where a ray hits something, else anywhere.
inline Receiver receiver_on_ray(const RandomScene& scene, const Kernel& kernel, const Ray& ray,
                                Random& random) {
  const auto found = kernel.closest(ray).hit;
  if (!found || random.one_in(10))
    return {scene.place(random_point(random)), normalize(random.in_cube())};
  const SurfacePoint point = surface_point(scene.shapes, found->shape, Vec3d(ray.origin),
                                           Vec3d(ray.direction), double(found->t));
  if (random.one_in(4)) return {behind_position(point), -Vec3f(point.normal)};
  return {receiver_position(point), Vec3f(point.normal)};
}

/// Points to ask about at once: one by one, or as a picture has them, row by row or in Z-order,
/// from pixels far apart to pixels that can't be told apart; sometimes shuffled.
inline std::vector<Receiver> random_receivers(const RandomScene& scene, const Kernel& kernel,
                                              std::uint32_t count, Random& random) {
  std::vector<Receiver> receivers;
  const bool is_picture = !random.one_in(3), is_z_order = random.one_in(2);
  const Vec3f eye = scene.place(random.in_cube() * 3.0f), target = scene.place(random.in_cube());
  const Vec3f u = random.in_cube(), v = random.in_cube();
  const float pixel = scene.place.scale * random.power(-7, -0.5f);
  for (std::uint32_t i = 0; i < count; ++i) {
    Vec3f from = eye, to = target;
    if (is_picture) {
      std::uint32_t x = i % 16, y = i / 16;
      if (is_z_order) {
        x = y = 0;
        for (std::uint32_t bit = 0; bit < 4; ++bit)
          x |= (i >> 2 * bit & 1) << bit, y |= (i >> (2 * bit + 1) & 1) << bit;
      }
      to += u * (pixel * float(x)) + v * (pixel * float(y));
    } else {
      from = scene.place(random.in_cube() * 3.0f), to = scene.place(random_point(random));
    }
    receivers.push_back(receiver_on_ray(scene, kernel, {from, to - from}, random));
  }
  if (random.one_in(4))
    for (std::uint32_t i = count; i > 1; --i)
      std::swap(receivers[i - 1], receivers[random.below(i)]);
  if (random.one_in(4))  // some, or all, look around
    for (Receiver& receiver : receivers)
      if (random.one_in(2)) receiver.normal = {};
  return receivers;
}

}  // namespace penumbra::nasty
