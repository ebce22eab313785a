// SPDX-License-Identifier: MIT
#include "penumbra/geometry/transform.h"

#include <gtest/gtest.h>

namespace penumbra {
namespace {

Mesh corner_triangle() {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.normals = {{0, 0, 1}, {0, 0, 1}, {0.6f, 0, 0.8f}};
  mesh.triangles = {{0, 1, 2}};
  return mesh;
}

Vec3d face_normal(const Mesh& mesh) {
  const auto at = [&](int k) { return Vec3d(mesh.positions[mesh.triangles[0][k]]); };
  return normalize(cross(at(1) - at(0), at(2) - at(0)));
}

TEST(Transform, ComposedMapsActInOrder) {
  const Transform scale{{2, 0, 0}, {0, 3, 0}, {0, 0, 4}, {1, 1, 1}};
  const Transform turn{{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}, {5, 0, 0}};
  const Vec3d p{1, 2, 3};
  EXPECT_EQ(apply_point(compose(turn, scale), p), apply_point(turn, apply_point(scale, p)));
  EXPECT_EQ(determinant(compose(turn, scale)), 24);
}

TEST(Transform, NormalsStayPerpendicularUnderShear) {
  const Mesh mesh = transformed(corner_triangle(), {{1, 0, 2}, {0, 1, -1}, {0, 0, 3}, {7, 8, 9}});
  const Vec3d face = face_normal(mesh);
  EXPECT_NEAR(dot(face, Vec3d(mesh.normals[0])), 1, 1e-6);
  EXPECT_NEAR(length(Vec3d(mesh.normals[2])), 1, 1e-6);
}

TEST(Transform, MirrorsKeepOutsideOutside) {
  const Mesh mesh = transformed(corner_triangle(), {{-1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {}});
  EXPECT_NEAR(dot(face_normal(mesh), {0, 0, 1}), 1, 1e-6);
  EXPECT_EQ(mesh.normals[2], Vec3f(-0.6f, 0, 0.8f));
}

TEST(Transform, NormalsStayUnitWhereTheMapFlattens) {
  const Mesh mesh = transformed(corner_triangle(), {{0, 0, 0}, {0, 1, 0}, {0, 0, 0}, {}});
  for (const Vec3f& n : mesh.normals) EXPECT_FLOAT_EQ(length(n), 1);
}

}  // namespace
}  // namespace penumbra
