// SPDX-License-Identifier: MIT
// Affine maps: placing what files put into nodes.
#pragma once

#include <optional>

#include "penumbra/geometry/mesh.h"
#include "penumbra/geometry/vec.h"

namespace penumbra {

/// x -> linear x + offset, the linear part given by its columns.
struct Transform {
  Vec3d x_axis{1, 0, 0}, y_axis{0, 1, 0}, z_axis{0, 0, 1}, offset{};
};

inline Vec3d apply_direction(const Transform& t, Vec3d v) {
  return t.x_axis * v.x + t.y_axis * v.y + t.z_axis * v.z;
}
inline Vec3d apply_point(const Transform& t, Vec3d p) { return apply_direction(t, p) + t.offset; }

/// Normals go by the cofactors, so they need no inverse and survive a singular map; not unit
/// length.
inline Vec3d apply_normal(const Transform& t, Vec3d n) {
  return cross(t.y_axis, t.z_axis) * n.x + cross(t.z_axis, t.x_axis) * n.y +
         cross(t.x_axis, t.y_axis) * n.z;
}

inline double determinant(const Transform& t) { return dot(t.x_axis, cross(t.y_axis, t.z_axis)); }

/// A unit normal of a surface under the map, on the side that is outside after it; unit, and z
/// where a flattening map leaves none.
Vec3f placed_normal(const Transform& t, Vec3f n);

/// First `inner`, then `outer`.
inline Transform compose(const Transform& outer, const Transform& inner) {
  return {apply_direction(outer, inner.x_axis), apply_direction(outer, inner.y_axis),
          apply_direction(outer, inner.z_axis), apply_point(outer, inner.offset)};
}

/// The map backwards; nothing where it is singular or not finite.
std::optional<Transform> inverse(const Transform& t);

/// The mesh placed by t; a mirroring map flips the triangles, so that outside stays outside.
Mesh transformed(Mesh mesh, const Transform& t);

}  // namespace penumbra
