// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/pbrt_materials.h"

#include <gtest/gtest.h>

#include "tests/scene_io/pbrt_text.h"

namespace penumbra {
namespace {

/// Of a quad with texture coordinates in the material that the text makes current.
Material material_of(const std::string& text) {
  const Scene scene =
      read_pbrt_text(text + " Shape \"bilinearmesh\" \"point3 P\" [0 0 0 1 0 0 0 1 0 1 1 0]").scene;
  return scene.materials.at(scene.shapes.meshes.at(0).surface);
}

void expect_near(Color a, Color b, float tolerance = 1e-5f) {
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(a[axis], b[axis], tolerance) << axis;
}

TEST(PbrtMaterials, DiffuseIsLambert) {
  const Material m = material_of("Material \"diffuse\" \"rgb reflectance\" [0.1 0.2 0.3]");
  EXPECT_EQ(m.diffuse, Color(0.1f, 0.2f, 0.3f));
  EXPECT_EQ(m.mirror, Color{});
  EXPECT_EQ(m.highlight, Color{});
  expect_near(
      material_of("Material \"diffuse\" \"spectrum reflectance\" [300 0.3 800 0.3]").diffuse,
      {0.3f, 0.3f, 0.3f});
}

TEST(PbrtMaterials, CoatsMirrorAsTheirIndexSays) {
  const Material m = material_of("Material \"coateddiffuse\" \"float eta\" 1.5");
  EXPECT_EQ(m.diffuse, Color(0.5f, 0.5f, 0.5f));
  expect_near(m.mirror, {0.04f, 0.04f, 0.04f});
  const Material rough = material_of("Material \"coateddiffuse\" \"float roughness\" 0.3");
  EXPECT_LT(rough.mirror.x, 0.01f);
  EXPECT_GT(rough.highlight.x, 0.04f);
}

TEST(PbrtMaterials, SmoothMetalsMirrorAndRoughOnesShine) {
  const Material copper = material_of("Material \"conductor\"");
  expect_near(copper.mirror, {0.95f, 0.62f, 0.51f}, 0.01f);
  EXPECT_EQ(copper.diffuse, Color{});
  const Material gold = material_of(
      "Material \"conductor\" \"spectrum eta\" \"metal-Au-eta\" \"spectrum k\" \"metal-Au-k\"");
  EXPECT_GT(gold.mirror.x, 0.9f);
  EXPECT_LT(gold.mirror.z, 0.5f);
  const Material rough = material_of("Material \"conductor\" \"float roughness\" 0.25");
  EXPECT_GT(rough.diffuse.x, 0.2f);
  EXPECT_LT(rough.mirror.x, 0.3f);
  EXPECT_NEAR(rough.shininess, 2 / 0.25f - 2, 1e-4);
  expect_near(material_of("Material \"conductor\" \"rgb reflectance\" [0.2 0.4 0.6]").mirror,
              {0.2f, 0.4f, 0.6f});
}

TEST(PbrtMaterials, GlassRefractsAndThinGlassDoesNot) {
  const Material glass = material_of("Material \"dielectric\" \"spectrum eta\" \"glass-BK7\"");
  EXPECT_NEAR(glass.refraction_index, 1.5168, 1e-6);
  EXPECT_NEAR(glass.mirror.x + glass.transmission.x, 1, 1e-6);
  EXPECT_EQ(glass.diffuse, Color{});
  EXPECT_TRUE(glass.casts_shadow);
  const Material pane = material_of("Material \"thindielectric\"");
  EXPECT_EQ(pane.refraction_index, 1);
  EXPECT_NEAR(pane.mirror.x, 0.08 / 1.04, 1e-6);
  EXPECT_FALSE(pane.casts_shadow);
}

TEST(PbrtMaterials, NamesMayBeDefinedAfterwards) {
  EXPECT_EQ(
      material_of("NamedMaterial \"red\" MakeNamedMaterial \"red\" \"string type\" \"diffuse\" "
                  "\"rgb reflectance\" [1 0 0]")
          .diffuse,
      Color(1, 0, 0));
  EXPECT_TRUE(holds(pbrt_error("Shape \"sphere\"\nNamedMaterial \"red\""),
                    "t.pbrt:2: there is no material `red`"));
  EXPECT_TRUE(
      holds(pbrt_error("MakeNamedMaterial \"a\" \"rgb reflectance\" [1 1 1]"), "string type"));
  EXPECT_TRUE(holds(pbrt_error("MakeNamedMaterial \"a\" \"string type\" \"diffuse\"\n"
                               "MakeNamedMaterial \"a\" \"string type\" \"diffuse\""),
                    "t.pbrt:2: material `a` is defined twice"));
}

TEST(PbrtMaterials, MixesAreInBetween) {
  const std::string two =
      "MakeNamedMaterial \"a\" \"string type\" \"diffuse\" \"rgb reflectance\" [1 0 0] "
      "MakeNamedMaterial \"b\" \"string type\" \"conductor\" \"rgb reflectance\" [1 1 1] ";
  const Material m = material_of(
      two + "Material \"mix\" \"string materials\" [\"a\" \"b\"] \"float amount\" 0.25");
  expect_near(m.diffuse, {0.75f, 0, 0});
  expect_near(m.mirror, {0.25f, 0.25f, 0.25f});
  EXPECT_TRUE(holds(
      pbrt_error(
          "MakeNamedMaterial \"m\" \"string type\" \"mix\" \"string materials\" [\"m\" \"m\"]"),
      "is one mixed of itself?"));
}

TEST(PbrtMaterials, OthersAreMatteWithAWarning) {
  const PbrtResult r = read_pbrt_text(
      "\nMaterial \"measured\" \"string filename\" \"x.bsdf\" Shape "
      "\"sphere\"");
  EXPECT_TRUE(warns(r, "t.pbrt:2: a material of the kind `measured` is drawn matte"));
}

TEST(PbrtMaterials, ImagesThatAreMissingLeaveThePlainColour) {
  const std::string text =
      "Texture \"t\" \"spectrum\" \"imagemap\" \"string filename\" \"none.png\" Material "
      "\"diffuse\" "
      "\"texture reflectance\" \"t\" ";
  EXPECT_EQ(material_of(text).diffuse, Color(0.5f, 0.5f, 0.5f));
  EXPECT_TRUE(warns(read_pbrt_text(text + "Shape \"sphere\""), "'none.png' is missing"));
  EXPECT_TRUE(
      holds(pbrt_error("Shape \"sphere\" Material \"diffuse\" \"texture reflectance\" \"t\""),
            "there is no texture `t`"));
}

TEST(PbrtMaterials, TexturesOfNumbersAndOfColoursMayShareAName) {
  const PbrtResult r = read_pbrt_text(
      "Texture \"t\" \"spectrum\" \"constant\" \"rgb value\" [0.25 0.5 0.75] Texture \"t\" "
      "\"float\" \"constant\" \"float value\" 1 Material \"conductor\" \"texture reflectance\" "
      "\"t\" \"texture roughness\" \"t\" Shape \"sphere\"");
  const Material& metal = r.scene.materials[r.scene.shapes.spheres.at(0).surface];
  EXPECT_EQ(metal.diffuse, Color(0.25f, 0.5f, 0.75f));
  EXPECT_EQ(metal.mirror, Color());  // of roughness 1
  EXPECT_TRUE(r.warnings.empty()) << r.warnings[0];
}

TEST(PbrtMaterials, CheckerboardsAreImagesAndTheirMeanWhereThereAreNoCoordinates) {
  const std::string board =
      "Texture \"c\" \"spectrum\" \"checkerboard\" \"float uscale\" 4 \"float vscale\" 4 \"rgb "
      "tex1\" "
      "[1 0 0] \"rgb tex2\" [0 0 1] Material \"diffuse\" \"texture reflectance\" \"c\" ";
  const Scene scene =
      read_pbrt_text(
          board + "Shape \"bilinearmesh\" \"point3 P\" [0 0 0 1 0 0 0 1 0 1 1 0] Shape \"sphere\"")
          .scene;
  const Mesh& mesh = scene.shapes.meshes[0];
  const Material& image = scene.materials[mesh.surface];
  ASSERT_EQ(image.texture, 0);
  const auto at = [&](float u, float v) {
    // The mesh's own coordinates: twice the board's period over its edge.
    return sample(scene.textures[0], {u * mesh.uvs[1].u, v * mesh.uvs[2].v});
  };
  EXPECT_EQ(mesh.uvs[1].u, 2);
  expect_near(at(0.125f, 0.125f), {1, 0, 0});
  expect_near(at(0.375f, 0.125f), {0, 0, 1});
  expect_near(at(0.375f, 0.375f), {1, 0, 0});
  const Material& mean = scene.materials[scene.shapes.spheres[0].surface];
  EXPECT_EQ(mean.texture, -1);
  expect_near(mean.diffuse, {0.5f, 0, 0.5f});
}

TEST(PbrtMaterials, TexturesOfTexturesAreOneColour) {
  const std::string parts =
      "Texture \"a\" \"spectrum\" \"constant\" \"rgb value\" [0.5 1 0.25] Texture \"b\" "
      "\"spectrum\" "
      "\"scale\" \"texture tex\" \"a\" \"float scale\" 0.5 Texture \"c\" \"spectrum\" \"mix\" "
      "\"texture tex1\" \"b\" \"rgb tex2\" [0 0 0] \"float amount\" 0.5 ";
  expect_near(material_of(parts + "Material \"diffuse\" \"texture reflectance\" \"c\"").diffuse,
              {0.125f, 0.25f, 0.0625f});
  EXPECT_TRUE(
      holds(pbrt_error("Shape \"sphere\" Texture \"a\" \"spectrum\" \"scale\" \"texture tex\" "
                       "\"a\" Material \"diffuse\" \"texture reflectance\" \"a\""),
            "is one made of itself?"));
}

}  // namespace
}  // namespace penumbra
