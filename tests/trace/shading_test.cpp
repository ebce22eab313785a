// SPDX-License-Identifier: MIT
#include "penumbra/trace/shading.h"

#include <gtest/gtest.h>

#include <cmath>

namespace penumbra {
namespace {

/// A facet in the plane z = 0 whose smooth normals lean by `lean` towards x.
Scene leaning_facet(float lean) {
  Scene scene;
  Mesh mesh;
  mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {0, 2, 0}};
  mesh.normals.assign(3, normalize(Vec3f{std::sin(lean), 0, std::cos(lean)}));
  mesh.triangles = {{0, 1, 2}};
  scene.shapes.meshes.push_back(mesh);
  scene.materials.emplace_back();
  return scene;
}

float brightness(const Scene& scene, float elevation) {
  const ShadingPoint point =
      shading_point(scene, {ShapeKind::triangle, 0, 0, 0}, {0, 0, 5}, {0, 0, -1}, 5);
  const Vec3f direction{std::cos(elevation), 0, std::sin(elevation)};
  return unshadowed({SunLight{direction, 0.005f}, {1, 1, 1}, Falloff::none}, point).x;
}

TEST(Shading, SmoothNormalsFadeToNothingAtTheFacetsHorizon) {
  const Scene scene = leaning_facet(0.5f);
  float last = 0;
  for (float elevation = 0; elevation < 0.6f; elevation += 0.01f) {
    const float now = brightness(scene, elevation);
    EXPECT_LT(std::abs(now - last), 0.08f) << "a step at elevation " << elevation;
    EXPECT_GE(now, last - 1e-6f);
    last = now;
  }
  EXPECT_EQ(brightness(scene, -0.01f), 0);
}

TEST(Shading, FacetsWithoutNormalsAreLambertian) {
  Scene scene = leaning_facet(0);
  scene.shapes.meshes[0].normals.clear();
  EXPECT_NEAR(brightness(scene, 0.3f), 0.8f * std::sin(0.3f), 1e-5);
}

TEST(Shading, TheNormalFacesTheViewerOnEitherSide) {
  const Scene scene = leaning_facet(0.2f);
  const ShadingPoint above =
      shading_point(scene, {ShapeKind::triangle, 0, 0, 0}, {0, 0, 5}, {0, 0, -1}, 5);
  const ShadingPoint below =
      shading_point(scene, {ShapeKind::triangle, 0, 0, 0}, {0, 0, -5}, {0, 0, 1}, 5);
  EXPECT_GT(above.normal.z, 0);
  EXPECT_LT(below.normal.z, 0);
  EXPECT_LT(below.shading_normal.z, 0);
  EXPECT_GT(above.receiver.z, 0);
  EXPECT_LT(below.receiver.z, 0);
}

TEST(Shading, WhatShinesFromItsFrontAloneIsDarkFromBehind) {
  Scene scene = leaning_facet(0);
  scene.materials[0].emission = {2, 2, 2};
  const auto seen_from = [&](double z) {
    return emitted(shading_point(scene, {ShapeKind::triangle, 0, 0, 0}, {0, 0, z}, {0, 0, -z}, 1))
        .x;
  };
  EXPECT_EQ(seen_from(5), 2);
  EXPECT_EQ(seen_from(-5), 2);
  scene.materials[0].emits_from_back = false;
  EXPECT_EQ(seen_from(5) + seen_from(-5), 2);
}

TEST(Shading, RefractionObeysSnell) {
  Scene scene = leaning_facet(0);
  scene.materials[0].refraction_index = 1.5f;
  const Vec3d in = normalize(Vec3d{1, 0, -1});
  const ShadingPoint point = shading_point(scene, {ShapeKind::triangle, 0, 0, 0}, in * -5.0, in, 5);
  const auto out = refracted_direction(point);
  ASSERT_TRUE(out);
  EXPECT_NEAR(normalize(*out).x, std::sin(0.78539816) / 1.5, 1e-6);
  EXPECT_LT(out->z, 0);
  // From inside at 60 degrees nothing gets out of glass.
  const Vec3d steep = normalize(Vec3d{std::sqrt(3.0), 0, 1});
  EXPECT_FALSE(refracted_direction(
      shading_point(scene, {ShapeKind::triangle, 0, 0, 0}, steep * -5.0, steep, 5)));
}

}  // namespace
}  // namespace penumbra
