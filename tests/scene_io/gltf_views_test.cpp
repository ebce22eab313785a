// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/gltf_views.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "tests/scene_io/gltf_read.h"

namespace penumbra {
namespace {

TEST(GltfViews, cameras_look_along_minus_z) {
  GltfText text;
  text.scene_nodes = "0,1";
  text.nodes = R"({"mesh":0},{"camera":0,"translation":[1,2,3]})";
  text.rest = R"(,"cameras":[{"type":"perspective","perspective":{"yfov":0.5,"znear":0.1}}])";
  const Scene scene = read(text).scene;
  ASSERT_TRUE(scene.camera);
  EXPECT_TRUE((scene.camera->from == Vec3d{1, 2, 3}));
  EXPECT_TRUE((scene.camera->at == Vec3d{1, 2, 2}));
  EXPECT_NEAR(scene.camera->fov_deg, 0.5 * 180 / std::numbers::pi, 1e-9);
  EXPECT_FALSE(scene.wants_ground);
}

TEST(GltfViews, lights_are_balanced_to_a_picture) {
  GltfText text;
  text.scene_nodes = "0,1,2";
  text.nodes = R"({"mesh":0},
    {"translation":[0.5,0.5,10],"extensions":{"KHR_lights_punctual":{"light":0}}},
    {"extensions":{"KHR_lights_punctual":{"light":1}}})";
  text.rest = R"(,"extensions":{"KHR_lights_punctual":{"lights":[
    {"type":"point","intensity":54000,"color":[1,0.5,0.25]},
    {"type":"directional","intensity":540}]}})";
  const Scene scene = read(text).scene;
  ASSERT_EQ(scene.lights.size(), 2u);
  EXPECT_EQ(scene.lights[0].falloff, Falloff::inverse_square);
  EXPECT_NEAR(scene.lights[0].intensity.x, 50, 0.02);
  EXPECT_NEAR(scene.lights[0].intensity.z, 12.5, 0.005);
  const auto& sun = std::get<SunLight>(scene.lights[1].shape);
  EXPECT_EQ(sun.direction, (Vec3f{0, 0, 1}));
  EXPECT_NEAR(scene.lights[1].intensity.x, 0.5, 2e-4);
}

TEST(GltfViews, orthographic_cameras_are_parallel) {
  GltfText text;
  text.scene_nodes = "0,1";
  text.nodes = R"({"mesh":0},{"camera":0,"translation":[1,2,3],"scale":[5,5,5]})";
  text.rest = R"(,"cameras":[{"type":"orthographic",
    "orthographic":{"xmag":3,"ymag":1.5,"znear":0.25,"zfar":100}}])";
  const Scene scene = read(text).scene;
  ASSERT_TRUE(scene.camera);
  EXPECT_EQ(scene.camera->parallel_height, 3);
  EXPECT_EQ(scene.camera->near, 0.25);
  EXPECT_EQ(scene.camera->width, 2 * scene.camera->height);
  EXPECT_TRUE((scene.camera->at == Vec3d{1, 2, 2}));
  text.rest = R"(,"cameras":[{"type":"orthographic","orthographic":{"xmag":3,"ymag":0}}])";
  EXPECT_FALSE(read(text).scene.camera);
}

TEST(GltfViews, aspect_ratios_are_the_picture_s) {
  GltfText text;
  text.scene_nodes = "0,1";
  text.nodes = R"({"mesh":0},{"camera":0})";
  text.rest = R"(,"cameras":[{"perspective":{"yfov":0.5,"aspectRatio":1.5,"znear":0.1}}])";
  const Scene scene = read(text).scene;
  EXPECT_EQ(scene.camera->width, 768u);
  EXPECT_EQ(scene.camera->height, 512u);
  EXPECT_EQ(scene.camera->near, 0.1);
}

/// The light of a node that is turned to shine along -x, with extras of its own.
GltfRead with_light(const std::string& light, const std::string& node_extras = "{}") {
  GltfText text;
  text.scene_nodes = "0,1";
  text.nodes = R"({"mesh":0},{"translation":[9,0,0],"rotation":[0,0.70710678,0,0.70710678],
    "extras":)" +
               node_extras + R"(,"extensions":{"KHR_lights_punctual":{"light":0}}})";
  text.rest = R"(,"extensions":{"KHR_lights_punctual":{"lights":[{)" + light + "}]}}";
  return read(text);
}

TEST(GltfViews, spots_have_a_beam) {
  const Light light = with_light(R"("type":"spot","spot":{"innerConeAngle":0.2,
    "outerConeAngle":0.5})")
                          .scene.lights.at(0);
  EXPECT_TRUE(std::holds_alternative<PointLight>(light.shape));
  EXPECT_EQ(light.falloff, Falloff::inverse_square);
  ASSERT_TRUE(light.beam);
  EXPECT_NEAR(light.beam->axis.x, -1, 1e-6);
  EXPECT_FLOAT_EQ(light.beam->cos_full, std::cos(0.2f));
  EXPECT_FLOAT_EQ(light.beam->cos_none, std::cos(0.5f));
  const Light usual = with_light(R"("type":"spot","spot":{})").scene.lights.at(0);
  EXPECT_EQ(usual.beam->cos_full, 1);
  EXPECT_FLOAT_EQ(usual.beam->cos_none, std::sqrt(0.5f));
  const GltfRead bad =
      with_light(R"("type":"spot","spot":{"innerConeAngle":0.6,"outerConeAngle":0.5})");
  EXPECT_FLOAT_EQ(bad.scene.lights.at(0).beam->cos_none, std::sqrt(0.5f));
  EXPECT_TRUE(holds(bad.warnings.at(0), "out of order"));
}

TEST(GltfViews, extras_give_lights_a_size) {
  for (const char* name : {"radius", "light_radius", "lightRadius", "shadow_soft_size"})
    for (const char* type : {"point", "spot"}) {
      const std::string extras = std::string("{\"") + name + "\":0.25}";
      const std::string light = std::string(R"("type":")") + type + "\"";
      for (const GltfRead& r :
           {with_light(light + R"(,"extras":)" + extras), with_light(light, extras)})
        EXPECT_EQ(std::get<BallLight>(r.scene.lights.at(0).shape).radius, 0.25f);
    }
  const auto is_point = [](const std::string& extras) {
    const GltfRead r = with_light(R"("type":"point","extras":)" + extras);
    return std::holds_alternative<PointLight>(r.scene.lights.at(0).shape);
  };
  EXPECT_TRUE(is_point(R"({"radius":0})"));
  EXPECT_TRUE(is_point(R"({"radius":-1})"));
  EXPECT_TRUE(is_point(R"({"radius":1e30})"));
  EXPECT_TRUE(is_point(R"({"radius":"big"})"));
  const auto half_angle = [](const std::string& extras) {
    const GltfRead r = with_light(R"("type":"directional","extras":)" + extras);
    return std::get<SunLight>(r.scene.lights.at(0).shape).half_angle_rad;
  };
  EXPECT_FLOAT_EQ(half_angle(R"({"angle":0.1})"), 0.05f);
  EXPECT_FLOAT_EQ(half_angle(R"({"angular_diameter":0.2})"), 0.1f);
  EXPECT_NEAR(half_angle("{}"), 0.00463, 1e-5);
  EXPECT_NEAR(half_angle(R"({"angle":4})"), 0.00463, 1e-5);
}

}  // namespace
}  // namespace penumbra
