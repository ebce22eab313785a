// SPDX-License-Identifier: MIT
#include "penumbra/scene/framing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace penumbra::detail {

namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double azimuth_rad = 28 * degree;    // to the viewer's right of the front
constexpr double elevation_rad = 20 * degree;  // above the horizontal
constexpr double margin = 0.08;                // of the picture, on each side

/// How far a disk around `normal` reaches beyond its centre.
double disk_reach(Vec3d normal, double radius, Vec3d direction) {
  const double along = dot(normalize(normal), direction);
  return radius * std::sqrt(std::max(0.0, length_squared(direction) - along * along));
}

bool is_backdrop(const Mesh& mesh) { return mesh.is_backdrop; }

bool has_objects(const ShapeSet& shapes) {
  return !shapes.spheres.empty() || !shapes.cones.empty() || !shapes.rings.empty() ||
         !std::all_of(shapes.meshes.begin(), shapes.meshes.end(), is_backdrop) ||
         std::any_of(shapes.instances.begin(), shapes.instances.end(),
                     [&](const Instance& i) { return has_objects(shapes.groups[i.group]); });
}

}  // namespace

Subject subject_of(const ShapeSet& shapes) {
  Subject subject;
  subject.box = has_objects(shapes) ? object_bounds(shapes) : bounds(shapes);
  subject.center = Vec3d(subject.box.center());
  subject.extent =
      std::max<double>(subject.box.largest_extent(), std::numeric_limits<float>::min());
  return subject;
}

namespace {

/// Of the set's own shapes, with backdrops or without.
double reach_of_own(const ShapeSet& shapes, Vec3d direction, bool without_backdrops) {
  double farthest = -std::numeric_limits<double>::infinity();
  const auto add = [&](Vec3f p, double further) {
    farthest = std::max(farthest, dot(Vec3d(p), direction) + further);
  };
  const double unit = length(direction);
  for (const Sphere& s : shapes.spheres) add(s.center, s.radius * unit);
  for (const Cone& c : shapes.cones) {
    const Vec3d axis = Vec3d(c.apex) - Vec3d(c.base);
    add(c.base, disk_reach(axis, c.base_radius, direction));
    add(c.apex, disk_reach(axis, c.apex_radius, direction));
  }
  for (const Ring& r : shapes.rings)
    add(r.center, disk_reach(Vec3d(r.normal), r.radius, direction));
  for (const Mesh& mesh : shapes.meshes) {
    if (without_backdrops && mesh.is_backdrop) continue;
    for (const Triangle& triangle : mesh.triangles)
      for (std::uint32_t corner : triangle) add(mesh.positions[corner], 0);
  }
  return farthest;
}

/// Upper bound of a box's reach.
double reach_of(const Box& box, Vec3d direction) {
  const Vec3d half = (Vec3d(box.hi) - Vec3d(box.lo)) * 0.5;
  return dot(Vec3d(box.lo) + half, direction) + std::abs(direction.x) * half.x +
         std::abs(direction.y) * half.y + std::abs(direction.z) * half.z;
}

/// An instance as one direction sees it.
struct Placed {
  double most;  ///< of its reach
  std::uint32_t group;
  Vec3d within;
  double offset;
};

/// So many primitives are placed to know a reach exactly: a fifth of a second.
constexpr std::size_t most_looked_at = std::size_t{1} << 24;

}  // namespace

double reach(const ShapeSet& shapes, Vec3d direction) {
  const bool without_backdrops = has_objects(shapes);
  double farthest = reach_of_own(shapes, direction, without_backdrops);
  std::vector<Box> box;
  for (const ShapeSet& group : shapes.groups)
    box.push_back(without_backdrops ? object_bounds(group) : bounds(group));
  std::vector<Placed> placed;
  for (const auto& [group, map] : shapes.instances) {
    if (box[group].is_empty()) continue;
    // The direction as the group sees it: that of the transposed map.
    const Vec3d within{dot(map.x_axis, direction), dot(map.y_axis, direction),
                       dot(map.z_axis, direction)};
    const double offset = dot(map.offset, direction);
    placed.push_back({reach_of(box[group], within) + offset, group, within, offset});
  }
  // Those that may reach farthest first: most others then need no look.
  std::stable_sort(placed.begin(), placed.end(),
                   [](const Placed& a, const Placed& b) { return a.most > b.most; });
  std::size_t looked_at = 0;
  for (const Placed& p : placed) {
    if (!(p.most > farthest)) break;
    const ShapeSet& group = shapes.groups[p.group];
    looked_at += own_primitive_count(group);
    if (looked_at > most_looked_at) return p.most;
    farthest = std::max(farthest, reach_of_own(group, p.within, without_backdrops) + p.offset);
  }
  return farthest;
}

Vec3d front(Vec3d up) {
  const Vec3d toward = std::abs(up.z) > 0.9 ? Vec3d{0, -1, 0} : Vec3d{0, 0, 1};
  return normalize(toward - up * dot(toward, up));
}

Vec3d rotated(Vec3d v, Vec3d axis, double angle_rad) {
  return v * std::cos(angle_rad) + cross(axis, v) * std::sin(angle_rad) +
         axis * (dot(axis, v) * (1 - std::cos(angle_rad)));
}

Camera camera_around(const ShapeSet& shapes, Vec3d up, double fov_deg) {
  const Subject subject = subject_of(shapes);
  const Vec3d aside = rotated(front(up), up, azimuth_rad);
  const Vec3d forward = -(aside * std::cos(elevation_rad) + up * std::sin(elevation_rad));
  const Vec3d right = normalize(cross(forward, up));
  const Vec3d top = cross(right, forward);

  // In view coordinates, a camera at (x, y, z) sees a point whose offset is (a, b, c) if |a| and
  // |b| are at most k c. So each side of the frustum touches where the objects reach farthest along
  // that side's normal; opposite sides meet at the camera.
  const double k = std::tan(fov_deg / 2 * degree) * (1 - 2 * margin);
  const double at_right = reach(shapes, right - forward * k);
  const double at_left = reach(shapes, -right - forward * k);
  const double at_top = reach(shapes, top - forward * k);
  const double at_bottom = reach(shapes, -top - forward * k);
  const double nearest = -reach(shapes, -forward) - 0.05 * subject.extent;
  const double z =
      std::min({-(at_right + at_left) / (2 * k), -(at_top + at_bottom) / (2 * k), nearest});

  Camera camera;
  camera.from = right * ((at_right - at_left) / 2) + top * ((at_top - at_bottom) / 2) + forward * z;
  camera.at = camera.from + forward * (dot(subject.center, forward) - z);
  camera.up = up;
  camera.fov_deg = fov_deg;
  return camera;
}

}  // namespace penumbra::detail
