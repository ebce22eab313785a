// SPDX-License-Identifier: MIT
// Radiance's primitives, names and materials.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "penumbra/scene_io/radiance_words.h"
#include "tests/scene_io/radiance_scene.h"

namespace penumbra {
namespace {

const std::string grey = "void plastic grey 0 0 5 .5 .5 .5 0 0\n";

TEST(RadianceWords, cuts_at_space_quotes_and_comments) {
  RadianceWords words("t", "a#b # all this\n'two words' \"and 'more'\"\r\n1.5#end\n!x \\\n y # z");
  EXPECT_EQ(words.next().text, "a#b");
  EXPECT_EQ(words.next().text, "two words");
  EXPECT_EQ(words.next().text, "and 'more'");
  EXPECT_EQ(words.number("a number"), 1.5);
  ASSERT_TRUE(words.at_command());
  EXPECT_EQ(words.line(), 4u);
  EXPECT_EQ(words.command(), "x   y # z");
  EXPECT_TRUE(words.next().text.empty());
}

TEST(ReadRadiance, every_surface_is_a_shape) {
  const RadianceRead read = read_rad(grey +
                                     "grey sphere a 0 0 4 1 2 3 0.5\n"
                                     "grey bubble b 0 0 4 4 5 6 -2\n"
                                     "grey cylinder c 0 0 7 0 0 0 0 0 1 0.25\n"
                                     "grey tube d 0 0 7 1 0 0 1 0 1 0.5\n"
                                     "grey cone e 0 0 8 0 0 0 0 0 1 1 0\n"
                                     "grey cup f 0 0 8 0 0 0 0 0 1 -1 -2\n"
                                     "grey ring g 0 0 8 0 0 1 0 0 -2 3 1\n"
                                     "grey polygon h 0 0 12 0 0 0 1 0 0 1 1 0 0 1 0\n");
  const ShapeSet shapes = all_placed(read.scene);
  ASSERT_EQ(shapes.spheres.size(), 2u);
  EXPECT_EQ(shapes.spheres[0].center, Vec3f(1, 2, 3));
  EXPECT_EQ(shapes.spheres[0].radius, 0.5f);
  EXPECT_EQ(shapes.spheres[1].radius, 2);
  ASSERT_EQ(shapes.cones.size(), 4u);
  EXPECT_EQ(shapes.cones[0].base_radius, 0.25f);
  EXPECT_TRUE(is_cylinder(shapes.cones[1]));
  EXPECT_EQ(shapes.cones[2].apex_radius, 0);
  EXPECT_EQ(shapes.cones[3].apex_radius, 2);
  EXPECT_EQ(shapes.cones[3].caps, Caps::open);
  ASSERT_EQ(shapes.rings.size(), 1u);
  EXPECT_EQ(shapes.rings[0].normal, Vec3f(0, 0, -1));
  EXPECT_EQ(shapes.rings[0].inner_radius, 1);
  EXPECT_EQ(shapes.rings[0].radius, 3);
  ASSERT_EQ(shapes.meshes.size(), 1u);
  EXPECT_EQ(shapes.meshes[0].triangles.size(), 2u);
  EXPECT_EQ(area(shapes.meshes[0]), 1);
  EXPECT_EQ(read.scene.materials[shapes.meshes[0].surface].name, "grey");
  EXPECT_EQ(read.scene.up, Vec3d(0, 0, 1));
}

/// Whether the point of the plane z = 0 lies in one of the mesh's triangles.
bool covers(const Mesh& mesh, double x, double y) {
  for (const Triangle& t : mesh.triangles) {
    const Vec3f a = mesh.positions[t[0]], b = mesh.positions[t[1]], c = mesh.positions[t[2]];
    const auto side = [&](Vec3f p, Vec3f q) {
      return static_cast<double>(q.x - p.x) * (y - static_cast<double>(p.y)) -
             static_cast<double>(q.y - p.y) * (x - static_cast<double>(p.x));
    };
    if (side(a, b) > 0 && side(b, c) > 0 && side(c, a) > 0) return true;
  }
  return false;
}

TEST(ReadRadiance, a_seam_makes_a_hole) {
  const RadianceRead read = read_rad(grey +
                                     "grey polygon wall 0 0 30  0 0 0  4 0 0  4 4 0  0 4 0  0 0 0\n"
                                     "  1 1 0  1 3 0  3 3 0  3 1 0  1 1 0\n");
  const Mesh mesh = all_placed(read.scene).meshes.at(0);
  EXPECT_DOUBLE_EQ(area(mesh), 12);
  EXPECT_FALSE(covers(mesh, 2.1, 1.9));
  EXPECT_TRUE(covers(mesh, 0.5, 2.1));
  EXPECT_TRUE(covers(mesh, 3.4, 0.3));
}

TEST(ReadRadiance, two_holes_on_seams_of_their_own) {
  const RadianceRead read =
      read_rad(grey +
               "grey polygon wall 0 0 60  0 0 0  1 1 0  1 3 0  2 3 0  2 1 0  1 1 0  0 0 0\n"
               "  8 0 0  7 1 0  6 1 0  6 3 0  7 3 0  7 1 0  8 0 0  8 4 0  0 4 0\n"
               "  0 3.5 0  0 3 0  0 2.5 0  0 2 0\n");
  const Mesh mesh = all_placed(read.scene).meshes.at(0);
  EXPECT_NEAR(area(mesh), 32 - 2 - 2, 1e-5);
  EXPECT_FALSE(covers(mesh, 1.5, 2.2));
  EXPECT_FALSE(covers(mesh, 6.4, 1.8));
  EXPECT_TRUE(covers(mesh, 4.1, 2.3));
}

TEST(ReadRadiance, names_mean_what_was_last_defined) {
  const RadianceRead read = read_rad(
      "void plastic m 0 0 5 1 0 0 0 0\nm sphere a 0 0 4 0 0 0 1\n"
      "void plastic m 0 0 5 0 1 0 0 0\nm sphere b 0 0 4 2 0 0 1\n"
      "void alias n m\nn sphere c 0 0 4 4 0 0 1\n"
      "void texfunc bumps 4 a b c d 0 0\nbumps alias o m\no sphere d 0 0 4 6 0 0 1\n"
      "inherit alias q o\nq sphere e 0 0 4 8 0 0 1\n");
  const auto color = [&](std::size_t i) {
    return read.scene.materials[read.scene.shapes.spheres[i].surface].diffuse;
  };
  EXPECT_EQ(color(0), Color(1, 0, 0));
  for (std::size_t i : {1u, 2u, 3u, 4u}) EXPECT_EQ(color(i), Color(0, 1, 0)) << i;
  EXPECT_TRUE(read.warns_of("t.rad:9: texfunc is not drawn")) << read.warnings[0];
}

TEST(ReadRadiance, patterns_and_mixtures_lead_to_their_material) {
  const RadianceRead read = read_rad(
      "void plastic red 0 0 5 1 0 0 0 0\nvoid plastic blue 0 0 5 0 0 1 0 0\n"
      "void colorpict wood 7 red green blue wood.hdr . frac_u frac_v 0 0\n"
      "wood plastic desk 0 0 5 .5 .5 .5 0 0\n"
      "void mixfunc mix 4 red blue f f.cal 0 0\nvoid mixfunc hole 4 void blue f f.cal 0 0\n"
      "red brightfunc dirt 2 dirt dirt.cal 0 1 .5\n"
      "desk sphere a 0 0 4 0 0 0 1\nmix sphere b 0 0 4 2 0 0 1\nhole sphere c 0 0 4 4 0 0 1\n"
      "dirt sphere d 0 0 4 6 0 0 1\n");
  const auto color = [&](std::size_t i) {
    return read.scene.materials[read.scene.shapes.spheres[i].surface].diffuse;
  };
  EXPECT_EQ(color(0), Color(0.5f, 0.5f, 0.5f));
  EXPECT_EQ(color(1), Color(1, 0, 0));
  EXPECT_EQ(color(2), Color(0, 0, 1));
  EXPECT_EQ(color(3), Color(1, 0, 0));
  EXPECT_TRUE(read.warns_of("t.rad:8: colorpict"));
  EXPECT_TRUE(read.warns_of("t.rad:9: mixfunc is not drawn: its surfaces are plain (and 1 more)"));
}

Material material_of(const std::string& definition,
                     const std::string& surface = "sphere s 0 0 4 0 0 0 1") {
  const RadianceRead read = read_rad(definition + "\nm " + surface + "\n");
  const ShapeSet shapes = all_placed(read.scene);
  const std::uint32_t index =
      shapes.spheres.empty() ? shapes.meshes.at(0).surface : shapes.spheres[0].surface;
  return read.scene.materials[index];
}

TEST(RadianceMaterials, opaque_ones) {
  const Material plastic = material_of("void plastic m 0 0 5 .4 .2 .1 .5 0");
  EXPECT_EQ(plastic.diffuse, Color(0.2f, 0.1f, 0.05f));
  EXPECT_EQ(plastic.mirror, Color(0.5f, 0.5f, 0.5f));
  EXPECT_EQ(plastic.highlight, Color());
  const Material rough = material_of("void plastic m 0 0 5 .4 .2 .1 .05 .1");
  EXPECT_GT(rough.shininess, 100);
  EXPECT_GT(rough.highlight.x, 0.3f);
  EXPECT_LT(rough.mirror.x, 0.03f);
  const Material metal = material_of("void metal m 0 0 5 .4 .2 .1 1 0");
  EXPECT_EQ(metal.mirror, Color(0.4f, 0.2f, 0.1f));
  EXPECT_EQ(metal.diffuse, Color());
  const Material mirror = material_of("void mirror m 0 0 3 .9 .8 .7");
  EXPECT_EQ(mirror.mirror, Color(0.9f, 0.8f, 0.7f));
  EXPECT_TRUE(mirror.casts_shadow);
  EXPECT_EQ(material_of("void metal2 m 4 a b c . 0 6 .4 .2 .1 1 0 0").mirror, metal.mirror);
}

TEST(RadianceMaterials, a_mirrors_alternate_is_what_is_seen) {
  const std::string red = "void plastic red 0 0 5 1 0 0 0 0\n";
  EXPECT_EQ(material_of(red + "void mirror m 1 red 0 3 .9 .9 .9").diffuse, Color(1, 0, 0));
  EXPECT_EQ(material_of(red + "void mirror n 1 red 0 3 1 1 1 void mirror m 1 n 0 3 1 1 1").diffuse,
            Color(1, 0, 0));
  const RadianceRead read = read_rad("void mirror m 1 void 0 3 1 1 1\nm sphere s 0 0 4 0 0 0 1\n");
  EXPECT_TRUE(all_placed(read.scene).spheres.empty());
}

TEST(RadianceMaterials, window_glass_passes_light) {
  // The transmissivity that the manual gives for 88 % of transmittance.
  const Material glass = material_of("void glass m 0 0 3 .96 .96 .96");
  EXPECT_NEAR(glass.transmission.x, 0.88, 0.005);
  EXPECT_NEAR(glass.mirror.x, 0.08, 0.005);
  EXPECT_EQ(glass.refraction_index, 1);
  EXPECT_FALSE(glass.casts_shadow);
  EXPECT_TRUE(material_of("void glass m 0 0 3 .1 .1 .1").casts_shadow);
}

TEST(RadianceMaterials, dielectrics_refract_and_absorb_by_their_size) {
  const Material clear = material_of("void dielectric m 0 0 5 1 1 1 1.5 0");
  EXPECT_EQ(clear.refraction_index, 1.5f);
  EXPECT_NEAR(clear.mirror.x, 0.04, 1e-6);
  EXPECT_NEAR(clear.transmission.x, 0.96, 1e-6);
  EXPECT_TRUE(clear.casts_shadow);
  // The mean way through a ball of radius 0.75 is 1 long; two surfaces share what it absorbs.
  const Material dark =
      material_of("void dielectric m 0 0 5 .25 1 1 1.5 0", "sphere s 0 0 4 0 0 0 .75");
  EXPECT_NEAR(dark.transmission.x, 0.96 * 0.5, 1e-5);
  EXPECT_NEAR(dark.transmission.y, 0.96, 1e-6);
  EXPECT_NEAR(
      material_of("void dielectric m 0 0 5 1 1 1 1.5 0", "bubble s 0 0 4 0 0 0 1").refraction_index,
      1 / 1.5, 1e-6);
  EXPECT_NEAR(material_of("void interface m 0 0 8 1 1 1 1.5 1 1 1 1.2").refraction_index, 1.25,
              1e-6);
}

TEST(RadianceMaterials, trans_lets_its_specular_part_through) {
  const Material trans = material_of("void trans m 0 0 7 .5 .5 .5 0 0 .4 .25");
  EXPECT_NEAR(trans.diffuse.x, 0.3, 1e-6);
  EXPECT_NEAR(trans.transmission.x, 0.05, 1e-6);
  EXPECT_TRUE(read_rad("void trans m 0 0 7 .5 .5 .5 0 0 .4 .25\nm sphere s 0 0 4 0 0 0 1\n")
                  .warns_of("diffusely"));
}

TEST(RadianceMaterials, the_rest_is_drawn_as_what_is_nearest_and_warned_of) {
  for (const char* text :
       {"void plasfunc m 2 f f.cal 0 4 .4 .2 .1 0", "void BSDF m 6 0 a 0 0 1 . 0 0",
        "void transdata m 4 f d.dat . x 0 6 .4 .2 .1 0 .5 .5",
        "void BRTDfunc m 10 0 0 0 0 0 0 0 0 0 f.cal 0 9 .4 .2 .1 0 0 0 0 0 0",
        "void prism1 m 5 a b c d f.cal 0 0", "void ashik2 m 4 a b c . 0 8 .4 .2 .1 .1 .1 .1 9 9",
        "void trans2 m 4 a b c . 0 8 .4 .2 .1 0 .1 .1 .5 .5"}) {
    const RadianceRead read = read_rad(std::string(text) + "\nm sphere s 0 0 4 0 0 0 1\n");
    EXPECT_EQ(all_placed(read.scene).spheres.size(), 1u) << text;
    EXPECT_GE(read.warnings.size(), 2u) << text;
  }
  for (const char* text : {"void antimatter m 1 void 0 0", "void mist m 0 0 0"}) {
    const RadianceRead read = read_rad(std::string(text) + "\nm sphere s 0 0 4 0 0 0 1\n");
    EXPECT_TRUE(all_placed(read.scene).spheres.empty()) << text;
    EXPECT_TRUE(read.warns_of("left out")) << text;
  }
  EXPECT_TRUE(read_rad("").warns_of("without a material (void) are grey"));
}

TEST(ReadRadiance, errors_name_the_line_and_what_to_do) {
  EXPECT_EQ(rad_error("\nwood sphere s 0 0 4 0 0 0 1"),
            "t.rad:2: no material named `wood` is defined before it; define it, or put `!xform "
            "materials.rad` of the file that does before it");
  EXPECT_TRUE(holds(rad_error(grey + "grey box b 0 0 0"), "t.rad:2: `box` is no type"));
  EXPECT_TRUE(holds(rad_error(grey + "grey sphere b 0 0 3 1 2 3\nvoid plastic x 0 0 5 0 0 0 0 0"),
                    "t.rad:2: sphere `b` has 3 numbers, not 4"));
  EXPECT_TRUE(holds(rad_error(grey + "grey sphere b 0 0 4 1 2 x 3"), "found `x`"));
  EXPECT_TRUE(holds(rad_error(grey + "grey polygon b 0 0 999999999 1 2 3"), "bytes follow"));
  EXPECT_TRUE(holds(rad_error(grey + "grey polygon b 0 0 -3 1 2 3"), "t.rad:2"));
  EXPECT_TRUE(holds(rad_error(grey + "grey polygon b 0 0 8 0 0 0 1 0 0 1 1"), "three numbers"));
  EXPECT_TRUE(holds(rad_error(grey + "grey ring b 0 0 8 0 0 0 0 0 0 0 1"), "no normal"));
  EXPECT_TRUE(holds(rad_error(grey + "grey cone b 0 0 8 0 0 0 0 0 1 1 -1"), "radius"));
  EXPECT_TRUE(holds(rad_error("void instance tree 1 tree.oct 0 0"), "tree.rad"));
  EXPECT_TRUE(holds(rad_error("void mesh m 1 m.rtm 0 0"), "compiled meshes can't be read"));
  EXPECT_TRUE(holds(rad_error("void alias a b"), "no material named `b`"));
  EXPECT_TRUE(holds(rad_error("void spotlight m 0 0 7 1 1 1 0 0 0 1\nm sphere s 0 0 4 0 0 0 1"),
                    "no cone"));
}

TEST(ReadRadiance, what_has_no_size_is_left_out) {
  const RadianceRead read = read_rad(grey +
                                     "grey sphere a 0 0 4 0 0 0 0\n"
                                     "grey cylinder b 0 0 7 1 1 1 1 1 1 2\n"
                                     "grey ring c 0 0 8 0 0 0 0 0 1 2 2\n");
  const ShapeSet shapes = all_placed(read.scene);
  EXPECT_EQ(shapes.spheres.size() + shapes.cones.size() + shapes.rings.size(), 0u);
  EXPECT_TRUE(read.warns_of("t.rad:2: surfaces without any size are left out (and 2 more)"));
}

}  // namespace
}  // namespace penumbra
