// SPDX-License-Identifier: MIT
#include "penumbra/geometry/shape.h"

namespace penumbra {

std::size_t primitive_count(const ShapeSet& shapes) {
  std::size_t count = shapes.spheres.size() + shapes.cones.size() + shapes.rings.size();
  for (const Mesh& mesh : shapes.meshes) count += mesh.triangles.size();
  return count;
}

std::vector<ShapeRef> all_primitives(const ShapeSet& shapes) {
  std::vector<ShapeRef> refs;
  refs.reserve(primitive_count(shapes));
  const auto add = [&](ShapeKind kind, std::size_t count) {
    for (std::uint32_t i = 0; i < count; ++i) refs.push_back({kind, i, 0, 0});
  };
  add(ShapeKind::sphere, shapes.spheres.size());
  add(ShapeKind::cone, shapes.cones.size());
  add(ShapeKind::ring, shapes.rings.size());
  for (std::uint32_t m = 0; m < shapes.meshes.size(); ++m)
    for (std::uint32_t t = 0; t < shapes.meshes[m].triangles.size(); ++t)
      refs.push_back({ShapeKind::triangle, m, t, 0});
  return refs;
}

namespace {

/// Half extents of a disk of this radius around a (not necessarily unit) normal: r sqrt(1 -
/// n_axis²).
Vec3d disk_extent(Vec3d normal, double radius) {
  const Vec3d n = normalize(normal);
  const auto half = [&](double c) { return radius * std::sqrt(std::max(0.0, 1 - c * c)); };
  return {half(n.x), half(n.y), half(n.z)};
}

}  // namespace

Box bounds(const Sphere& sphere) {
  const Vec3d c(sphere.center), r(sphere.radius, sphere.radius, sphere.radius);
  return outward(c - r, c + r);
}

Box bounds(const Cone& cone) {
  const Vec3d base(cone.base), apex(cone.apex);
  const Vec3d b = disk_extent(apex - base, cone.base_radius),
              a = disk_extent(apex - base, cone.apex_radius);
  return outward(min(base - b, apex - a), max(base + b, apex + a));
}

Box bounds(const Ring& ring) {
  const Vec3d c(ring.center), e = disk_extent(Vec3d(ring.normal), ring.radius);
  return outward(c - e, c + e);
}

Box bounds(const ShapeSet& shapes, ShapeRef ref) {
  switch (ref.kind) {
    case ShapeKind::sphere: return bounds(shapes.spheres[ref.index]);
    case ShapeKind::cone: return bounds(shapes.cones[ref.index]);
    case ShapeKind::ring: return bounds(shapes.rings[ref.index]);
    case ShapeKind::triangle: break;
  }
  Box box;
  const Mesh& mesh = shapes.meshes[ref.index];
  for (std::uint32_t corner : mesh.triangles[ref.triangle]) box.add(mesh.positions[corner]);
  return box;
}

namespace {

enum class Backdrops { with, without };

Box bounds_of_all(const ShapeSet& shapes, Backdrops backdrops) {
  Box box;
  for (const Sphere& sphere : shapes.spheres) box.add(bounds(sphere));
  for (const Cone& cone : shapes.cones) box.add(bounds(cone));
  for (const Ring& ring : shapes.rings) box.add(bounds(ring));
  for (const Mesh& mesh : shapes.meshes)
    if (backdrops == Backdrops::with || !mesh.is_backdrop) box.add(bounds(mesh));
  return box;
}

}  // namespace

Box bounds(const ShapeSet& shapes) { return bounds_of_all(shapes, Backdrops::with); }

Box object_bounds(const ShapeSet& shapes) { return bounds_of_all(shapes, Backdrops::without); }

std::uint32_t surface_of(const ShapeSet& shapes, ShapeRef ref) {
  switch (ref.kind) {
    case ShapeKind::sphere: return shapes.spheres[ref.index].surface;
    case ShapeKind::cone: return shapes.cones[ref.index].surface;
    case ShapeKind::ring: return shapes.rings[ref.index].surface;
    case ShapeKind::triangle: break;
  }
  return surface_of(shapes.meshes[ref.index], ref.triangle);
}

}  // namespace penumbra
