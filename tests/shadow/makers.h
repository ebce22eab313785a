// SPDX-License-Identifier: MIT
// One maker for each form of shape and of light: tests of every pair run over these two lists.
#pragma once

#include <cmath>
#include <vector>

#include "penumbra/geometry/light_shape.h"
#include "penumbra/geometry/shape.h"
#include "tests/kernel/nasty_shapes.h"

namespace penumbra::makers {

using nasty::Place;
using nasty::Random;

/// 10^uniform(lo, hi)
inline float power(Random& random, float lo, float hi) {
  return std::pow(10.0f, random.uniform(lo, hi));
}

struct ShapeMaker {
  const char* name;
  ShapeSet (*make)(const Place& place, Random& random);
};

/// A light around a point, `size` across at most; suns are seen from `from` in the direction of the
/// point, as wide as something of that size there.
struct LightMaker {
  const char* name;
  LightShape (*make)(Vec3f center, float size, Vec3f from, Random& random);
};

inline ShapeSet one_cone(const Place& place, Random& random, bool is_cylinder, bool is_full,
                         Caps caps) {
  ShapeSet shapes;
  const Vec3f a = place(nasty::random_point(random));
  Vec3f b = a;
  while (b == a) b = place(random.in_cube() * 2.0f);
  const float r = place.scale * power(random, -2, 0);
  const float other = is_cylinder ? r : is_full ? 0 : place.scale * power(random, -2, 0);
  shapes.cones.push_back({a, b, r, other, caps, 0});
  if (random.one_in(2)) std::swap(shapes.cones[0].base_radius, shapes.cones[0].apex_radius);
  return shapes;
}

inline ShapeSet one_ring(const Place& place, Random& random, bool has_hole) {
  const float r = place.scale * power(random, -2, 0);
  const Vec3f n = random.one_in(3) ? Vec3f{0, 0, 1} : normalize(random.in_cube());
  ShapeSet shapes;
  shapes.rings.push_back(
      {place(nasty::random_point(random)), n, r, has_hole ? r * random.uniform(0, 1) : 0, 0});
  return shapes;
}

inline ShapeSet one_triangle(const Place& place, Random& random, bool is_sliver) {
  Mesh mesh;
  mesh.triangles = {{0, 1, 2}};
  do {
    const Vec3f a = nasty::random_point(random), b = nasty::random_point(random);
    const Vec3f c =
        is_sliver ? a + (b - a) * random.uniform(-1, 1) + random.in_cube() * power(random, -6, -1)
                  : nasty::random_point(random);
    mesh.positions = {place(a), place(b), place(c)};
    mesh.triangles = {{0, 1, 2}};
    drop_degenerate_triangles(mesh);
  } while (mesh.triangles.empty());
  ShapeSet shapes;
  shapes.meshes.push_back(mesh);
  return shapes;
}

inline const std::vector<ShapeMaker>& shapes() {
  using P = const Place&;
  using R = Random&;
  static const std::vector<ShapeMaker> list{
      {"Sphere",
       [](P p, R r) {
         ShapeSet shapes;
         shapes.spheres.push_back({p(nasty::random_point(r)), p.scale * power(r, -3, 0), 0});
         return shapes;
       }},
      {"CappedCone", [](P p, R r) { return one_cone(p, r, false, false, Caps::capped); }},
      {"OpenCone", [](P p, R r) { return one_cone(p, r, false, false, Caps::open); }},
      {"CappedCylinder", [](P p, R r) { return one_cone(p, r, true, false, Caps::capped); }},
      {"OpenCylinder", [](P p, R r) { return one_cone(p, r, true, false, Caps::open); }},
      {"FullCone", [](P p, R r) { return one_cone(p, r, false, true, Caps::capped); }},
      {"Disk", [](P p, R r) { return one_ring(p, r, false); }},
      {"Ring", [](P p, R r) { return one_ring(p, r, true); }},
      {"Triangle", [](P p, R r) { return one_triangle(p, r, false); }},
      {"Sliver", [](P p, R r) { return one_triangle(p, r, true); }},
  };
  return list;
}

inline const std::vector<LightMaker>& lights() {
  static const std::vector<LightMaker> list{
      {"Point",
       [](Vec3f center, float, Vec3f, Random&) -> LightShape { return PointLight{center}; }},
      {"Ball",
       [](Vec3f center, float size, Vec3f, Random&) -> LightShape {
         return BallLight{center, size / 2};
       }},
      {"Parallelogram",
       [](Vec3f center, float size, Vec3f, Random& random) -> LightShape {
         Vec3f u, v;
         do {
           u = random.in_cube(),
           v = random.one_in(3) ? cross(u, random.in_cube()) : random.in_cube();
         } while (length(cross(normalize(u), normalize(v))) < 1e-3f);
         return ParallelogramLight{center, u * (size / 4), v * (size / 4)};
       }},
      {"Sun",
       [](Vec3f center, float size, Vec3f from, Random&) -> LightShape {
         const Vec3d way = Vec3d(center) - Vec3d(from);
         const Vec3f direction = Vec3f(normalize(way));
         return SunLight{direction == Vec3f{} ? Vec3f{0, 0, 1} : direction,
                         float(std::min(1.5, std::atan2(0.5 * size, length(way))))};
       }},
  };
  return list;
}

}  // namespace penumbra::makers
