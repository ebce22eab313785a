// SPDX-License-Identifier: MIT
#include "penumbra/geometry/transform.h"

#include <utility>

namespace penumbra {

Mesh transformed(Mesh mesh, const Transform& t) {
  const double side = determinant(t) < 0 ? -1 : 1;
  for (Vec3f& p : mesh.positions) p = Vec3f(apply_point(t, Vec3d(p)));
  for (Vec3f& n : mesh.normals) {
    n = Vec3f(normalize(apply_normal(t, Vec3d(n)) * side));
    // A flattening map leaves some directions without a normal; shading still wants a unit vector.
    if (n == Vec3f{}) n = {0, 0, 1};
  }
  if (side < 0)
    for (Triangle& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
  return mesh;
}

}  // namespace penumbra
