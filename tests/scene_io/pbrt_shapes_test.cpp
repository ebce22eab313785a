// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/pbrt_shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/scene_io/pbrt_text.h"
#include "tests/scene_io/temporary_folder.h"

namespace penumbra {
namespace {

constexpr double pi = std::numbers::pi;

ShapeSet shapes_of(const std::string& text) { return read_pbrt_text(text).scene.shapes; }

Vec3d face_normal(const Mesh& mesh, std::size_t i = 0) {
  const Triangle& t = mesh.triangles[i];
  const Vec3d a(mesh.positions[t[0]]), b(mesh.positions[t[1]]), c(mesh.positions[t[2]]);
  return normalize(cross(b - a, c - a));
}

void expect_near(Vec3d a, Vec3d b) {
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(a[axis], b[axis], 1e-5) << axis;
}

TEST(PbrtShapes, SpheresStayExactUnderSimilarities) {
  const ShapeSet shapes = shapes_of(
      "Translate 1 2 3 Rotate 30 1 2 3 Scale -2 2 2 Shape \"sphere\" "
      "\"float radius\" 1.5");
  ASSERT_EQ(shapes.spheres.size(), 1u);
  EXPECT_EQ(shapes.spheres[0].center, Vec3f(1, 2, 3));
  EXPECT_NEAR(shapes.spheres[0].radius, 3, 1e-6);
}

TEST(PbrtShapes, OtherSpheresAreMeshes) {
  const ShapeSet stretched = shapes_of("Scale 1 1 3 Shape \"sphere\"");
  ASSERT_EQ(stretched.meshes.size(), 1u);
  EXPECT_NEAR(bounds(stretched.meshes[0]).hi.z, 3, 1e-6);
  const ShapeSet part = shapes_of("Shape \"sphere\" \"float zmin\" 0 \"float phimax\" 180");
  ASSERT_EQ(part.meshes.size(), 1u);
  EXPECT_NEAR(area(part.meshes[0]), pi, 0.01);
  EXPECT_GE(bounds(part.meshes[0]).lo.y, -1e-6f);
  EXPECT_GE(bounds(part.meshes[0]).lo.z, 0);
}

TEST(PbrtShapes, CylindersMayBeLengthened) {
  const ShapeSet shapes = shapes_of("Scale 2 2 5 Shape \"cylinder\" \"float zmax\" 3");
  ASSERT_EQ(shapes.cones.size(), 1u);
  EXPECT_EQ(shapes.cones[0].base, Vec3f(0, 0, -5));
  EXPECT_EQ(shapes.cones[0].apex, Vec3f(0, 0, 15));
  EXPECT_EQ(shapes.cones[0].base_radius, 2);
  EXPECT_EQ(shapes.cones[0].caps, Caps::open);
  EXPECT_EQ(shapes_of("Scale 1 2 1 Shape \"cylinder\"").meshes.size(), 1u);
  EXPECT_EQ(shapes_of("Shape \"cylinder\" \"float phimax\" 90").meshes.size(), 1u);
}

TEST(PbrtShapes, DisksAreRingsWhereCirclesStay) {
  const ShapeSet shapes = shapes_of(
      "Rotate 90 1 0 0 Scale 2 2 7 Shape \"disk\" \"float height\" 1 "
      "\"float innerradius\" 0.5");
  ASSERT_EQ(shapes.rings.size(), 1u);
  expect_near(Vec3d(shapes.rings[0].center), {0, -7, 0});
  expect_near(Vec3d(shapes.rings[0].normal), {0, -1, 0});
  EXPECT_NEAR(shapes.rings[0].radius, 2, 1e-6);
  EXPECT_NEAR(shapes.rings[0].inner_radius, 1, 1e-6);
  EXPECT_EQ(shapes_of("Scale 1 2 1 Shape \"disk\"").meshes.size(), 1u);
}

TEST(PbrtShapes, TrianglesFaceWhereTheirNormalsPoint) {
  const std::string mesh = "Shape \"trianglemesh\" \"point3 P\" [0 0 0 1 0 0 0 1 0] ";
  expect_near(face_normal(shapes_of(mesh).meshes[0]), {0, 0, 1});
  expect_near(face_normal(shapes_of("ReverseOrientation " + mesh).meshes[0]), {0, 0, -1});
  expect_near(face_normal(shapes_of("Scale -1 1 1 " + mesh).meshes[0]), {0, 0, 1});
  const std::string down = mesh + "\"normal N\" [0 0 -1 0 0 -1 0 0 -1]";
  expect_near(face_normal(shapes_of(down).meshes[0]), {0, 0, -1});
  const ShapeSet reversed = shapes_of("ReverseOrientation " + down);
  expect_near(face_normal(reversed.meshes[0]), {0, 0, 1});
  EXPECT_EQ(reversed.meshes[0].normals[0], Vec3f(0, 0, 1));
}

TEST(PbrtShapes, ListsOfVerticesAreChecked) {
  const std::string mesh = "\nShape \"trianglemesh\" \"point3 P\" [0 0 0 1 0 0 0 1 0 1 1 0] ";
  EXPECT_TRUE(holds(pbrt_error(mesh), "t.pbrt:2: a mesh without a list"));
  EXPECT_TRUE(holds(pbrt_error(mesh + "\"integer indices\" [0 1 4]"), "names vertex 4, but"));
  EXPECT_TRUE(holds(pbrt_error(mesh + "\"integer indices\" [0 1 2 3]"), "do not come in 3s"));
  EXPECT_TRUE(holds(pbrt_error(mesh + "\"integer indices\" [0 1 1.5]"), "names vertex 1.5"));
  EXPECT_TRUE(holds(pbrt_error("Shape \"trianglemesh\""), "a mesh without vertices"));
  EXPECT_TRUE(holds(pbrt_error("Shape \"trianglemesh\" \"point3 P\" [0 0 0 1]"), "threes"));
}

TEST(PbrtShapes, NormalsAndCoordinatesOfOtherCountsAreLeftOutAsPbrtDoes) {
  const PbrtResult r = read_pbrt_text(
      "Shape \"trianglemesh\" \"point3 P\" [0 0 0 1 0 0 0 1 0] \"integer indices\" [0 1 2]\n"
      "\"normal N\" [0 0 1] \"point2 uv\" [0 0 1 1]");
  EXPECT_TRUE(r.scene.shapes.meshes.at(0).normals.empty());
  EXPECT_TRUE(warns(r, "t.pbrt:1: normals that are not one a vertex are left out"));
  EXPECT_TRUE(warns(r, "t.pbrt:1: texture coordinates that are not one a vertex are left out"));
}

TEST(PbrtShapes, BilinearPatchesAreTwoTrianglesWhereFlat) {
  const ShapeSet flat = shapes_of("Shape \"bilinearmesh\" \"point3 P\" [0 0 0 2 0 0 0 1 0 2 1 0]");
  ASSERT_EQ(flat.meshes.size(), 1u);
  EXPECT_EQ(flat.meshes[0].triangles.size(), 2u);
  EXPECT_NEAR(area(flat.meshes[0]), 2, 1e-6);
  expect_near(face_normal(flat.meshes[0]), {0, 0, 1});
  const ShapeSet saddle =
      shapes_of("Shape \"bilinearmesh\" \"point3 P\" [0 0 0 1 0 0 0 1 0 1 1 1]");
  ASSERT_EQ(saddle.meshes.size(), 1u);
  EXPECT_EQ(saddle.meshes[0].triangles.size(), 128u);
  for (const Vec3f& p : saddle.meshes[0].positions) EXPECT_NEAR(p.z, p.x * p.y, 1e-6);
}

TEST(PbrtShapes, CurvesAreChainsOfCones) {
  const ShapeSet bent = shapes_of(
      "Scale 2 2 2 Shape \"curve\" \"point3 P\" [0 0 0 0 1 0 1 1 0 1 0 "
      "0] \"float width0\" 0.2 \"float width1\" 0.1");
  ASSERT_EQ(bent.cones.size(), 8u);
  EXPECT_EQ(bent.cones.front().base, Vec3f(0, 0, 0));
  EXPECT_EQ(bent.cones.back().apex, Vec3f(2, 0, 0));
  EXPECT_NEAR(bent.cones.front().base_radius, 0.2, 1e-6);
  EXPECT_NEAR(bent.cones.back().apex_radius, 0.1, 1e-6);
  for (std::size_t i = 1; i < 8; ++i) EXPECT_EQ(bent.cones[i].base, bent.cones[i - 1].apex);
  // Equally spaced control points: a B-spline goes along their line, without the first and last.
  const ShapeSet line = shapes_of(
      "Shape \"curve\" \"string basis\" \"bspline\" \"point3 P\" [0 0 0 "
      "1 0 0 2 0 0 3 0 0 4 0 0]");
  ASSERT_EQ(line.cones.size(), 2u);
  expect_near(Vec3d(line.cones[0].base), {1, 0, 0});
  expect_near(Vec3d(line.cones[1].apex), {3, 0, 0});
  EXPECT_TRUE(
      holds(pbrt_error("Shape \"curve\" \"point3 P\" [0 0 0 1 0 0]"), "cannot have 2 points"));
}

TEST(PbrtShapes, LoopSurfacesAreTheirBaseMesh) {
  const PbrtResult r = read_pbrt_text(
      "Shape \"loopsubdiv\" \"integer levels\" 3 \"point3 P\" [0 0 0 1 0 0 0 1 0] \"integer "
      "indices\" [0 1 2]");
  EXPECT_EQ(r.scene.shapes.meshes[0].triangles.size(), 1u);
  EXPECT_TRUE(warns(r, "base mesh"));
}

TEST(PbrtShapes, PlyMeshesAreBesideTheScene) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "m");
  folder.put(
      "m/t.ply",
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty "
      "float z\nproperty float u\nproperty float v\nelement face 1\nproperty list uchar int "
      "vertex_indices\nend_header\n0 0 0 0 0\n1 0 0 1 0\n0 1 0 0 1\n3 0 1 2\n");
  const auto read = [&](const std::string& text) {
    return read_pbrt_file(load(folder.put("s.pbrt", text)));
  };
  const Scene scene =
      read("Translate 0 0 4 Shape \"plymesh\" \"string filename\" \"m/t.ply\"").scene;
  ASSERT_EQ(scene.shapes.meshes.size(), 1u);
  EXPECT_EQ(scene.shapes.meshes[0].positions[1], Vec3f(1, 0, 4));
  EXPECT_TRUE(holds(error_of([&] { read("\nShape \"plymesh\" \"string filename\" \"x.ply\""); }),
                    "s.pbrt:2: there is no mesh file `x.ply`"));
}

TEST(PbrtShapes, CurvesOfPointsThatAttributeGivesAreCounted) {
  std::string text = "Attribute \"shape\" \"string basis\" \"bspline\" \"point3 P\" [";
  for (int i = 0; i < 21; ++i) text += i % 2 ? "0 1 0 " : "1 0 0 ";
  text += "]\n";
  for (int i = 0; i < 10'000; ++i) text += "Shape \"curve\" ";
  EXPECT_TRUE(holds(pbrt_error(text), "t.pbrt:2: the scene makes more triangles than fit"));
}

TEST(PbrtShapesSlow, MeshFilesThatAreReadAgainAreCounted) {
  const TemporaryFolder folder;
  std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 500000\nproperty float x\nproperty float y\n"
      "property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
      "end_header\n";
  for (int i = 0; i < 500'000; ++i) ply += i % 2 ? "0 0 1\n" : i % 4 ? "0 1 0\n" : "1 0 0\n";
  folder.put("m.ply", ply + "3 0 1 2\n");
  const auto read = [&](int times) {
    std::string text;
    for (int i = 0; i < times; ++i) text += "Shape \"plymesh\" \"string filename\" \"m.ply\"\n";
    return read_pbrt_file(load(folder.put("s.pbrt", text)));
  };
  EXPECT_EQ(read(2).scene.shapes.meshes.size(), 2u);
  EXPECT_TRUE(holds(error_of([&] { read(40); }), "s.pbrt:35: the same mesh files are read again"));
}

TEST(PbrtShapes, WhatIsNoSurfaceIsNotThere) {
  EXPECT_TRUE(holds(pbrt_error("Shape \"cube\""), "t.pbrt:1: unknown shape `cube`"));
  EXPECT_EQ(shapes_of("Shape \"disk\" Material \"interface\" Shape \"sphere\"").spheres.size(), 0u);
  EXPECT_EQ(shapes_of("Shape \"disk\" Shape \"sphere\" \"float alpha\" 0").spheres.size(), 0u);
  EXPECT_TRUE(warns(read_pbrt_text("Shape \"sphere\" \"float alpha\" 0.5"), "alpha is not read"));
  EXPECT_TRUE(warns(read_pbrt_text("Shape \"disk\" Shape \"sphere\" \"float radius\" 0"),
                    "a shape of no size is left out"));
}

TEST(PbrtShapes, FewNumbersDoNotMakeEndlesslyManyTriangles) {
  std::string text;
  for (int i = 0; i < 20000; ++i) text += "Shape \"sphere\" \"float zmin\" 0\n";
  EXPECT_TRUE(holds(pbrt_error(text), "more triangles than fit"));
}

}  // namespace
}  // namespace penumbra
