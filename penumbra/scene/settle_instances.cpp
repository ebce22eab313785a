// SPDX-License-Identifier: MIT
#include "penumbra/scene/settle_instances.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "penumbra/geometry/placed_shape.h"
#include "penumbra/geometry/tessellation.h"
#include "penumbra/scene/error.h"

namespace penumbra {
namespace {

constexpr std::size_t few_primitives = 4, few_vertices = 16;
constexpr std::size_t most_flat_parts = std::size_t{1} << 24;
constexpr std::size_t most_stretched_triangles = std::size_t{1} << 24,
                      good_stretched_triangles = most_stretched_triangles / 8;
constexpr int fewest_segments = 8, most_segments = 48;

std::size_t quadric_count(const ShapeSet& shapes) {
  return shapes.spheres.size() + shapes.cones.size() + shapes.rings.size();
}

std::size_t vertex_count(const ShapeSet& shapes) {
  std::size_t count = 0;
  for (const Mesh& mesh : shapes.meshes) count += mesh.positions.size();
  return count;
}

/// Of so many round shapes as meshes: a sphere has the square of it triangles, others have fewer.
int segments_of(std::size_t quadrics) {
  constexpr auto fewest = std::size_t{fewest_segments} * fewest_segments;
  if (quadrics > most_stretched_triangles / fewest)
    throw Error({}, "instances stretch more than 262144 spheres, cones and rings",
                "scale them alike in all directions");
  const double each = double(good_stretched_triangles) / double(quadrics);
  return static_cast<int>(std::clamp<double>(std::sqrt(each), fewest_segments, most_segments));
}

ShapeSet without_quadrics(const ShapeSet& group, int segments) {
  ShapeSet meshes;
  meshes.meshes = group.meshes;
  for (const Sphere& sphere : group.spheres) meshes.meshes.push_back(tessellated(sphere, segments));
  for (const Cone& cone : group.cones) meshes.meshes.push_back(tessellated(cone, segments));
  for (const Ring& ring : group.rings) meshes.meshes.push_back(tessellated(ring, segments));
  return meshes;
}

/// The similarity that a map is, to what text in six digits says of it; none where it leaves
/// nothing.
std::optional<Transform> as_similarity(const Transform& map) {
  if (!can_place(map)) return {};
  if (similarity_scale(map) > 0) return map;
  const Transform near = nearest_similarity(map);
  const double tolerance = 1e-5 * length(near.x_axis);
  for (const Vec3d off :
       {near.x_axis - map.x_axis, near.y_axis - map.y_axis, near.z_axis - map.z_axis})
    if (!(length(off) <= tolerance)) return {};
  return near;
}

/// Where groups go, one instance after the other.
class Settler {
 public:
  explicit Settler(ShapeSet& shapes)
      : shapes_(shapes), uses_(shapes.groups.size()), twin_(shapes.groups.size()) {
    std::vector<bool> is_stretched(shapes.groups.size());
    for (const Instance& instance : shapes.instances) {
      ++uses_[instance.group];
      if (!as_similarity(instance.placement)) is_stretched[instance.group] = true;
    }
    std::size_t quadrics = 0;
    for (std::size_t i = 0; i < shapes.groups.size(); ++i)
      if (is_stretched[i]) quadrics += quadric_count(shapes.groups[i]);
    if (quadrics > 0) segments_ = segments_of(quadrics);
  }

  SettledInstances settle() {
    for (Instance instance : std::exchange(shapes_.instances, {})) {
      const std::size_t uses = uses_[instance.group];
      if (quadric_count(shapes_.groups[instance.group]) > 0) {
        if (const auto similarity = as_similarity(instance.placement))
          instance.placement = *similarity;
        else
          instance.group = twin_of(instance.group);
      }
      settle(instance, uses);
    }
    drop_unused();
    return done_;
  }

 private:
  void settle(const Instance& instance, std::size_t uses) {
    const ShapeSet& group = shapes_.groups[instance.group];
    const std::size_t primitives = own_primitive_count(group), vertices = vertex_count(group);
    const bool is_placeable = can_place(instance.placement);
    if (is_placeable && uses > 1 && (primitives > few_primitives || vertices > few_vertices)) {
      shapes_.instances.push_back(instance);
      return;
    }
    if (!is_placeable && (flat_ += primitives + vertices) > most_flat_parts)
      throw Error({},
                  "instances that are flattened hold more than 16 million primitives and vertices",
                  "leave them out");
    add_placed(shapes_, group, instance.placement);
    ++done_.expanded;
  }

  std::uint32_t twin_of(std::uint32_t group) {
    if (!twin_[group]) {
      done_.stretched += quadric_count(shapes_.groups[group]);
      twin_[group] = static_cast<std::uint32_t>(shapes_.groups.size());
      shapes_.groups.push_back(without_quadrics(shapes_.groups[group], segments_));
    }
    return *twin_[group];
  }

  void drop_unused() {
    std::vector<std::optional<std::uint32_t>> number(shapes_.groups.size());
    std::vector<ShapeSet> used;
    for (Instance& instance : shapes_.instances) {
      if (!number[instance.group]) {
        number[instance.group] = static_cast<std::uint32_t>(used.size());
        used.push_back(std::move(shapes_.groups[instance.group]));
      }
      instance.group = *number[instance.group];
    }
    shapes_.groups = std::move(used);
  }

  ShapeSet& shapes_;
  std::vector<std::size_t> uses_;
  std::vector<std::optional<std::uint32_t>> twin_;
  SettledInstances done_;
  std::size_t flat_ = 0;
  int segments_ = most_segments;
};

}  // namespace

bool has_quadrics(const ShapeSet& shapes) { return quadric_count(shapes) > 0; }

bool can_place(const Transform& map) {
  for (int row = 0; row < 3; ++row) {
    const double size = max_abs(Vec3d{map.x_axis[row], map.y_axis[row], map.z_axis[row]});
    if (!(size >= 1e-15 && size <= 1e15)) return false;
  }
  return std::isfinite(determinant(map)) && determinant(map) != 0;
}

SettledInstances settle_instances(ShapeSet& shapes) { return Settler(shapes).settle(); }

}  // namespace penumbra
