// SPDX-License-Identifier: MIT
#include "penumbra/geometry/transform.h"

#include <utility>

namespace penumbra {

Vec3f placed_normal(const Transform& t, Vec3f n) {
  const Vec3f out(normalize(apply_normal(t, Vec3d(n)) * (determinant(t) < 0 ? -1.0 : 1.0)));
  return out == Vec3f{} ? Vec3f{0, 0, 1} : out;
}

Mesh transformed(Mesh mesh, const Transform& t) {
  for (Vec3f& p : mesh.positions) p = Vec3f(apply_point(t, Vec3d(p)));
  for (Vec3f& n : mesh.normals) n = placed_normal(t, n);
  if (determinant(t) < 0)
    for (Triangle& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
  return mesh;
}

}  // namespace penumbra
