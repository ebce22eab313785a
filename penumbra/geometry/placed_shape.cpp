// SPDX-License-Identifier: MIT
#include "penumbra/geometry/placed_shape.h"

#include <algorithm>
#include <cmath>

namespace penumbra {

double similarity_scale(const Transform& map) {
  const double square =
      (length_squared(map.x_axis) + length_squared(map.y_axis) + length_squared(map.z_axis)) / 3;
  constexpr double tolerance = 0x1p-22;
  const auto is_off = [&](Vec3d a, Vec3d b, double expected) {
    return !(std::abs(dot(a, b) - expected) <= tolerance * square);
  };
  if (!(square > 0) || is_off(map.x_axis, map.x_axis, square) ||
      is_off(map.y_axis, map.y_axis, square) || is_off(map.z_axis, map.z_axis, square) ||
      is_off(map.x_axis, map.y_axis, 0) || is_off(map.y_axis, map.z_axis, 0) ||
      is_off(map.z_axis, map.x_axis, 0))
    return 0;
  return std::sqrt(square);
}

Transform nearest_similarity(const Transform& map) {
  const double volume = determinant(map), scale = std::cbrt(std::abs(volume));
  const Vec3d x = normalize(map.x_axis);
  const Vec3d y = normalize(map.y_axis - x * dot(map.y_axis, x));
  const Vec3d z = cross(x, y) * (volume < 0 ? -1.0 : 1.0);
  return {x * scale, y * scale, z * scale, map.offset};
}

Sphere placed(const Sphere& sphere, const Transform& map, double scale) {
  return {Vec3f(apply_point(map, Vec3d(sphere.center))), static_cast<float>(sphere.radius * scale),
          sphere.surface};
}

Cone placed(const Cone& cone, const Transform& map, double scale) {
  return {Vec3f(apply_point(map, Vec3d(cone.base))),
          Vec3f(apply_point(map, Vec3d(cone.apex))),
          static_cast<float>(cone.base_radius * scale),
          static_cast<float>(cone.apex_radius * scale),
          cone.caps,
          cone.surface};
}

Ring placed(const Ring& ring, const Transform& map, double scale) {
  return {Vec3f(apply_point(map, Vec3d(ring.center))),
          Vec3f(normalize(apply_direction(map, Vec3d(ring.normal)))),
          static_cast<float>(ring.radius * scale), static_cast<float>(ring.inner_radius * scale),
          ring.surface};
}

std::array<Vec3f, 3> corners(const ShapeSet& shapes, ShapeRef triangle) {
  const Mesh& mesh = home_of(shapes, triangle).meshes[triangle.index];
  const Triangle& index = mesh.triangles[triangle.triangle];
  std::array<Vec3f, 3> corner;
  for (std::size_t i = 0; i < 3; ++i) corner[i] = mesh.positions[index[i]];
  if (triangle.instance == 0) return corner;
  const Transform& map = shapes.instances[triangle.instance - 1].placement;
  for (Vec3f& p : corner) p = Vec3f(apply_point(map, Vec3d(p)));
  if (determinant(map) < 0) std::swap(corner[1], corner[2]);
  return corner;
}

Box placed(const Box& box, const Transform& map) {
  if (box.is_empty()) return box;
  const Vec3d lo(box.lo), hi(box.hi), half = (hi - lo) * 0.5;
  const Vec3d center = apply_point(map, (lo + hi) * 0.5);
  Vec3d extent;
  for (int axis = 0; axis < 3; ++axis)
    extent[axis] = std::abs(map.x_axis[axis]) * half.x + std::abs(map.y_axis[axis]) * half.y +
                   std::abs(map.z_axis[axis]) * half.z;
  const double rounding = 0x1p-48 * (max_abs(center) + max_abs(extent));
  extent += Vec3d{rounding, rounding, rounding};
  return outward(center - extent, center + extent);
}

void add_placed(ShapeSet& shapes, const ShapeSet& group, const Transform& placement) {
  const double scale = similarity_scale(placement);
  for (const Sphere& s : group.spheres) shapes.spheres.push_back(placed(s, placement, scale));
  for (const Cone& c : group.cones) shapes.cones.push_back(placed(c, placement, scale));
  for (const Ring& r : group.rings) shapes.rings.push_back(placed(r, placement, scale));
  for (const Mesh& mesh : group.meshes) shapes.meshes.push_back(transformed(mesh, placement));
}

ShapeSet flattened(const ShapeSet& shapes) {
  ShapeSet flat{shapes.spheres, shapes.cones, shapes.rings, shapes.meshes, {}, {}};
  for (const Instance& instance : shapes.instances)
    add_placed(flat, shapes.groups[instance.group], instance.placement);
  return flat;
}

}  // namespace penumbra
