// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/spectrum.h"

#include <gtest/gtest.h>

#include "tests/scene_io/pbrt_text.h"
#include "tests/scene_io/temporary_folder.h"

namespace penumbra {
namespace {

void expect_near(Color a, Color b, float tolerance) {
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(a[axis], b[axis], tolerance) << axis;
}

float luminance(Color c) { return 0.2126f * c.x + 0.7152f * c.y + 0.0722f * c.z; }

TEST(Spectrum, WhiteSurfacesAreWhite) {
  expect_near(color_of_spectrum({{360, 1}, {830, 1}}, SpectrumOf::surface), {1, 1, 1}, 1e-6f);
  expect_near(color_of_spectrum({{500, 0.25}}, SpectrumOf::surface), {0.25f, 0.25f, 0.25f}, 1e-6f);
}

TEST(Spectrum, ColoursComeOutAsTheyLook) {
  const Color red =
      color_of_spectrum({{380, 0}, {600, 0}, {610, 1}, {780, 1}}, SpectrumOf::surface);
  EXPECT_GT(red.x, 0.5f);
  EXPECT_LT(red.y, 0.1f);
  EXPECT_LT(red.z, 0.1f);
  const Color blue =
      color_of_spectrum({{380, 1}, {480, 1}, {490, 0}, {780, 0}}, SpectrumOf::surface);
  EXPECT_GT(blue.z, 0.5f);
  EXPECT_LT(blue.x, 0.2f);
}

TEST(Spectrum, LightHasLuminanceOne) {
  for (const double kelvin : {2000.0, 2856.0, 6500.0, 20000.0})
    EXPECT_NEAR(luminance(color_of_blackbody(kelvin)), 1, kelvin < 2500 ? 0.05 : 1e-3) << kelvin;
  EXPECT_NEAR(luminance(color_of_spectrum({{400, 7}, {700, 9}}, SpectrumOf::light)), 1, 1e-3);
}

TEST(Spectrum, BlackBodiesAgreeWithTheIlluminantsThatTheyDefine) {
  expect_near(color_of_blackbody(2856), *color_of_illuminant("stdillum-A"), 0.03f);
  expect_near(*color_of_illuminant("stdillum-D65"), {1, 1, 1}, 2e-3f);
  EXPECT_FALSE(color_of_illuminant("stdillum-G"));
  EXPECT_TRUE(is_finite(color_of_blackbody(1e-3)));
  EXPECT_TRUE(is_finite(color_of_blackbody(1e9)));
}

TEST(Spectrum, SilverIsBrightAndCopperRed) {
  const Color silver = metal_reflectance(*metal_index("Ag")),
              copper = metal_reflectance(*metal_index("Cu"));
  EXPECT_GT(silver.z, 0.85f);
  EXPECT_GT(copper.x, copper.y);
  EXPECT_GT(copper.y, copper.z);
  EXPECT_FALSE(metal_index("Xx"));
  EXPECT_NEAR(*glass_index("BK7"), 1.5168, 1e-9);
}

TEST(PbrtSpectra, AreNamedFilesOrSamples) {
  const TemporaryFolder folder;
  folder.put("half.spd", "# nm value\n300 0.5\n900 0.5\n");
  const auto diffuse = [&](const std::string& parameter) {
    const auto file =
        folder.put("s.pbrt", "Material \"diffuse\" " + parameter + " Shape \"sphere\"");
    const Scene scene = read_pbrt_file(load(file)).scene;
    return scene.materials[scene.shapes.spheres[0].surface].diffuse;
  };
  expect_near(diffuse("\"spectrum reflectance\" \"half.spd\""), {0.5f, 0.5f, 0.5f}, 1e-5f);
  expect_near(diffuse("\"spectrum reflectance\" [300 0.2 900 0.2]"), {0.2f, 0.2f, 0.2f}, 1e-5f);
  const auto fails = [&](const std::string& parameter, const std::string& part) {
    return holds(error_of([&] { diffuse(parameter); }), part);
  };
  EXPECT_TRUE(fails("\"spectrum reflectance\" \"none.spd\"", "no spectrum or file `none.spd`"));
  EXPECT_TRUE(fails("\"spectrum reflectance\" [400 1 300 1]", "wavelengths do not increase"));
  EXPECT_TRUE(fails("\"spectrum reflectance\" [400 1 300]", "do not come in pairs"));
  EXPECT_TRUE(fails("\"rgb reflectance\" [1 1]", "rgb takes three"));
  EXPECT_TRUE(fails("\"blackbody reflectance\" -5", "kelvin"));
}

}  // namespace
}  // namespace penumbra
