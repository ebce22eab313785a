// SPDX-License-Identifier: MIT
#include "penumbra/scene/scene.h"

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "penumbra/scene/check_light.h"
#include "penumbra/scene/error.h"
#include "tests/geometry/light_shapes.h"

namespace penumbra {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

/// A scene of one thing of each kind that passes.
Scene good_scene() {
  Scene scene;
  scene.name = "test.nff";
  scene.materials.emplace_back();
  scene.shapes.spheres.push_back({{0, 0, 0}, 1, 0});
  scene.shapes.cones.push_back({{0, 0, 0}, {0, 0, 1}, 1, 0, Caps::open, 0});
  scene.shapes.rings.push_back({{0, 0, 0}, {0, 0, 2}, 1, 0.5f, 0});
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  scene.shapes.meshes.push_back(mesh);
  scene.lights = {{PointLight{{0, 0, 5}}, {1, 1, 1}, Falloff::none},
                  {BallLight{{0, 0, 5}, 1}, {1, 1, 1}, Falloff::none},
                  {ParallelogramLight{{0, 0, 5}, {1, 0, 0}, {0, 1, 0}}, {1, 1, 1}, Falloff::none},
                  {DiskLight{{0, 0, 5}, {0, 0, 2}, 1}, {1, 1, 1}, Falloff::none},
                  {LineLight{{0, 0, 5}, {1, 0, 0}}, {1, 1, 1}, Falloff::none},
                  {polygon_around({0, 0, 5}, {1, 0, 0}, {0, 1, 0}, 5), {1, 1, 1}, Falloff::none},
                  {box_around({0, 0, 5}, {1, 1, 1}), {1, 1, 1}, Falloff::none},
                  {SunLight{{0, 0, 3}, 0.005f}, {1, 1, 1}, Falloff::none}};
  scene.camera = Camera{};
  scene.background = Color{};
  return scene;
}

/// What validate says after one change.
std::string problem_after(const std::function<void(Scene&)>& change) {
  Scene scene = good_scene();
  change(scene);
  try {
    validate(scene);
  } catch (const Error& error) {
    EXPECT_EQ(error.place.file, "test.nff");
    EXPECT_FALSE(error.hint.empty());
    return error.problem;
  }
  return "";
}

Sphere& sphere(Scene& s) { return s.shapes.spheres[0]; }
Cone& cone(Scene& s) { return s.shapes.cones[0]; }
Ring& ring(Scene& s) { return s.shapes.rings[0]; }
Mesh& mesh(Scene& s) { return s.shapes.meshes[0]; }
template <typename Shape>
Shape& light(Scene& s) {
  for (Light& l : s.lights)
    if (auto* shape = std::get_if<Shape>(&l.shape)) return *shape;
  throw std::logic_error("no such light");
}

TEST(Validate, GoodScenePasses) {
  EXPECT_EQ(problem_after([](Scene&) {}), "");
}

TEST(Validate, CoordinatesMustBeFiniteAndInRange) {
  for (float bad : {nan, infinity, -infinity, 1.01e15f, -1e20f}) {
    EXPECT_NE(problem_after([&](Scene& s) { sphere(s).center.y = bad; }), "") << bad;
    EXPECT_NE(problem_after([&](Scene& s) { cone(s).base.x = bad; }), "") << bad;
    EXPECT_NE(problem_after([&](Scene& s) { cone(s).apex.z = bad; }), "") << bad;
    EXPECT_NE(problem_after([&](Scene& s) { ring(s).center.x = bad; }), "") << bad;
    EXPECT_NE(problem_after([&](Scene& s) { mesh(s).positions[1].z = bad; }), "") << bad;
    EXPECT_NE(problem_after([&](Scene& s) { light<PointLight>(s).center.x = bad; }), "") << bad;
    EXPECT_NE(problem_after([&](Scene& s) { light<BallLight>(s).center.x = bad; }), "") << bad;
    EXPECT_NE(problem_after([&](Scene& s) { light<ParallelogramLight>(s).u.x = bad; }), "") << bad;
    EXPECT_NE(problem_after([&](Scene& s) { light<DiskLight>(s).center.y = bad; }), "") << bad;
    EXPECT_NE(problem_after([&](Scene& s) { light<LineLight>(s).half.y = bad; }), "") << bad;
    EXPECT_NE(problem_after([&](Scene& s) { light<PolygonLight>(s).corners[3].z = bad; }), "");
    EXPECT_NE(problem_after([&](Scene& s) { light<PolygonLight>(s).center.z = bad; }), "") << bad;
    EXPECT_NE(problem_after([&](Scene& s) { light<MeshLight>(s).corners[0].z = bad; }), "") << bad;
    EXPECT_NE(problem_after([&](Scene& s) { s.camera->from.x = bad; }), "") << bad;
    EXPECT_NE(problem_after([&](Scene& s) { s.camera->at.x = bad; }), "") << bad;
  }
  EXPECT_EQ(problem_after([](Scene& s) { sphere(s).center.y = 1e15f; }), "");
}

TEST(Validate, RadiiMustBePositive) {
  for (float bad : {0.0f, -1.0f, nan, infinity}) {
    EXPECT_NE(problem_after([&](Scene& s) { sphere(s).radius = bad; }), "") << bad;
    EXPECT_NE(problem_after([&](Scene& s) { ring(s).radius = bad; }), "") << bad;
    EXPECT_NE(problem_after([&](Scene& s) { light<BallLight>(s).radius = bad; }), "") << bad;
  }
  for (float bad : {-1.0f, nan, infinity})
    EXPECT_NE(problem_after([&](Scene& s) { cone(s).base_radius = bad; }), "") << bad;
  EXPECT_NE(problem_after([](Scene& s) { cone(s).base_radius = cone(s).apex_radius = 0; }), "");
  EXPECT_NE(problem_after([](Scene& s) { ring(s).inner_radius = 1; }), "");
  EXPECT_NE(problem_after([](Scene& s) { ring(s).inner_radius = nan; }), "");
}

TEST(Validate, ConesNeedALength) {
  EXPECT_NE(problem_after([](Scene& s) { cone(s).apex = cone(s).base; }), "");
}

TEST(Validate, IndicesMustExist) {
  EXPECT_NE(problem_after([](Scene& s) { sphere(s).surface = 1; }), "");
  EXPECT_NE(problem_after([](Scene& s) { cone(s).surface = 1; }), "");
  EXPECT_NE(problem_after([](Scene& s) { ring(s).surface = 1; }), "");
  EXPECT_NE(problem_after([](Scene& s) { mesh(s).surface = 1; }), "");
  EXPECT_NE(problem_after([](Scene& s) { mesh(s).surfaces = {7}; }), "");
  EXPECT_NE(problem_after([](Scene& s) { mesh(s).triangles[0][2] = 3; }), "");
  EXPECT_NE(problem_after([](Scene& s) { mesh(s).triangles[0][0] = 0xffffffffu; }), "");
  EXPECT_NE(problem_after([](Scene& s) { s.materials[0].texture = 0; }), "");
  EXPECT_NE(problem_after([](Scene& s) { s.materials[0].texture = -2; }), "");
}

TEST(Validate, ArraysMustFitEachOther) {
  EXPECT_NE(problem_after([](Scene& s) { mesh(s).normals.resize(2); }), "");
  EXPECT_NE(problem_after([](Scene& s) { mesh(s).uvs.resize(4); }), "");
  EXPECT_NE(problem_after([](Scene& s) { mesh(s).lightmap_uvs.resize(4); }), "");
  EXPECT_NE(problem_after([](Scene& s) { mesh(s).colors.resize(1); }), "");
  EXPECT_NE(problem_after([](Scene& s) { mesh(s).surfaces.resize(2); }), "");
  EXPECT_NE(problem_after([](Scene& s) { s.textures = {{2, 2, {{1, 1, 1}}}}; }), "");
}

TEST(Validate, ColoursMustBeFiniteAndNotNegative) {
  for (float bad : {nan, infinity, -0.1f}) {
    EXPECT_NE(problem_after([&](Scene& s) { s.materials[0].diffuse.y = bad; }), "") << bad;
    EXPECT_NE(problem_after([&](Scene& s) { s.materials[0].mirror.x = bad; }), "") << bad;
    EXPECT_NE(problem_after([&](Scene& s) { s.materials[0].shininess = bad; }), "") << bad;
    EXPECT_NE(problem_after([&](Scene& s) { s.materials[0].refraction_index = bad; }), "") << bad;
    EXPECT_NE(problem_after([&](Scene& s) { s.lights[0].intensity.z = bad; }), "") << bad;
    EXPECT_NE(problem_after([&](Scene& s) { s.ambient.x = bad; }), "") << bad;
    EXPECT_NE(problem_after([&](Scene& s) { s.background->x = bad; }), "") << bad;
    EXPECT_NE(problem_after([&](Scene& s) { mesh(s).colors.assign(3, {bad, 0, 0}); }), "") << bad;
  }
}

TEST(Validate, LightsMustHaveAShape) {
  EXPECT_NE(problem_after([](Scene& s) { light<ParallelogramLight>(s).v = {-2, 0, 0}; }), "");
  EXPECT_NE(problem_after([](Scene& s) { light<ParallelogramLight>(s).u = {0, 0, 0}; }), "");
  EXPECT_NE(problem_after([](Scene& s) { light<SunLight>(s).direction = {0, 0, 0}; }), "");
  EXPECT_NE(problem_after([](Scene& s) { light<SunLight>(s).direction.x = nan; }), "");
  EXPECT_NE(problem_after([](Scene& s) { light<DiskLight>(s).normal = {0, 0, 0}; }), "");
  EXPECT_NE(problem_after([](Scene& s) { light<DiskLight>(s).normal.y = nan; }), "");
  EXPECT_NE(problem_after([](Scene& s) { light<DiskLight>(s).radius = nan; }), "");
  EXPECT_NE(problem_after([](Scene& s) { light<LineLight>(s).half = {0, 0, 0}; }), "");
  EXPECT_NE(problem_after([](Scene& s) { light<PolygonLight>(s).corners.clear(); }), "");
  EXPECT_NE(problem_after([](Scene& s) { light<PolygonLight>(s).corners[2].z = 6; }), "");
  EXPECT_NE(problem_after([](Scene& s) { light<PolygonLight>(s).corners[2] = {0, 0, 5}; }), "");
  EXPECT_NE(problem_after([](Scene& s) { light<PolygonLight>(s).center.z = 6; }), "");
  for (float bad : {-0.1f, nan, std::numbers::pi_v<float> / 2})
    EXPECT_NE(problem_after([&](Scene& s) { light<SunLight>(s).half_angle_rad = bad; }), "") << bad;
}

TEST(Validate, PolygonLightsHoldTheirCentreAndMayBeBentALittle) {
  PolygonLight light{{0, 0, 5}, {{1, 0, 5}, {0, 1, 5.0005f}, {-1, 0, 5}, {0, -1, 5.0005f}}};
  EXPECT_FALSE(problem_of(light));
  light.center = {20, 0, 5};
  EXPECT_TRUE(problem_of(light));
}

TEST(Validate, LightsFitTheScenesScale) {
  Scene scene = good_scene();
  scene.lights[0].shape = LineLight{{0, 0, 5}, {1e5f, 0, 0}};
  EXPECT_NO_THROW(validate(scene));
  scene.lights[0].shape = LineLight{{0, 0, 5}, {1e9f, 0, 0}};
  EXPECT_THROW(validate(scene), Error);
}

TEST(Validate, MeshLightsMustBeClosedConvexAndOutward) {
  EXPECT_NE(problem_after([](Scene& s) { light<MeshLight>(s).corners.clear(); }), "");
  EXPECT_NE(problem_after([](Scene& s) { light<MeshLight>(s).triangles.clear(); }), "");
  EXPECT_NE(problem_after([](Scene& s) { light<MeshLight>(s).triangles.pop_back(); }), "");
  EXPECT_NE(problem_after([](Scene& s) { light<MeshLight>(s).triangles[0][1] = 8; }), "");
  EXPECT_NE(problem_after([](Scene& s) { light<MeshLight>(s).corners[7] = {0, 0, 5}; }), "");
  EXPECT_NE(problem_after([](Scene& s) { light<MeshLight>(s).center = {2, 0, 5}; }), "");
  EXPECT_NE(problem_after([](Scene& s) {
              for (Triangle& t : light<MeshLight>(s).triangles) std::swap(t[0], t[1]);
            }),
            "");
  EXPECT_NE(problem_after([](Scene& s) {
              for (Vec3f& corner : light<MeshLight>(s).corners) corner.z = 5;
            }),
            "");
}

TEST(Validate, BeamsHaveAnAxisAndAnglesInOrder) {
  const auto problem_of_beam = [](std::size_t light, Beam beam) {
    return problem_after([&](Scene& s) { s.lights[light].beam = beam; });
  };
  EXPECT_EQ(problem_of_beam(0, {{0, 0, 3}, 0.5f, 0.25f}), "");
  EXPECT_EQ(problem_of_beam(3, {{0, 0, -1}, 0, 0}), "");
  EXPECT_NE(problem_of_beam(0, {{0, 0, 0}, 0.5f, 0.25f}), "");
  EXPECT_NE(problem_of_beam(0, {{0, 0, nan}, 0.5f, 0.25f}), "");
  EXPECT_NE(problem_of_beam(0, {{0, 0, 1}, 0.25f, 0.5f}), "");
  EXPECT_NE(problem_of_beam(0, {{0, 0, 1}, 1.5f, 0.5f}), "");
  EXPECT_NE(problem_of_beam(0, {{0, 0, 1}, nan, 0.5f}), "");
  EXPECT_NE(problem_of_beam(7, {{0, 0, 1}, 0.5f, 0.25f}), "");
  Scene scene = good_scene();
  scene.lights[0].beam = Beam{{0, 0, 3}, 0.5f, 0.25f};
  validate(scene);
  EXPECT_EQ(scene.lights[0].beam->axis, Vec3f(0, 0, 1));
}

TEST(Validate, CameraNumbersMustBeFinite) {
  EXPECT_NE(problem_after([](Scene& s) { s.camera->fov_deg = nan; }), "");
  EXPECT_NE(problem_after([](Scene& s) { s.camera->near = -1; }), "");
  EXPECT_NE(problem_after([](Scene& s) { s.camera->parallel_height = -1; }), "");
  EXPECT_NE(problem_after([](Scene& s) { s.camera->parallel_height = infinity; }), "");
  EXPECT_NE(problem_after([](Scene& s) { s.camera->window.left = nan; }), "");
  EXPECT_NE(problem_after([](Scene& s) { s.camera->window.right = 0; }), "");
  EXPECT_NE(problem_after([](Scene& s) { s.camera->window.bottom = 1e9; }), "");
  EXPECT_EQ(problem_after([](Scene& s) { s.camera->window = {1, 0.5, -2, 0}; }), "");
  EXPECT_NE(problem_after([](Scene& s) { s.camera->width = 0; }), "");
  EXPECT_NE(problem_after([](Scene& s) { s.up = {0, 0, 0}; }), "");
}

TEST(Validate, SomethingMustBeLeftToDraw) {
  EXPECT_EQ(problem_after([](Scene& s) { s.shapes = {}; }), "nothing to draw");
  EXPECT_EQ(problem_after([](Scene& s) {
              const Mesh m = mesh(s);
              s.shapes = {};
              s.shapes.meshes = {m};
              s.shapes.meshes[0].triangles = {{0, 0, 1}};
            }),
            "nothing to draw");
}

TEST(Validate, DropsAndCountsDegenerateTriangles) {
  Scene scene = good_scene();
  scene.materials.resize(3);
  Mesh& m = mesh(scene);
  m.positions.push_back({2, 0, 0});
  m.triangles = {{0, 0, 1}, {0, 1, 2}, {0, 1, 3}};
  m.surfaces = {0, 2, 1};
  EXPECT_EQ(validate(scene).degenerate_triangles, 2u);
  ASSERT_EQ(mesh(scene).triangles.size(), 1u);
  EXPECT_EQ(mesh(scene).surfaces, std::vector<std::uint32_t>{2});
}

TEST(Validate, MakesDirectionsUnitLength) {
  Scene scene = good_scene();
  scene.up = {0, 3, 4};
  mesh(scene).normals = {{0, 0, 5}, {1e-30f, 0, 0}, {3, 4, 0}};
  validate(scene);
  EXPECT_EQ(ring(scene).normal, (Vec3f{0, 0, 1}));
  EXPECT_EQ(light<SunLight>(scene).direction, (Vec3f{0, 0, 1}));
  EXPECT_EQ(light<DiskLight>(scene).normal, (Vec3f{0, 0, 1}));
  EXPECT_NEAR(scene.up.y, 0.6, 1e-12);
  EXPECT_EQ(mesh(scene).normals[0], (Vec3f{0, 0, 1}));
  EXPECT_EQ(mesh(scene).normals[1], (Vec3f{1, 0, 0}));
  EXPECT_FLOAT_EQ(mesh(scene).normals[2].y, 0.8f);
}

TEST(Validate, MissingNormalsBecomeThoseOfTheFaces) {
  Scene scene = good_scene();
  mesh(scene).normals = {{0, 0, 0}, {nan, 0, 1}, {0, infinity, 0}};
  validate(scene);
  for (Vec3f n : mesh(scene).normals) EXPECT_EQ(n, (Vec3f{0, 0, 1}));
}

TEST(Validate, GivesASceneWithoutMaterialsOne) {
  Scene scene = good_scene();
  scene.materials.clear();
  validate(scene);
  EXPECT_EQ(scene.materials.size(), 1u);
}

TEST(Validate, IsIdempotent) {
  Scene scene = good_scene();
  mesh(scene).normals = {{0.1f, 0.2f, 0.3f}, {1, 1, 1}, {-3, 1, 9}};
  validate(scene);
  Scene again = scene;
  EXPECT_EQ(validate(again).degenerate_triangles, 0u);
  EXPECT_EQ(mesh(again).normals, mesh(scene).normals);
}

}  // namespace
}  // namespace penumbra
