// SPDX-License-Identifier: MIT
#include "penumbra/scene/complete_scene.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "penumbra/scene/error.h"

namespace penumbra {
namespace {

/// A box of these two corners, as a model without surroundings.
Scene box_scene(Vec3f lo, Vec3f hi) {
  Scene scene;
  Mesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.positions.push_back({i & 1 ? hi.x : lo.x, i & 2 ? hi.y : lo.y, i & 4 ? hi.z : lo.z});
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  scene.shapes.meshes.push_back(mesh);
  scene.wants_ground = true;
  validate(scene);
  return scene;
}

/// Image position of p: both in [0, 1] inside the picture.
struct ImagePoint {
  double x = 0, y = 0, depth = 0;
};
ImagePoint project(const Camera& camera, Vec3d p) {
  const CameraFrame f = frame(camera, 1);
  const Vec3d offset = p - f.origin;
  const double depth = dot(offset, f.forward);
  return {0.5 + dot(offset, f.right) / length_squared(f.right) / depth / 2,
          0.5 - dot(offset, f.up) / length_squared(f.up) / depth / 2, depth};
}

const Mesh* ground_of(const Scene& scene) {
  for (const Mesh& mesh : scene.shapes.meshes)
    if (mesh.is_backdrop) return &mesh;
  return nullptr;
}

TEST(CompleteScene, FramesTheObjectsTightlyWithAMargin) {
  const Vec3f sizes[] = {
      {1, 1, 1}, {10, 0.1f, 1}, {0.1f, 10, 1}, {1, 1, 20}, {1e-6f, 1e-6f, 1e-6f}};
  for (Vec3f size : sizes)
    for (Vec3f corner : {Vec3f{0, 0, 0}, Vec3f{-3, 500, 20}})
      for (Vec3d up : {Vec3d{0, 0, 1}, Vec3d{0, 1, 0}, Vec3d{-1, 0, 0}})
        for (double fov : {10.0, 40.0, 120.0}) {
          if (corner.y > 0 && size.x < 1e-3f) continue;  // lost in float
          Scene scene = box_scene(corner, corner + size);
          scene.up = up;
          SceneOptions options;
          options.fov_deg = fov;
          const Scene done = complete_scene(scene, options);
          double widest = 0;
          for (Vec3f p : done.shapes.meshes[0].positions) {
            const ImagePoint at = project(*done.camera, Vec3d(p));
            EXPECT_GT(at.depth, 0);
            widest = std::max({widest, std::abs(at.x - 0.5), std::abs(at.y - 0.5)});
          }
          EXPECT_LT(widest, 0.4201);
          EXPECT_GT(widest, fov < 100 ? 0.4199 : 0.1);  // wide angles keep clear of the box
        }
}

TEST(CompleteScene, FramesRoundThingsByTheirShape) {
  Scene scene;
  scene.shapes.spheres.push_back({{5, 6, 7}, 2, 0});
  validate(scene);
  const Scene done = complete_scene(scene, {});
  const ImagePoint center = project(*done.camera, {5, 6, 7});
  EXPECT_NEAR(center.x, 0.5, 1e-9);
  EXPECT_NEAR(center.y, 0.5, 1e-9);
  const double edge = std::tan(std::asin(2 / length(done.camera->from - Vec3d{5, 6, 7})));
  EXPECT_NEAR(edge / std::tan(done.camera->fov_deg / 2 * std::acos(-1.0) / 180), 0.84, 0.01);
}

TEST(CompleteScene, LooksFromTheFrontAndAbove) {
  const Scene z_up = complete_scene(box_scene({-1, -1, -1}, {1, 1, 1}), {});
  EXPECT_LT(z_up.camera->from.y, -1);
  EXPECT_GT(z_up.camera->from.z, 0);
  Scene scene = box_scene({-1, -1, -1}, {1, 1, 1});
  scene.up = {0, 1, 0};
  const Scene y_up = complete_scene(scene, {});
  EXPECT_GT(y_up.camera->from.z, 1);
  EXPECT_GT(y_up.camera->from.y, 0);
}

TEST(CompleteScene, BareModelGetsGroundLightsAndBackground) {
  const Scene done = complete_scene(box_scene({-1, -1, 3}, {1, 1, 5}), {});
  const Mesh* ground = ground_of(done);
  ASSERT_NE(ground, nullptr);
  EXPECT_EQ(ground->triangles.size(), 2u);
  for (Vec3f p : ground->positions) {
    EXPECT_NEAR(p.z, 3, 1e-3);
    EXPECT_LE(p.z, 3);
  }
  EXPECT_EQ(done.lights.size(), 2u);
  for (const Light& light : done.lights) {
    const auto& ball = std::get<BallLight>(light.shape);
    EXPECT_GT(ball.center.z - ball.radius, 5);
  }
  EXPECT_TRUE(done.background.has_value());
  EXPECT_NE(done.ambient, Color{});
  EXPECT_EQ(object_bounds(done.shapes).largest_extent(), 2);  // the ground does not count
}

TEST(CompleteScene, LightsLeaveWhiteBelowFull) {
  const Scene done = complete_scene(box_scene({-1, -1, -1}, {1, 1, 1}), {});
  float sum = max_abs(done.ambient);
  for (const Light& light : done.lights) sum += max_abs(light.intensity);
  EXPECT_LE(0.8f * sum, 1.0f);
}

TEST(CompleteScene, AmbientLightIsDimBesideLightsOfTheFilesOwn) {
  const Scene bare = box_scene({-1, -1, -1}, {1, 1, 1});
  Scene lit = bare;
  lit.lights = {{PointLight{{9, 9, 9}}, {2, 2, 2}, Falloff::inverse_square, {}}};
  EXPECT_LT(complete_scene(lit, {}).ambient.x, 0.5f * complete_scene(bare, {}).ambient.x);
  SceneOptions none;
  none.ambient = Color{};
  EXPECT_EQ(complete_scene(bare, none).ambient, Color{});
}

TEST(CompleteScene, KeepsWhatTheFileGives) {
  Scene scene = box_scene({-1, -1, -1}, {1, 1, 1});
  scene.wants_ground = false;
  Camera camera;
  camera.from = {1, 2, 3}, camera.at = {0, 0, 1}, camera.fov_deg = 20, camera.near = 0.5;
  scene.camera = camera;
  scene.lights = {{PointLight{{9, 9, 9}}, {2, 2, 2}, Falloff::inverse_square}};
  scene.background = Color{0, 0, 0.5f};
  scene.ambient = {0.01f, 0.01f, 0.01f};
  const Scene done = complete_scene(scene, {});
  EXPECT_EQ(done.camera->from, camera.from);
  EXPECT_EQ(done.camera->near, 0.5);
  EXPECT_EQ(done.lights.size(), 1u);
  EXPECT_TRUE(std::holds_alternative<PointLight>(done.lights[0].shape));
  EXPECT_EQ(done.background->z, 0.5f);
  EXPECT_EQ(done.ambient.x, 0.01f);
  EXPECT_EQ(ground_of(done), nullptr);
}

TEST(CompleteScene, OptionsOverrideOnlyTheirPartOfTheCamera) {
  Scene scene = box_scene({-1, -1, -1}, {1, 1, 1});
  Camera camera;
  camera.from = {1, 2, 3}, camera.at = {0, 0, 1}, camera.fov_deg = 20;
  scene.camera = camera;
  SceneOptions options;
  options.at = Vec3d{5, 5, 5};
  const Scene done = complete_scene(scene, options);
  EXPECT_EQ(done.camera->from, camera.from);
  EXPECT_EQ(done.camera->at, (Vec3d{5, 5, 5}));
  EXPECT_EQ(done.camera->fov_deg, 20);
  options = {};
  options.from = Vec3d{7, 7, 7};
  options.fov_deg = 60;
  const Scene moved = complete_scene(scene, options);
  EXPECT_EQ(moved.camera->from, (Vec3d{7, 7, 7}));
  EXPECT_EQ(moved.camera->at, camera.at);
  EXPECT_EQ(moved.camera->fov_deg, 60);
}

TEST(CompleteScene, OnlyAFieldOfViewMakesAParallelCameraPerspective) {
  Scene scene = box_scene({-1, -1, -1}, {1, 1, 1});
  Camera camera;
  camera.parallel_height = 3, camera.window = {1, 0, 0, 1};
  scene.camera = camera;
  SceneOptions options;
  options.from = Vec3d{5, 5, 5}, options.at = Vec3d{0, 0, 0.5}, options.up = Vec3d{0, 1, 0};
  EXPECT_EQ(complete_scene(scene, options).camera->parallel_height, 3);
  EXPECT_EQ(complete_scene(scene, options).camera->window.left, 1);
  options.fov_deg = 30;
  EXPECT_EQ(complete_scene(scene, options).camera->parallel_height, 0);
  EXPECT_EQ(complete_scene(scene, options).camera->window.left, 1);
}

TEST(CompleteScene, GroundGoesWhereItIsTold) {
  SceneOptions options;
  options.ground = GroundChoice::none;
  EXPECT_EQ(ground_of(complete_scene(box_scene({0, 0, 0}, {1, 1, 1}), options)), nullptr);
  options.ground = -2.5;
  Scene scene = box_scene({0, 0, 0}, {1, 1, 1});
  scene.wants_ground = false;
  scene.up = {0, 1, 0};
  const Scene done = complete_scene(scene, options);
  ASSERT_NE(ground_of(done), nullptr);
  for (Vec3f p : ground_of(done)->positions) EXPECT_FLOAT_EQ(p.y, -2.5f);
}

TEST(CompleteScene, UpTurnsGroundAndCamera) {
  SceneOptions options;
  options.up = Vec3d{0, 2, 0};
  const Scene done = complete_scene(box_scene({0, 3, 0}, {1, 4, 1}), options);
  for (Vec3f p : ground_of(done)->positions) EXPECT_NEAR(p.y, 3, 1e-3);
  EXPECT_GT(done.camera->from.y, 3.5);
}

TEST(CompleteScene, GroundFacesUp) {
  for (Vec3d up : {Vec3d{0, 0, 1}, Vec3d{0, 1, 0}, Vec3d{1, 0, 0}}) {
    Scene scene = box_scene({0, 0, 0}, {1, 1, 1});
    scene.up = up;
    const Scene done = complete_scene(scene, {});
    const auto& p = ground_of(done)->positions;
    EXPECT_GT(dot(Vec3d(cross(p[1] - p[0], p[2] - p[0])), up), 0);
  }
}

TEST(CompleteScene, LightRadiusMakesBalls) {
  Scene scene = box_scene({0, 0, 0}, {4, 1, 1});
  scene.lights = {{PointLight{{9, 9, 9}}, {1, 1, 1}, Falloff::none},
                  {BallLight{{9, 9, 9}, 3}, {1, 1, 1}, Falloff::none},
                  {SunLight{}, {1, 1, 1}, Falloff::none},
                  {ParallelogramLight{{9, 9, 9}, {1, 0, 0}, {0, 1, 0}}, {1, 1, 1}, Falloff::none},
                  {DiskLight{{9, 9, 9}, {0, 0, 1}, 3}, {1, 1, 1}, Falloff::none}};
  SceneOptions options;
  options.light_radius = LightRadius{0.5f, false};
  const Scene done = complete_scene(scene, options);
  EXPECT_EQ(std::get<BallLight>(done.lights[0].shape).radius, 0.5f);
  EXPECT_EQ(std::get<BallLight>(done.lights[1].shape).radius, 0.5f);
  EXPECT_TRUE(std::holds_alternative<SunLight>(done.lights[2].shape));
  EXPECT_TRUE(std::holds_alternative<ParallelogramLight>(done.lights[3].shape));
  EXPECT_EQ(std::get<DiskLight>(done.lights[4].shape).radius, 3);
  options.light_radius = LightRadius{5, true};
  const Scene percent = complete_scene(scene, options);
  EXPECT_FLOAT_EQ(std::get<BallLight>(percent.lights[0].shape).radius, 0.2f);
}

TEST(CompleteScene, OptionsLightsReplaceTheFiles) {
  Scene scene = box_scene({0, 0, 0}, {1, 1, 1});
  scene.lights.resize(3);
  SceneOptions options;
  options.lights = {{SunLight{}, {1, 1, 1}, Falloff::none}};
  EXPECT_EQ(complete_scene(scene, options).lights.size(), 1u);
}

TEST(CompleteScene, ClearGlassCastsNoShadow) {
  Scene scene = box_scene({0, 0, 0}, {1, 1, 1});
  scene.materials.resize(2);
  scene.materials[1].transmission = {0, 0.5f, 0};
  SceneOptions options;
  EXPECT_TRUE(complete_scene(scene, options).materials[1].casts_shadow);
  options.clear_glass = true;
  const Scene done = complete_scene(scene, options);
  EXPECT_TRUE(done.materials[0].casts_shadow);
  EXPECT_FALSE(done.materials[1].casts_shadow);
}

TEST(CompleteScene, AnEyeAmongTheObjectsGetsItsLightsThere) {
  Scene scene = box_scene({0, 0, 0}, {8, 6, 3});
  SceneOptions options;
  options.from = Vec3d{1, 1, 1.5};
  const Scene done = complete_scene(scene, options);
  for (const Light& light : done.lights) {
    const Vec3f c = std::get<BallLight>(light.shape).center;
    EXPECT_TRUE(c.x > 0 && c.x < 8 && c.y > 0 && c.y < 6 && c.z > 1.5f && c.z < 3);
  }
}

TEST(CompleteScene, NothingButBackdropsIsFramedToo) {
  Scene scene = box_scene({0, 0, 0}, {1, 1, 1});
  scene.shapes.meshes[0].is_backdrop = true;
  scene.wants_ground = false;
  SceneOptions options;
  options.light_radius = LightRadius{10, true};
  const Scene done = complete_scene(scene, options);
  EXPECT_FLOAT_EQ(std::get<BallLight>(done.lights[0].shape).radius, 0.1f);
}

TEST(CompleteScene, RefusesOptionsThatMakeNoPicture) {
  const Scene scene = box_scene({0, 0, 0}, {1, 1, 1});
  const auto refuses = [&](const SceneOptions& options) {
    EXPECT_THROW(complete_scene(scene, options), Error);
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (double fov : {0.0, -5.0, 180.0, nan}) {
    SceneOptions options;
    options.fov_deg = fov;
    refuses(options);
  }
  for (float radius : {0.0f, -1.0f, static_cast<float>(nan), 1e38f})
    for (bool is_percent : {false, true}) {
      SceneOptions options;
      options.light_radius = LightRadius{radius, is_percent};
      refuses(options);
    }
  SceneOptions options;
  options.from = options.at = Vec3d{1, 2, 3};
  refuses(options);
  options = {};
  options.from = Vec3d{nan, 0, 0};
  refuses(options);
  options = {};
  options.up = Vec3d{0, 0, 0};
  refuses(options);
  options = {};
  options.ground = nan;
  refuses(options);
  options = {};
  options.ground = 1e300;
  refuses(options);
  options = {};
  options.background = Color{-1, 0, 0};
  refuses(options);
  options = {};
  options.lights = {{BallLight{{0, 0, 0}, 0}, {1, 1, 1}, Falloff::none}};
  refuses(options);
}

TEST(CompleteScene, HugeAndTinyScenesGiveAPictureOrAnError) {
  for (float size : {1e-38f, 1e-20f, 1e10f, 1e13f, 9e14f}) {
    Scene scene;
    scene.shapes.spheres.push_back({{0, 0, 0}, size, 0});
    scene.wants_ground = true;
    validate(scene);
    try {
      const Scene done = complete_scene(scene, {});
      EXPECT_TRUE(is_finite(done.camera->from));
    } catch (const Error& error) {
      EXPECT_FALSE(error.problem.empty()) << size;
    }
  }
}

}  // namespace
}  // namespace penumbra
