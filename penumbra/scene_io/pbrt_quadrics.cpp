// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "penumbra/geometry/tessellation.h"
#include "penumbra/scene_io/pbrt_shapes.h"

namespace penumbra {
namespace {

constexpr double pi = std::numbers::pi;
/// Relative: matrices come with 6 digits.
constexpr double tolerance = 2e-5;

bool are_perpendicular(Vec3d a, Vec3d b) {
  return std::abs(dot(a, b)) <= tolerance * length(a) * length(b);
}

/// Whether circles around the z axis stay circles.
bool keeps_circles(const Transform& t) {
  const double x = length(t.x_axis), y = length(t.y_axis);
  return x > 0 && std::abs(x - y) <= tolerance * x && are_perpendicular(t.x_axis, t.y_axis);
}

bool keeps_cylinders(const Transform& t) {
  return keeps_circles(t) && length(t.z_axis) > 0 && are_perpendicular(t.x_axis, t.z_axis) &&
         are_perpendicular(t.y_axis, t.z_axis);
}

bool keeps_spheres(const Transform& t) {
  const double x = length(t.x_axis), z = length(t.z_axis);
  return keeps_cylinders(t) && std::abs(x - z) <= tolerance * x;
}

/// Of the two that keep circles.
double scale_across(const Transform& t) { return (length(t.x_axis) + length(t.y_axis)) / 2; }

/// The angle in radians, within a full turn.
double sweep(const PbrtParams& params) {
  return std::clamp(params.number("phimax", 360), 0.0, 360.0) * pi / 180;
}

bool is_whole(double angle_rad) { return angle_rad > full_turn_rad * (1 - 1e-6); }

/// A size that makes a shape; what has none is left out with a warning.
bool is_size(PbrtScene& pbrt, const PbrtParams& params, double size) {
  if (size > 0) return true;
  pbrt.warnings.add("a shape of no size is left out", params.place());
  return false;
}

Vec3f center_at(const Transform& t, double z) { return Vec3f(apply_point(t, {0, 0, z})); }

void add_whole_sphere(PbrtScene& pbrt, double radius) {
  const Transform& t = pbrt.graphics.to_world;
  const double scaled = radius * (length(t.x_axis) + length(t.y_axis) + length(t.z_axis)) / 3;
  const double section = pi * scaled * scaled;
  const auto glow = pbrt_glow(pbrt, 4 * section, 1);
  const bool is_light = glow && (!pbrt.graphics.is_reversed || glow->is_two_sided);
  Sphere sphere{center_at(t, 0), static_cast<float>(scaled), pbrt_surface(pbrt, glow, !is_light)};
  pbrt_target(pbrt).spheres.push_back(sphere);
  if (is_light)
    pbrt.scene.lights.push_back({BallLight{sphere.center, sphere.radius},
                                 Color(Vec3d(glow->radiance) * section),
                                 Falloff::inverse_square,
                                 {}});
}

/// The plane of a disk: its normal as pbrt turns it.
Vec3d disk_normal(const PbrtGraphics& graphics) {
  const double side = determinant(graphics.to_world) < 0 ? -1 : 1;
  const Vec3d normal = normalize(apply_normal(graphics.to_world, {0, 0, 1}) * side);
  return graphics.is_reversed ? -normal : normal;
}

void add_whole_disk(PbrtScene& pbrt, const DiskSector& disk, Vec3d normal) {
  const Transform& t = pbrt.graphics.to_world;
  const double scale = scale_across(t);
  Ring ring{center_at(t, disk.height), Vec3f(normal), static_cast<float>(disk.radius * scale),
            static_cast<float>(disk.inner_radius * scale), 0};
  const double area = pi * scale * scale * disk.radius * disk.radius;
  const auto glow = pbrt_glow(pbrt, area, 1);
  ring.surface = pbrt_surface(pbrt, glow, !glow);
  pbrt_target(pbrt).rings.push_back(ring);
  if (!glow) return;
  Light light{DiskLight{ring.center, ring.normal, ring.radius},
              Color(Vec3d(glow->radiance) * area),
              Falloff::inverse_square,
              {}};
  if (!glow->is_two_sided) light.beam = Beam{ring.normal, 0, 0};
  pbrt.scene.lights.push_back(std::move(light));
}

}  // namespace

void add_pbrt_sphere(PbrtScene& pbrt, const PbrtParams& params) {
  const double radius = params.number("radius", 1);
  const double a = params.number("zmin", -radius), b = params.number("zmax", radius);
  const SphereZone zone{radius, std::clamp(std::min(a, b), -radius, std::max(radius, -radius)),
                        std::clamp(std::max(a, b), -radius, std::max(radius, -radius)),
                        sweep(params)};
  if (!is_size(pbrt, params, radius) || !is_size(pbrt, params, zone.z_max - zone.z_min) ||
      !is_size(pbrt, params, zone.angle_rad))
    return;
  const bool is_all = zone.z_min <= -radius && zone.z_max >= radius && is_whole(zone.angle_rad);
  if (is_all && keeps_spheres(pbrt.graphics.to_world)) return add_whole_sphere(pbrt, radius);
  add_pbrt_mesh(pbrt, tessellated(zone, pbrt_segments(pbrt)), PbrtMeshOrigin::made, params.place(),
                1);
}

void add_pbrt_cylinder(PbrtScene& pbrt, const PbrtParams& params) {
  const double a = params.number("zmin", -1), b = params.number("zmax", 1);
  const CylinderWall wall{params.number("radius", 1), std::min(a, b), std::max(a, b),
                          sweep(params)};
  if (!is_size(pbrt, params, wall.radius) || !is_size(pbrt, params, wall.z_max - wall.z_min) ||
      !is_size(pbrt, params, wall.angle_rad))
    return;
  const Transform& t = pbrt.graphics.to_world;
  if (!is_whole(wall.angle_rad) || !keeps_cylinders(t) || pbrt.graphics.area_light)
    return add_pbrt_mesh(pbrt, tessellated(wall, pbrt_segments(pbrt)), PbrtMeshOrigin::made,
                         params.place(), 1);
  const auto radius = static_cast<float>(wall.radius * scale_across(t));
  const Cone cone{center_at(t, wall.z_min), center_at(t, wall.z_max), radius, radius, Caps::open,
                  pbrt.graphics.material};
  if (is_size(pbrt, params, cone.base == cone.apex ? 0 : 1))
    pbrt_target(pbrt).cones.push_back(cone);
}

void add_pbrt_disk(PbrtScene& pbrt, const PbrtParams& params) {
  const DiskSector disk{params.number("radius", 1), params.number("innerradius", 0),
                        params.number("height", 0), sweep(params)};
  if (!is_size(pbrt, params, disk.radius) || !is_size(pbrt, params, disk.angle_rad) ||
      !is_size(pbrt, params, disk.radius - disk.inner_radius))
    return;
  const Vec3d normal = disk_normal(pbrt.graphics);
  const bool is_ours = is_whole(disk.angle_rad) && disk.inner_radius >= 0 &&
                       keeps_circles(pbrt.graphics.to_world) && normal != Vec3d{};
  // A light has no hole.
  if (is_ours && (disk.inner_radius == 0 || !pbrt.graphics.area_light))
    return add_whole_disk(pbrt, disk, normal);
  add_pbrt_mesh(pbrt, tessellated(disk, pbrt_segments(pbrt)), PbrtMeshOrigin::made, params.place(),
                1);
}

}  // namespace penumbra
