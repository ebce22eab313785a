// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/pbrt_lights.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/scene_io/pbrt_text.h"

namespace penumbra {
namespace {

constexpr double pi = std::numbers::pi;

/// The picture's exposure: our intensities are 1 / pi of pbrt's.
constexpr float ours = static_cast<float>(1 / pi);

std::vector<Light> lights_of(const std::string& text) { return read_pbrt_text(text).scene.lights; }

/// A sphere so small that it does not matter for what is sensible as an exposure.
const std::string subject = "Shape \"sphere\" ";

TEST(PbrtLights, PointsHaveRadiantIntensity) {
  const Light light = lights_of(subject +
                                "Translate 1 0 0 LightSource \"point\" \"point3 from\" [0 2 0] "
                                "\"rgb I\" [1 2 3] \"float scale\" 2")
                          .at(0);
  EXPECT_EQ(std::get<PointLight>(light.shape).center, Vec3f(1, 2, 0));
  EXPECT_EQ(light.falloff, Falloff::inverse_square);
  EXPECT_NEAR(light.intensity.z, 6 * ours, 1e-5);
  const Light bulb = lights_of(subject + "LightSource \"point\" \"float power\" 40").at(0);
  EXPECT_NEAR(bulb.intensity.x, 40 / (4 * pi) * ours, 1e-5);
}

TEST(PbrtLights, SpotsAreBeams) {
  const Light light =
      lights_of(subject +
                "LightSource \"spot\" \"point3 from\" [0 5 0] \"point3 to\" [0 0 0] "
                "\"float coneangle\" 40 \"float conedeltaangle\" 10")
          .at(0);
  ASSERT_TRUE(light.beam);
  EXPECT_EQ(light.beam->axis, Vec3f(0, -1, 0));
  EXPECT_NEAR(light.beam->cos_full, std::cos(30 * pi / 180), 1e-6);
  EXPECT_NEAR(light.beam->cos_none, std::cos(40 * pi / 180), 1e-6);
}

TEST(PbrtLights, DistantLightsAreSunsOfNoSize) {
  const Light light =
      lights_of(subject +
                "LightSource \"distant\" \"point3 from\" [0 3 0] \"point3 to\" [0 0 0] "
                "\"rgb L\" [2 2 2]")
          .at(0);
  EXPECT_EQ(std::get<SunLight>(light.shape).direction, Vec3f(0, 1, 0));
  EXPECT_EQ(std::get<SunLight>(light.shape).half_angle_rad, 0);
  EXPECT_NEAR(light.intensity.x, 2 * ours, 1e-6);
}

TEST(PbrtLights, InfiniteLightsAreAmbientAndBackground) {
  const PbrtResult r = read_pbrt_text(
      subject + "LightSource \"infinite\" \"rgb L\" [0.1 0.2 0.3] LightSource \"distant\"");
  EXPECT_EQ(r.scene.ambient, Color(0.1f, 0.2f, 0.3f));
  EXPECT_EQ(r.scene.background, Color(0.1f, 0.2f, 0.3f));
  EXPECT_TRUE(warns(r, "an infinite light is the same all around"));
  const PbrtResult alone = read_pbrt_text(subject + "LightSource \"infinite\" \"rgb L\" [8 4 2]");
  EXPECT_TRUE(warns(alone, "two lamps are added"));
  EXPECT_EQ(alone.scene.background, Color(1, 0.5f, 0.25f));
  EXPECT_TRUE(
      warns(read_pbrt_text(subject + "LightSource \"infinite\" \"string filename\" \"x.exr\""),
            "cannot be read"));
}

/// A shape is one light to pbrt, however many triangles it is to us; a mesh is one a triangle.
TEST(PbrtLights, PowerIsThatOfTheWholeShape) {
  const auto emission = [&](const std::string& shape) {
    const Scene scene =
        read_pbrt_text(subject + "AreaLightSource \"diffuse\" \"float power\" 100 " + shape).scene;
    float most = 0;
    for (const Material& material : scene.materials)
      most = std::max(most, max_abs(material.emission));
    return most;
  };
  const float ball = emission("Shape \"sphere\"");
  EXPECT_NEAR(emission("Scale 1 1 1.001 Shape \"sphere\"") / ball, 1, 0.05);
  EXPECT_NEAR(emission("Shape \"sphere\" \"float zmin\" 0") / ball, 2, 0.1);
  const std::string corners = "\"point3 P\" [0 0 0 2 0 0 0 2 0 2 2 0] ";
  const float patch = emission("Shape \"bilinearmesh\" " + corners);
  EXPECT_NEAR(patch / ball, pi, 0.05);
  EXPECT_NEAR(
      emission("Shape \"trianglemesh\" \"integer indices\" [0 1 3 0 3 2] " + corners) / patch, 2,
      1e-4);
}

TEST(PbrtLights, GlowingSpheresAreBallsThatDoNotBlockThemselves) {
  const Scene scene = read_pbrt_text(
                          "AttributeBegin AreaLightSource \"diffuse\" \"rgb L\" [300 200 100] "
                          "Translate 0 0 9 Shape \"sphere\" \"float radius\" 0.5 "
                          "AttributeEnd Shape \"disk\" \"float radius\" 9")
                          .scene;
  ASSERT_EQ(scene.lights.size(), 1u);
  const auto& ball = std::get<BallLight>(scene.lights[0].shape);
  EXPECT_EQ(ball.center, Vec3f(0, 0, 9));
  EXPECT_EQ(ball.radius, 0.5f);
  EXPECT_NEAR(scene.lights[0].intensity.x, 300 * pi * 0.25 * ours, 1e-4);  // L pi R²
  const Material& material = scene.materials[scene.shapes.spheres[0].surface];
  EXPECT_FALSE(material.casts_shadow);
  EXPECT_EQ(material.emission, Color(300, 200, 100));
  EXPECT_TRUE(scene.materials[scene.shapes.rings[0].surface].casts_shadow);
}

TEST(PbrtLights, GlowingDisksShineFromTheirFront) {
  const std::string disk = "AreaLightSource \"diffuse\" \"float scale\" 2 Shape \"disk\" ";
  const Light front = lights_of(disk).at(0);
  EXPECT_EQ(std::get<DiskLight>(front.shape).radius, 1);
  EXPECT_NEAR(front.intensity.x, 2 * pi * ours, 1e-6);  // L times area
  ASSERT_TRUE(front.beam);
  EXPECT_EQ(front.beam->axis, Vec3f(0, 0, 1));
  EXPECT_EQ(front.beam->cos_none, 0);
  EXPECT_EQ(lights_of("ReverseOrientation " + disk).at(0).beam->axis, Vec3f(0, 0, -1));
  EXPECT_EQ(lights_of("Scale -1 1 1 " + disk).at(0).beam->axis, Vec3f(0, 0, 1));
  EXPECT_FALSE(
      lights_of("AreaLightSource \"diffuse\" \"bool twosided\" true Shape \"disk\"").at(0).beam);
}

TEST(PbrtLights, GlowingMeshesAreLights) {
  const Scene scene =
      read_pbrt_text(
          "AreaLightSource \"diffuse\" \"rgb L\" [1 1 1] \"bool twosided\" false Shape "
          "\"bilinearmesh\" \"point3 P\" [0 0 0 2 0 0 0 1 0 2 1 0]")
          .scene;
  ASSERT_EQ(scene.lights.size(), 1u);
  EXPECT_NEAR(scene.lights[0].intensity.x, 2 * ours, 1e-5);
}

TEST(PbrtLights, PowerIsOfTheWholeShape) {
  const Light disk =
      lights_of("AreaLightSource \"diffuse\" \"float power\" 6 Shape \"disk\" \"float radius\" 2")
          .at(0);
  EXPECT_NEAR(disk.intensity.x, 6 / pi * ours, 1e-6);  // L = power / (pi area)
}

TEST(PbrtLights, AnAlphaOfZeroLeavesTheLightAlone) {
  const Scene scene = read_pbrt_text(subject +
                                     "AreaLightSource \"diffuse\" Shape \"sphere\" "
                                     "\"float alpha\" 0")
                          .scene;
  EXPECT_EQ(scene.shapes.spheres.size(), 1u);
  EXPECT_EQ(scene.lights.size(), 1u);
}

TEST(PbrtLights, WhatIsNoSurfaceDoesNotGlow) {
  const PbrtResult r = read_pbrt_text(
      subject + "Material \"interface\" AreaLightSource \"diffuse\" Shape \"disk\"\n");
  EXPECT_TRUE(r.scene.lights.empty());
  EXPECT_TRUE(r.scene.shapes.rings.empty());
  EXPECT_TRUE(warns(r, "t.pbrt:1: an area light on an interface is left out, as pbrt does"));
}

TEST(PbrtLights, ObjectsHaveNoLights) {
  const PbrtResult r = read_pbrt_text(
      "ObjectBegin \"o\" AreaLightSource \"diffuse\" Shape \"sphere\" ObjectEnd ObjectInstance "
      "\"o\"");
  EXPECT_TRUE(r.scene.lights.empty());
  EXPECT_TRUE(warns(r, "an area light in an object is left out"));
}

TEST(PbrtLights, ExposureIsTheFilms) {
  const auto intensity = [](const std::string& film) {
    return lights_of(film + subject + "LightSource \"distant\"").at(0).intensity.x;
  };
  EXPECT_NEAR(intensity("Film \"rgb\" \"float iso\" 200 "), 2 * ours, 1e-6);
  EXPECT_NEAR(intensity("Camera \"perspective\" \"float shutterclose\" 0.5 "), 0.5 * ours, 1e-6);
  EXPECT_NEAR(intensity("Film \"rgb\" \"float iso\" 1e6 "), 1, 1e-5);  // balanced
  // A dim lamp beside a bright sky does not make the sky brighter.
  const Scene sky = read_pbrt_text(subject +
                                   "LightSource \"infinite\" \"rgb L\" [0.5 0.5 0.5] LightSource "
                                   "\"distant\" \"float scale\" 1e-6")
                        .scene;
  EXPECT_EQ(sky.ambient, Color(0.5f, 0.5f, 0.5f));
}

TEST(PbrtLights, UnknownLightsAreErrors) {
  EXPECT_TRUE(holds(pbrt_error("\nLightSource \"torch\""), "t.pbrt:2: unknown light `torch`"));
  EXPECT_TRUE(
      holds(pbrt_error("AreaLightSource \"spread\" Shape \"sphere\""), "unknown area light"));
  EXPECT_TRUE(holds(pbrt_error("LightSource \"distant\" \"point3 to\" [0 0 0]"), "shines nowhere"));
}

}  // namespace
}  // namespace penumbra
