// SPDX-License-Identifier: MIT
// Random placements of random groups: turned, mirrored, sheared, nearly flat, far away.
#pragma once

#include <utility>

#include "penumbra/geometry/placed_shape.h"
#include "tests/kernel/nasty_shapes.h"

namespace penumbra::nasty {

inline bool has_quadrics(const ShapeSet& shapes) {
  return !shapes.spheres.empty() || !shapes.cones.empty() || !shapes.rings.empty();
}

/// About the middle of the place, and moved by about its size. Any affine map, or a similarity.
inline Transform random_map(const Place& place, bool is_similarity, Random& random) {
  Transform map{Vec3d(random.in_cube()), Vec3d(random.in_cube()), Vec3d(random.in_cube()), {}};
  if (random.one_in(3)) map = {};                              // boxes stay tight
  if (random.one_in(6)) map.z_axis = map.z_axis * 1e-6;        // nearly flat
  if (random.one_in(4)) map.x_axis = -map.x_axis;              // mirrors
  if (random.one_in(5)) map.y_axis = map.x_axis + map.y_axis;  // shears
  if (is_similarity) map = nearest_similarity(map);
  if (is_similarity && random.one_in(3)) {  // as rounding may leave it
    const double slack = 0x1p-24 * length(map.x_axis);
    for (Vec3d* axis : {&map.x_axis, &map.y_axis, &map.z_axis})
      if (random.one_in(2)) *axis += Vec3d(random.in_cube()) * slack;
  }
  const double scale = random.one_in(3) ? double(random.power(-2, 1)) : 1;
  map.x_axis = map.x_axis * scale, map.y_axis = map.y_axis * scale, map.z_axis = map.z_axis * scale;
  const Vec3d middle(place.offset);
  map.offset = middle - apply_direction(map, middle) + Vec3d(random.in_cube() * place.scale);
  if (determinant(map) == 0) return {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, map.offset - middle};
  return map;
}

/// The shapes become a group of `to`, placed up to four times.
inline void add_group(ShapeSet shapes, const Place& place, Random& random, ShapeSet& to) {
  const bool is_similarity = has_quadrics(shapes);
  const auto group = static_cast<std::uint32_t>(to.groups.size());
  to.groups.push_back(std::move(shapes));
  for (std::uint32_t i = 0, count = 1 + random.below(4); i < count; ++i)
    to.instances.push_back({group, random_map(place, is_similarity, random)});
}

}  // namespace penumbra::nasty
