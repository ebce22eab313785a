// SPDX-License-Identifier: MIT
#include "penumbra/geometry/mesh_solids.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <utility>

#include "penumbra/geometry/surface_parity.h"
#include "tests/geometry/solid_meshes.h"

namespace penumbra {
namespace {

using namespace solid_meshes;

std::vector<MeshSolid> solids_of(const Mesh& mesh) {
  return mesh_solids(std::vector<Mesh>{mesh}, {}, {.most_volumes = 30});
}

class Random {
 public:
  double uniform(double lo, double hi) {
    return std::uniform_real_distribution<double>(lo, hi)(engine_);
  }
  Vec3d direction() {
    for (;;) {
      const Vec3d v{uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)};
      if (length(v) > 0.01 && length(v) < 1) return normalize(v);
    }
  }

 private:
  std::mt19937_64 engine_{7};
};

/// Whether the segment crosses the triangle, by signed volumes in long double: independent of how
/// solids are made. Edges count.
bool crosses(const FlatTriangle& t, Vec3d from, Vec3d to) {
  using Wide = long double;
  const auto volume = [](Vec3d a, Vec3d b, Vec3d c, Vec3d d) -> Wide {
    const Vec3<Wide> x(b - a), y(c - a), z(d - a);
    return dot(x, cross(y, z));
  };
  const Vec3d a(t.a), b(t.b), c(t.c);
  const Wide before = volume(a, b, c, from), behind = volume(a, b, c, to);
  if ((before > 0) == (behind > 0)) return false;
  const Wide u = volume(from, to, a, b), v = volume(from, to, b, c), w = volume(from, to, c, a);
  return (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
}

bool is_crossed(const ClosedSurface& surface, Vec3d from, Vec3d to) {
  return std::any_of(surface.triangles.begin(), surface.triangles.end(),
                     [&](const FlatTriangle& t) { return crosses(t, from, to); });
}

/// A random point of the ball or the polyhedron.
Vec3d point_in(const InnerVolume& volume, Random& random) {
  if (random.uniform(0, 1) < 0.3)
    return volume.center + random.direction() * (volume.radius * random.uniform(0, 1));
  const Vec3d d = random.direction();
  double reach = volume.body.outer;
  for (const HalfSpace& face : volume.body.faces)
    if (dot(face.normal, d) > 0) reach = std::min(reach, face.offset / dot(face.normal, d));
  return volume.center + d * (reach * random.uniform(0, 1));
}

/// Contract (1): no way out, and no triangle within. Returns how many volumes there are.
std::size_t expect_enclosed(const std::vector<MeshSolid>& solids, int tries) {
  Random random;
  std::size_t count = 0;
  for (const MeshSolid& solid : solids) {
    const Box& box = solid.surface.box;
    const double size = length(Vec3d(box.hi) - Vec3d(box.lo));
    EXPECT_FALSE(solid.volumes.empty());
    for (const InnerVolume& volume : solid.volumes) {
      ++count;
      EXPECT_GT(volume.radius, 0);
      for (int i = 0; i < tries; ++i) {
        const Vec3d p = point_in(volume, random), q = point_in(volume, random);
        const Vec3d out = Vec3d(box.center()) + random.direction() * (2 * size);
        if (!is_crossed(solid.surface, p, out)) {
          ADD_FAILURE() << "a way out of a volume at " << volume.center.x << ' ' << volume.center.y
                        << ' ' << volume.center.z;
          return count;
        }
        const bool is_body =
            volume.body.holds(p - volume.center) && volume.body.holds(q - volume.center);
        EXPECT_FALSE(is_body && is_crossed(solid.surface, p, q));
      }
    }
  }
  return count;
}

/// Share of the points inside of a mesh that a volume holds.
double covered(const std::vector<MeshSolid>& solids) {
  double inside = 0, held = 0;
  for (const MeshSolid& solid : solids)
    for (const Vec3d& p : inside_points(solid.surface.triangles, 20)) {
      ++inside;
      held += std::any_of(solid.volumes.begin(), solid.volumes.end(), [&](const InnerVolume& v) {
        return length(p - v.center) <= v.radius || v.body.holds(p - v.center);
      });
    }
  return held / inside;
}

TEST(MeshSolids, ABoxIsOnePolyhedronOfItsSixPlanes) {
  const auto solids = solids_of(placed(box(), 2, {5, 6, 7}));
  ASSERT_EQ(solids.size(), 1u);
  ASSERT_EQ(solids[0].volumes.size(), 1u);
  const InnerVolume& volume = solids[0].volumes[0];
  EXPECT_NEAR(volume.radius, 2, 0.2);
  ASSERT_EQ(volume.body.faces.size(), 6u);
  EXPECT_EQ(volume.body.edges.size(), 12u);
  for (const HalfSpace& face : volume.body.faces) {
    EXPECT_NEAR(max_abs(face.normal), 1, 1e-12);
    EXPECT_NEAR(face.offset + dot(face.normal, volume.center - Vec3d(5, 6, 7)), 2, 0.05);
  }
  expect_enclosed(solids, 2000);
}

TEST(MeshSolids, ThinPlatesAtAnyAngleHaveVolumes) {
  Random random;
  for (int i = 0; i < 20; ++i) {
    Mesh plate = box();
    const Frame<double> frame = frame_around(random.direction());
    for (Vec3f& p : plate.positions)
      p = Vec3f(frame.u * (10.0 * p.x) + frame.v * (7.0 * p.y) + frame.n * (0.02 * p.z));
    const auto solids = solids_of(plate);
    ASSERT_EQ(solids.size(), 1u);
    EXPECT_GT(covered(solids), 0.9);
    expect_enclosed(solids, 200);
  }
}

TEST(MeshSolids, CurvedSolidsAreMostlyFilled) {
  for (const auto& [mesh, least] :
       {std::pair{globe(12), 0.85}, std::pair{globe(24, 0.3), 0.85}, std::pair{torus(40, 20), 0.75},
        std::pair{corner_piece(), 0.9}}) {
    const auto solids = solids_of(mesh);
    ASSERT_EQ(solids.size(), 1u);
    EXPECT_GT(covered(solids), least);
    EXPECT_EQ(solids[0].surface.first_fill, mesh.triangles.size());
    expect_enclosed(solids, 20);
  }
}

TEST(MeshSolids, AnOpenBoxIsClosedByAFill) {
  Mesh mesh = box();
  mesh.triangles.resize(10);
  const auto solids = solids_of(mesh);
  ASSERT_EQ(solids.size(), 1u);
  ASSERT_EQ(solids[0].surface.fills().size(), 2u);
  for (const FlatTriangle& fill : solids[0].surface.fills())
    EXPECT_EQ(Vec3f(fill.a.x, fill.b.x, fill.c.x), Vec3f(1, 1, 1));
  expect_enclosed(solids, 2000);
}

TEST(MeshSolids, LongAndTouchingHolesAreFilledToo) {
  Mesh sliced = globe(16, 0.2, 3);  // its hole is ugly, not flat
  Mesh holed = globe(16);
  std::erase_if(holed.triangles, [n = 0](const Triangle&) mutable { return n++ % 7 == 3; });
  for (const Mesh& mesh : {sliced, holed}) {
    const auto solids = solids_of(mesh);
    ASSERT_EQ(solids.size(), 1u);
    EXPECT_FALSE(solids[0].surface.fills().empty());
    EXPECT_GT(covered(solids), 0.7);
    expect_enclosed(solids, 50);
  }
}

TEST(MeshSolids, StripsSheetsAndSoupProveNothing) {
  expect_enclosed(solids_of(moebius_strip(40)), 500);  // whatever its fan encloses
  Mesh sheet = box();
  sheet.triangles.resize(2);
  EXPECT_TRUE(solids_of(sheet).empty());
  Mesh soup;
  Random random;
  for (std::uint32_t i = 0; i < 3000; ++i) {
    soup.positions.push_back(Vec3f(random.direction()));
    if (i % 3 == 2) soup.triangles.push_back({i - 2, i - 1, i});
  }
  EXPECT_TRUE(solids_of(soup).empty());
  EXPECT_TRUE(solids_of(Mesh{}).empty());
}

TEST(MeshSolids, TwoSidedModelsCountOnce) {
  Mesh mesh = globe(10);
  const std::vector<Triangle> outside = mesh.triangles;
  for (const Triangle& t : outside) mesh.triangles.push_back({t[0], t[2], t[1]});
  const auto solids = solids_of(mesh);
  ASSERT_EQ(solids.size(), 1u);
  EXPECT_EQ(solids[0].surface.triangles.size(), outside.size());
  EXPECT_GT(covered(solids), 0.8);
  expect_enclosed(solids, 50);

  Mesh odd = globe(10);
  odd.triangles.push_back(odd.triangles[100]);  // shared edges: three triangles
  odd.triangles.push_back(odd.triangles[100]);
  expect_enclosed(solids_of(odd), 50);
  odd.triangles.pop_back();
  expect_enclosed(solids_of(odd), 50);
}

TEST(MeshSolids, BoxesThatShareAnEdgeOrAFaceAreSolid) {
  for (const Vec3f offset : {Vec3f(2, 2, 0), Vec3f(2, 0, 0)}) {
    const auto solids = solids_of(joined(box(), placed(box(), 1, offset)));
    ASSERT_EQ(solids.size(), 1u);
    EXPECT_GT(covered(solids), 0.95);
    EXPECT_GE(expect_enclosed(solids, 1000), 2u);
  }
}

TEST(MeshSolids, ABoxWithAWallInsideIsSolid) {
  Mesh mesh = box();
  // A sheet between four of its corners: its edges are shared by three triangles.
  mesh.triangles.push_back({0, 3, 7});
  mesh.triangles.push_back({0, 7, 4});
  expect_enclosed(solids_of(mesh), 1000);
}

TEST(MeshSolids, SurfacesThatCrossThemselvesAreSolidWhereTheParityIsOdd) {
  const auto solids = solids_of(crossed_torus(48, 24));
  ASSERT_EQ(solids.size(), 1u);
  EXPECT_GT(covered(solids), 0.6);
  expect_enclosed(solids, 20);
}

TEST(MeshSolids, NestedShellsAreSolidsEachForItself) {
  const auto solids = solids_of(joined(globe(10), placed(globe(10), 0.5f, {})));
  ASSERT_EQ(solids.size(), 2u);
  EXPECT_GT(solids[0].volumes[0].radius, 0.8);
  EXPECT_LT(solids[1].volumes[0].radius, 0.6);
  expect_enclosed(solids, 20);
}

TEST(MeshSolids, WhatCastsNoShadowLeavesAHole) {
  Mesh mesh = box();
  mesh.surfaces = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1};
  const std::vector<Mesh> meshes{mesh};
  EXPECT_EQ(mesh_solids(meshes, {}, {})[0].surface.fills().size(), 0u);
  const auto solids = mesh_solids(meshes, {false, true}, {});
  ASSERT_EQ(solids.size(), 1u);
  EXPECT_EQ(solids[0].surface.fills().size(), 2u);
  EXPECT_TRUE(mesh_solids(meshes, {true, true}, {}).empty());
}

TEST(MeshSolids, PartsOfSeveralMeshesMakeOneSolid) {
  Mesh side = box(), rest = box();
  side.triangles = {side.triangles[10], side.triangles[11]};
  rest.triangles.resize(10);
  const auto solids = mesh_solids(std::vector<Mesh>{rest, side}, {}, {});
  ASSERT_EQ(solids.size(), 1u);
  EXPECT_TRUE(solids[0].surface.fills().empty());
}

TEST(MeshSolids, SliversAndNeedlesDoNoHarm) {
  Mesh needles = globe(40);  // triangles at the poles are needles; flattened, all are slivers
  for (Vec3f& p : needles.positions) p = {p.x * 0.1f, p.y * 100, p.z};
  const auto solids = solids_of(needles);
  ASSERT_EQ(solids.size(), 1u);
  expect_enclosed(solids, 20);
}

TEST(MeshSolids, AnyScaleAndPlaceWillDo) {
  for (const float scale : {1e-20f, 1e-6f, 1.0f, 1e10f, 1e14f}) {
    for (const float far : {0.0f, 1.0f, 100.0f}) {
      const auto solids = solids_of(placed(globe(8), scale, Vec3f(far, -far, 0.5f * far) * scale));
      ASSERT_EQ(solids.size(), 1u) << scale << ' ' << far;
      EXPECT_GT(covered(solids), 0.75);
      expect_enclosed(solids, 20);
    }
  }
  // So far out that float has steps of an eighth of the ball.
  expect_enclosed(solids_of(placed(globe(8), 1, {2e6f, 0, 2e6f})), 50);
  expect_enclosed(solids_of(placed(globe(8), 1, {1e9f, 0, 2e6f})), 50);
}

TEST(MeshSolids, ThousandsOfSmallPartsStayCheap) {
  Mesh many;
  Random random;
  for (int i = 0; i < 5000; ++i)
    many = joined(std::move(many), placed(box(), 0.01f, Vec3f(random.direction())));
  const auto solids = solids_of(many);
  EXPECT_EQ(solids.size(), 4096u);
}

TEST(MeshSolids, AreTheSameEachTime) {
  const auto once = solids_of(torus(30, 12)), again = solids_of(torus(30, 12));
  ASSERT_EQ(once[0].volumes.size(), again[0].volumes.size());
  for (std::size_t i = 0; i < once[0].volumes.size(); ++i) {
    EXPECT_EQ(once[0].volumes[i].center, again[0].volumes[i].center);
    EXPECT_EQ(once[0].volumes[i].radius, again[0].volumes[i].radius);
    EXPECT_EQ(once[0].volumes[i].body.faces.size(), again[0].volumes[i].body.faces.size());
  }
}

}  // namespace
}  // namespace penumbra
