// SPDX-License-Identifier: MIT
#include "penumbra/geometry/shape.h"

#include <algorithm>

#include "penumbra/geometry/placed_shape.h"

namespace penumbra {

std::size_t own_primitive_count(const ShapeSet& shapes) {
  std::size_t count = shapes.spheres.size() + shapes.cones.size() + shapes.rings.size();
  for (const Mesh& mesh : shapes.meshes) count += mesh.triangles.size();
  return count;
}

std::size_t primitive_count(const ShapeSet& shapes) {
  std::vector<std::size_t> of_group;
  for (const ShapeSet& group : shapes.groups) of_group.push_back(own_primitive_count(group));
  std::size_t count = own_primitive_count(shapes);
  for (const Instance& instance : shapes.instances) count += of_group[instance.group];
  return count;
}

std::vector<ShapeRef> all_primitives(const ShapeSet& shapes) {
  std::vector<ShapeRef> refs;
  refs.reserve(own_primitive_count(shapes));
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
  if (ref.kind == ShapeKind::triangle) {
    Box box;
    for (const Vec3f corner : corners(shapes, ref)) box.add(corner);
    return box;
  }
  const auto box_of = [&](const auto& shape) {
    if (ref.instance == 0) return bounds(shape);
    const Transform& map = shapes.instances[ref.instance - 1].placement;
    return bounds(placed(shape, map, similarity_scale(map)));
  };
  const ShapeSet& home = home_of(shapes, ref);
  return ref.kind == ShapeKind::sphere ? box_of(home.spheres[ref.index])
         : ref.kind == ShapeKind::cone ? box_of(home.cones[ref.index])
                                       : box_of(home.rings[ref.index]);
}

namespace {

enum class Backdrops { with, without };

Box bounds_of_own(const ShapeSet& shapes, Backdrops backdrops) {
  Box box;
  for (const Sphere& sphere : shapes.spheres) box.add(bounds(sphere));
  for (const Cone& cone : shapes.cones) box.add(bounds(cone));
  for (const Ring& ring : shapes.rings) box.add(bounds(ring));
  for (const Mesh& mesh : shapes.meshes)
    if (backdrops == Backdrops::with || !mesh.is_backdrop) box.add(bounds(mesh));
  return box;
}

/// The box of what is placed, shape by shape.
Box bounds_of_placed(const ShapeSet& group, const Transform& map, Backdrops backdrops) {
  const double scale = similarity_scale(map);
  Box box;
  for (const Sphere& sphere : group.spheres) box.add(bounds(placed(sphere, map, scale)));
  for (const Cone& cone : group.cones) box.add(bounds(placed(cone, map, scale)));
  for (const Ring& ring : group.rings) box.add(bounds(placed(ring, map, scale)));
  for (const Mesh& mesh : group.meshes)
    if (backdrops == Backdrops::with || !mesh.is_backdrop)
      for (const Triangle& triangle : mesh.triangles)
        for (const std::uint32_t corner : triangle)
          box.add(Vec3f(apply_point(map, Vec3d(mesh.positions[corner]))));
  return box;
}

/// So many primitives are placed to know a box exactly: half a second.
constexpr std::size_t most_looked_at = std::size_t{1} << 24;

/// Those that reach farthest first: most others lie within what is known by then.
Box bounds_of_all(const ShapeSet& shapes, Backdrops backdrops) {
  Box box = bounds_of_own(shapes, backdrops);
  std::vector<Box> of_group;
  for (const ShapeSet& group : shapes.groups) of_group.push_back(bounds_of_own(group, backdrops));
  struct Loose {
    Box box;
    const Instance* instance;
  };
  std::vector<Loose> loose;
  Box all;
  for (const Instance& instance : shapes.instances) {
    loose.push_back({placed(of_group[instance.group], instance.placement), &instance});
    all.add(loose.back().box);
  }
  const auto reach = [middle = all.center()](const Loose& l) {
    return l.box.is_empty() ? 0 : std::max(max_abs(l.box.lo - middle), max_abs(l.box.hi - middle));
  };
  std::stable_sort(loose.begin(), loose.end(),
                   [&](const Loose& a, const Loose& b) { return reach(a) > reach(b); });
  std::size_t looked_at = 0;
  for (const Loose& l : loose) {
    if (l.box.is_empty() || box.contains(l.box)) continue;
    const ShapeSet& group = shapes.groups[l.instance->group];
    looked_at += own_primitive_count(group);
    box.add(looked_at <= most_looked_at ? bounds_of_placed(group, l.instance->placement, backdrops)
                                        : l.box);
  }
  return box;
}

}  // namespace

Box bounds(const ShapeSet& shapes) { return bounds_of_all(shapes, Backdrops::with); }

Box object_bounds(const ShapeSet& shapes) { return bounds_of_all(shapes, Backdrops::without); }

std::uint32_t surface_of(const ShapeSet& shapes, ShapeRef ref) {
  const ShapeSet& home = home_of(shapes, ref);
  switch (ref.kind) {
    case ShapeKind::sphere: return home.spheres[ref.index].surface;
    case ShapeKind::cone: return home.cones[ref.index].surface;
    case ShapeKind::ring: return home.rings[ref.index].surface;
    case ShapeKind::triangle: break;
  }
  return surface_of(home.meshes[ref.index], ref.triangle);
}

}  // namespace penumbra
