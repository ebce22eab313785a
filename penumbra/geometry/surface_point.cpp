// SPDX-License-Identifier: MIT
#include "penumbra/geometry/surface_point.h"

#include <array>
#include <cmath>

#include "penumbra/geometry/placed_shape.h"

namespace penumbra {
namespace {

/// Where the line meets the plane, or what of the plane is next to its point at t where the line
/// runs so flat that these are not the same.
Vec3d on_plane(Vec3d origin, Vec3d direction, double t, Vec3d point, Vec3d normal) {
  const double exact = dot(point - origin, normal) / dot(direction, normal);
  const bool is_same = std::abs(exact - t) <= 0x1p-16 * std::abs(t);
  const Vec3d p = origin + direction * (is_same ? exact : t);
  return p - normal * dot(p - point, normal);
}

SurfacePoint on_sphere(const Sphere& sphere, Vec3d origin, Vec3d direction, double t) {
  const Vec3d center(sphere.center), to = center - origin;
  const double r = sphere.radius;
  // Of the two exact crossings the one that the hit meant.
  const double square = dot(direction, direction), middle = dot(to, direction) / square;
  const Vec3d miss = to - direction * middle;
  const double half = std::sqrt(std::max(0.0, (r * r - dot(miss, miss)) / square));
  const double exact = t < middle ? middle - half : middle + half;
  const Vec3d outward = normalize(origin + direction * exact - center);
  return {.position = center + outward * r, .normal = outward};
}

SurfacePoint on_cone(const Cone& cone, Vec3d origin, Vec3d direction, double t) {
  const Vec3d base(cone.base), along = Vec3d(cone.apex) - base;
  const double height = length(along),
               slope = (double(cone.apex_radius) - cone.base_radius) / height;
  const Vec3d axis = along / height, p = origin + direction * t - base;
  const double axial = std::clamp(dot(p, axis), 0.0, height);
  const Vec3d radial = p - axis * dot(p, axis);
  const double radius = cone.base_radius + slope * axial;
  const double to_side = std::abs(length(radial) - radius);
  const double to_base = std::abs(dot(p, axis)), to_apex = std::abs(dot(p, axis) - height);
  if (cone.caps == Caps::capped && std::min(to_base, to_apex) < to_side) {
    const bool at_base = to_base < to_apex;
    const Vec3d n = at_base ? -axis : axis;
    return {.position = on_plane(origin, direction, t, at_base ? base : Vec3d(cone.apex), n),
            .normal = n};
  }
  const Vec3d outward = normalize(radial);
  return {.position = base + axis * axial + outward * radius,
          .normal = normalize(outward - axis * slope)};
}

SurfacePoint on_ring(const Ring& ring, Vec3d origin, Vec3d direction, double t) {
  const Vec3d n = normalize(Vec3d(ring.normal));
  return {.position = on_plane(origin, direction, t, Vec3d(ring.center), n), .normal = n};
}

SurfacePoint on_triangle(const std::array<Vec3f, 3>& corner, Vec3d origin, Vec3d direction,
                         double t) {
  const Vec3d a(corner[0]), b(corner[1]), c(corner[2]);
  const Vec3d area = cross(b - a, c - a), n = normalize(area);
  const Vec3d p = on_plane(origin, direction, t, a, n);
  double weight[3] = {dot(cross(b - p, c - p), n), dot(cross(c - p, a - p), n),
                      dot(cross(a - p, b - p), n)};
  for (double& w : weight)
    w = std::max(w, 0.0);  // a hit that float put just outside goes to the edge
  const double sum = weight[0] + weight[1] + weight[2];
  for (double& w : weight) w = sum > 0 ? w / sum : 1.0 / 3;
  return {.position = a * weight[0] + b * weight[1] + c * weight[2],
          .normal = n,
          .barycentric = {weight[0], weight[1], weight[2]}};
}

SurfacePoint on_primitive(const ShapeSet& shapes, ShapeRef ref, Vec3d origin, Vec3d direction,
                          double t) {
  const ShapeSet& home = home_of(shapes, ref);
  const auto in_world = [&](const auto& shape) {
    if (ref.instance == 0) return shape;
    const Transform& map = shapes.instances[ref.instance - 1].placement;
    return placed(shape, map, similarity_scale(map));
  };
  switch (ref.kind) {
    case ShapeKind::sphere:
      return on_sphere(in_world(home.spheres[ref.index]), origin, direction, t);
    case ShapeKind::cone: return on_cone(in_world(home.cones[ref.index]), origin, direction, t);
    case ShapeKind::ring: return on_ring(in_world(home.rings[ref.index]), origin, direction, t);
    case ShapeKind::triangle: break;
  }
  return on_triangle(corners(shapes, ref), origin, direction, t);
}

}  // namespace

SurfacePoint surface_point(const ShapeSet& shapes, ShapeRef ref, Vec3d origin, Vec3d direction,
                           double t) {
  SurfacePoint point = on_primitive(shapes, ref, origin, direction, t);
  point.is_back = dot(point.normal, direction) > 0;
  if (point.is_back) point.normal = -point.normal;
  constexpr double ulp = 0x1p-24;
  point.offset = 32 * ulp * (max_abs(point.position) + bounds(shapes, ref).largest_extent());
  return point;
}

Vec3f receiver_position(const SurfacePoint& point) {
  return Vec3f(point.position + point.normal * point.offset);
}

Vec3f behind_position(const SurfacePoint& point) {
  return Vec3f(point.position - point.normal * point.offset);
}

}  // namespace penumbra
