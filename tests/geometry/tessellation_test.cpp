// SPDX-License-Identifier: MIT
#include "penumbra/geometry/tessellation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace penumbra {
namespace {

constexpr double pi = std::numbers::pi;

bool is_closed(const Mesh& mesh) {
  const MeshTopology found = topology(mesh);
  return found.is_closed.size() == 1 && found.is_closed[0] && found.boundary_edges == 0;
}

/// Triangles turn the way their vertices' normals point, none is degenerate, and `error` (how far a
/// point is from the shape) is small at each vertex.
void check(Mesh mesh, const std::function<double(Vec3d)>& error) {
  ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    EXPECT_NEAR(error(Vec3d(mesh.positions[i])), 0, 1e-6);
    EXPECT_NEAR(length(Vec3d(mesh.normals[i])), 1, 1e-6);
  }
  for (const Triangle& t : mesh.triangles) {
    const Vec3d a(mesh.positions[t[0]]), b(mesh.positions[t[1]]), c(mesh.positions[t[2]]);
    const Vec3d normal = normalize(cross(b - a, c - a));
    for (const std::uint32_t corner : t)
      EXPECT_GT(dot(normal, Vec3d(mesh.normals[corner])), 0.5) << t[0] << ' ' << t[1];
  }
  EXPECT_EQ(drop_degenerate_triangles(mesh), 0u);
}

TEST(Tessellation, SpheresAreClosedAndConvergeToTheirArea) {
  const Sphere sphere{{1, 2, 3}, 2, 7};
  const Mesh mesh = tessellated(sphere, 64);
  check(mesh, [&](Vec3d p) { return length(p - Vec3d(sphere.center)) - 2; });
  EXPECT_TRUE(is_closed(mesh));
  EXPECT_NEAR(area(mesh), 4 * pi * 4, 0.01 * 4 * pi * 4);
  EXPECT_EQ(mesh.surface, 7u);
}

TEST(Tessellation, SphereZonesKeepToTheirHeightsAndAngle) {
  const SphereZone zone{2, -1, 1.5, pi / 2};
  const Mesh mesh = tessellated(zone, 256);
  check(mesh, [](Vec3d p) { return length(p) - 2; });
  EXPECT_NEAR(area(mesh), 2 * pi * 2 * 2.5 / 4, 0.01);  // Archimedes: 2 pi R h
  for (const Vec3f& p : mesh.positions) {
    EXPECT_TRUE(p.z >= -1 - 1e-6f && p.z <= 1.5f + 1e-6f);
    EXPECT_TRUE(p.x >= -1e-6f && p.y >= -1e-6f);
  }
}

TEST(Tessellation, ZonesThatReachBeyondTheSphereEndAtItsPole) {
  const Mesh mesh = tessellated(SphereZone{1, 0, 5, full_turn_rad}, 64);
  check(mesh, [](Vec3d p) { return length(p) - 1; });
  EXPECT_NEAR(area(mesh), 2 * pi, 0.05);
}

TEST(Tessellation, WallsAndSectorsHaveTheirAreas) {
  const Mesh wall = tessellated(CylinderWall{3, -1, 1, pi}, 128);
  check(wall, [](Vec3d p) { return std::hypot(p.x, p.y) - 3; });
  EXPECT_NEAR(area(wall), 3 * pi * 2, 0.01);
  EXPECT_EQ(wall.triangles.size(), 128u);

  const Mesh sector = tessellated(DiskSector{2, 1, 5, pi / 2}, 256);
  check(sector, [](Vec3d p) { return p.z - 5; });
  EXPECT_NEAR(area(sector), pi * (4 - 1) / 4, 0.01);
  for (const Vec3f& n : sector.normals) EXPECT_EQ(n, Vec3f(0, 0, 1));

  const Mesh disk = tessellated(DiskSector{1, 0, 0, full_turn_rad}, 12);
  EXPECT_EQ(disk.triangles.size(), 12u);
}

TEST(Tessellation, CappedConesAreClosed) {
  Cone cone{{1, 0, 0}, {1, 4, 3}, 2, 1, Caps::capped, 3};
  for (const float apex_radius : {1.0f, 0.0f, 2.0f}) {
    cone.apex_radius = apex_radius;
    const Mesh mesh = tessellated(cone, 64);
    EXPECT_TRUE(is_closed(mesh)) << apex_radius;
    check(mesh, [](Vec3d) { return 0.0; });
    EXPECT_EQ(mesh.surface, 3u);
  }
}

TEST(Tessellation, OpenConesAreTheirSides) {
  const Cone cone{{0, 0, 2}, {0, 0, 5}, 4, 0, Caps::open, 0};
  const Mesh mesh = tessellated(cone, 256);
  check(mesh, [](Vec3d p) { return std::hypot(p.x, p.y) - 4 * (5 - p.z) / 3; });
  EXPECT_NEAR(area(mesh), pi * 4 * 5, 0.02);
  EXPECT_EQ(mesh.triangles.size(), 256u);
}

TEST(Tessellation, RingsFaceAlongTheirNormal) {
  const Ring ring{{1, 1, 1}, {0, -1, 0}, 3, 2, 5};
  const Mesh mesh = tessellated(ring, 256);
  check(mesh, [](Vec3d p) { return p.y - 1; });
  EXPECT_NEAR(area(mesh), pi * (9 - 4), 0.01);
  EXPECT_NEAR(mesh.normals[0].y, -1, 1e-6);
  EXPECT_EQ(mesh.surface, 5u);
}

}  // namespace
}  // namespace penumbra
