// SPDX-License-Identifier: MIT
#include "penumbra/geometry/transform.h"

#include <cmath>
#include <utility>

namespace penumbra {

Vec3f placed_normal(const Transform& t, Vec3f n) {
  const Vec3f out(normalize(apply_normal(t, Vec3d(n)) * (determinant(t) < 0 ? -1.0 : 1.0)));
  return out == Vec3f{} ? Vec3f{0, 0, 1} : out;
}

std::optional<Transform> inverse(const Transform& t) {
  const double volume = determinant(t);
  if (volume == 0 || !std::isfinite(volume)) return std::nullopt;
  const Vec3d x = cross(t.y_axis, t.z_axis) / volume, y = cross(t.z_axis, t.x_axis) / volume,
              z = cross(t.x_axis, t.y_axis) / volume;  // the rows
  Transform back{{x.x, y.x, z.x}, {x.y, y.y, z.y}, {x.z, y.z, z.z}, {}};
  back.offset = -apply_direction(back, t.offset);
  const bool is_good = is_finite(back.x_axis) && is_finite(back.y_axis) && is_finite(back.z_axis) &&
                       is_finite(back.offset);
  return is_good ? std::optional(back) : std::nullopt;
}

Mesh transformed(Mesh mesh, const Transform& t) {
  for (Vec3f& p : mesh.positions) p = Vec3f(apply_point(t, Vec3d(p)));
  for (Vec3f& n : mesh.normals) n = placed_normal(t, n);
  if (determinant(t) < 0)
    for (Triangle& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
  return mesh;
}

}  // namespace penumbra
