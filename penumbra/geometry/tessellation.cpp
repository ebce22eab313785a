// SPDX-License-Identifier: MIT
#include "penumbra/geometry/tessellation.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "penumbra/geometry/transform.h"

namespace penumbra {
namespace {

/// A point of the half plane that turns around the z axis, and the surface's normal there.
struct ProfilePoint {
  double radius = 0, z = 0;
  double normal_radius = 0, normal_z = 1;
};

int columns_of(double angle_rad, int segments) {
  return std::max(1, static_cast<int>(std::ceil(segments * angle_rad / full_turn_rad - 1e-9)));
}

/// Adds what the profile leaves behind as it turns. Outside is right of the way it is listed in,
/// seen with z up and the axis on the left.
void sweep(Mesh& mesh, std::span<const ProfilePoint> profile, double angle_rad, int segments) {
  const bool is_whole = angle_rad > full_turn_rad * (1 - 1e-9);
  const auto columns = static_cast<std::uint32_t>(columns_of(angle_rad, segments));
  const std::uint32_t a_row = is_whole ? columns : columns + 1;
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (const ProfilePoint& p : profile)
    for (std::uint32_t column = 0; column < a_row; ++column) {
      const double phi = angle_rad * column / columns, c = std::cos(phi), s = std::sin(phi);
      mesh.positions.push_back(Vec3f(Vec3d(p.radius * c, p.radius * s, p.z)));
      mesh.normals.push_back(Vec3f(Vec3d(p.normal_radius * c, p.normal_radius * s, p.normal_z)));
    }
  for (std::uint32_t row = 0; row + 1 < profile.size(); ++row)
    for (std::uint32_t column = 0; column < columns; ++column) {
      const std::uint32_t a = first + row * a_row + column;
      const std::uint32_t b = first + row * a_row + (column + 1) % a_row;
      if (profile[row].radius > 0) mesh.triangles.push_back({a, b, b + a_row});
      if (profile[row + 1].radius > 0) mesh.triangles.push_back({a, b + a_row, a + a_row});
    }
}

/// The map that takes the z axis to this one (unit) and the origin to `offset`, turning and scaling
/// alone.
Transform placement(Vec3d axis, Vec3d offset, double scale = 1) {
  const Frame<double> frame = frame_around(axis);
  return {frame.u * scale, frame.v * scale, frame.n * scale, offset};
}

}  // namespace

Mesh tessellated(const SphereZone& zone, int segments) {
  const double low = std::clamp(zone.z_min / zone.radius, -1.0, 1.0),
               high = std::clamp(zone.z_max / zone.radius, -1.0, 1.0);
  const double from = std::asin(low), to = std::asin(high);
  const int rows = std::max(2, static_cast<int>(std::ceil((to - from) / full_turn_rad * segments)));
  std::vector<ProfilePoint> profile;
  for (int row = 0; row <= rows; ++row) {
    const double elevation = from + (to - from) * row / rows;
    const bool is_pole = (row == 0 && low == -1) || (row == rows && high == 1);
    const double c = is_pole ? 0 : std::cos(elevation), s = std::sin(elevation);
    profile.push_back({zone.radius * c, zone.radius * s, c, s});
  }
  Mesh mesh;
  sweep(mesh, profile, zone.angle_rad, segments);
  return mesh;
}

Mesh tessellated(const CylinderWall& wall, int segments) {
  const ProfilePoint profile[] = {{wall.radius, wall.z_min, 1, 0}, {wall.radius, wall.z_max, 1, 0}};
  Mesh mesh;
  sweep(mesh, profile, wall.angle_rad, segments);
  return mesh;
}

Mesh tessellated(const DiskSector& sector, int segments) {
  const ProfilePoint profile[] = {{sector.radius, sector.height, 0, 1},
                                  {sector.inner_radius, sector.height, 0, 1}};
  Mesh mesh;
  sweep(mesh, profile, sector.angle_rad, segments);
  return mesh;
}

Mesh tessellated(const Sphere& sphere, int segments) {
  Mesh mesh = transformed(tessellated(SphereZone{}, segments),
                          placement({0, 0, 1}, Vec3d(sphere.center), sphere.radius));
  mesh.surface = sphere.surface;
  return mesh;
}

Mesh tessellated(const Cone& cone, int segments) {
  const Vec3d axis = Vec3d(cone.apex) - Vec3d(cone.base);
  const double height = length(axis), base = cone.base_radius, apex = cone.apex_radius;
  const Vec3d side = normalize(Vec3d(height, 0, base - apex));
  Mesh mesh;
  const ProfilePoint wall[] = {{base, 0, side.x, side.z}, {apex, height, side.x, side.z}};
  sweep(mesh, wall, full_turn_rad, segments);
  if (cone.caps == Caps::capped) {
    const ProfilePoint bottom[] = {{0, 0, 0, -1}, {base, 0, 0, -1}};
    const ProfilePoint top[] = {{apex, height, 0, 1}, {0, height, 0, 1}};
    if (base > 0) sweep(mesh, bottom, full_turn_rad, segments);
    if (apex > 0) sweep(mesh, top, full_turn_rad, segments);
  }
  mesh = transformed(std::move(mesh), placement(normalize(axis), Vec3d(cone.base)));
  mesh.surface = cone.surface;
  return mesh;
}

Mesh tessellated(const Ring& ring, int segments) {
  const DiskSector sector{ring.radius, ring.inner_radius, 0, full_turn_rad};
  Mesh mesh = transformed(tessellated(sector, segments),
                          placement(normalize(Vec3d(ring.normal)), Vec3d(ring.center)));
  mesh.surface = ring.surface;
  return mesh;
}

}  // namespace penumbra
