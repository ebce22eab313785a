// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "penumbra/scene/nff_material.h"
#include "tests/scene_io/text_source.h"

namespace penumbra {
namespace {

struct Result {
  Scene scene;
  std::vector<std::string> warnings;
};

Result read(const std::string& text) {
  const Source source = source_of("t.nff", text);
  Warnings warnings("t.nff");
  Scene scene = read_nff(source, warnings);
  return {std::move(scene), warnings.lines()};
}

std::string error_for(const std::string& text) {
  return error_of([&] { read(text); });
}

constexpr const char* view =
    "v from 0 -5 1 at 0 0 0 up 0 0 1 angle 45 hither 0.01 resolution 64 32\n";

TEST(ReadNff, by_tokens_with_comments_anywhere) {
  const Result r = read(
      "# first\nb 0.5 0.25 # in between\n 0\nv\nat 0 0 0\rfrom 0 -5 1\r\nangle 30 up 0 1 0 "
      "resolution 64 32\nl 1 2 3\nl 1 2 3 .5 .5 +5e-1\nf 1 0.5 0.25 0.8 0.2 30 0 1\n"
      "c\n0 0 0 1\n0 0 2 0.5\ns 1 2 3 4 p 3 0 0 0 1 0 0 0 1 0# end\n"
      "pp 3 0 0 0 0 0 1 1 0 0 0 0 1 0 1 0 0 0 1");
  EXPECT_TRUE(r.warnings.empty());
  EXPECT_EQ(r.scene.background, nff_color({0.5f, 0.25f, 0}));
  ASSERT_TRUE(r.scene.camera);
  EXPECT_EQ(r.scene.camera->from, Vec3d(0, -5, 1));
  EXPECT_EQ(r.scene.camera->width, 64u);
  EXPECT_EQ(r.scene.camera->height, 32u);
  EXPECT_EQ(r.scene.camera->near, 0);
  EXPECT_EQ(r.scene.up, Vec3d(0, 1, 0));
  ASSERT_EQ(r.scene.lights.size(), 2u);
  EXPECT_EQ(r.scene.lights[0].intensity.x, nff_light_intensity(2));
  EXPECT_EQ(r.scene.lights[1].intensity, nff_color({0.5f, 0.5f, 0.5f}));
  const ShapeSet& shapes = r.scene.shapes;
  ASSERT_EQ(shapes.cones.size(), 1u);
  EXPECT_EQ(shapes.cones[0].apex_radius, 0.5f);
  ASSERT_EQ(shapes.spheres.size(), 1u);
  ASSERT_EQ(shapes.meshes.size(), 2u);
  EXPECT_TRUE(shapes.meshes[0].normals.empty());
  EXPECT_EQ(shapes.meshes[1].normals.size(), 3u);
  ASSERT_EQ(r.scene.materials.size(), 1u);
  EXPECT_EQ(r.scene.materials[0].diffuse, nff_color({1, 0.5f, 0.25f}) * 0.8f);
}

TEST(ReadNff, fills_apply_from_there_on_and_equal_ones_are_one) {
  const Result r = read(
      "s 0 0 0 1 f 1 0 0 1 0 100000 0 0 s 0 0 0 2 f 0 1 0 1 0 5 0.5 0 s 0 0 0 3 "
      "f 1 0 0 1 0 100000 0 0 s 0 0 0 4");
  ASSERT_EQ(r.scene.materials.size(), 3u);
  EXPECT_EQ(r.scene.materials[0].diffuse, Color(1, 1, 1));
  EXPECT_EQ(r.scene.materials[2].refraction_index, 1);
  EXPECT_EQ(r.scene.shapes.spheres[1].surface, r.scene.shapes.spheres[3].surface);
  EXPECT_EQ(r.scene.shapes.spheres[2].surface, 2u);
}

TEST(ReadNff, polygons_of_one_kind_share_a_mesh_and_vertices) {
  const Result r =
      read("f 1 0 0 1 0 9 0 0 p 4 0 0 0 1 0 0 1 1 0 0 1 0 f 0 1 0 1 0 9 0 0 p 3 0 0 0 1 0 0 0 0 1");
  ASSERT_EQ(r.scene.shapes.meshes.size(), 1u);
  const Mesh& mesh = r.scene.shapes.meshes[0];
  EXPECT_EQ(mesh.triangles.size(), 3u);
  EXPECT_EQ(mesh.positions.size(), 5u);
  EXPECT_EQ(mesh.surfaces, (std::vector<std::uint32_t>{0, 0, 1}));
}

TEST(ReadNff, concave_polygons_keep_their_area) {
  // An arrow head: a fan from the first corner would cover the notch.
  const Mesh mesh = read("p 4 4 0 0 0 3 0 1 0 0 0 -3 0").scene.shapes.meshes.at(0);
  double area = 0;
  for (const Triangle& t : mesh.triangles) {
    const Vec3d a(mesh.positions[t[0]]), b(mesh.positions[t[1]]), c(mesh.positions[t[2]]);
    area += length(cross(b - a, c - a)) / 2;
  }
  EXPECT_NEAR(area, 9, 1e-9);
}

TEST(ReadNff, own_comments_carry_what_the_format_lacks) {
  const Result r = read(
      "#! light sphere 1 2 3 0.5 4 4 4\n#! falloff inverse_square\n#! light rect 0 0 5 1 0 0 0 1 "
      "0\n"
      "l 0 0 1\n#! intensity 7 8 9\n#! radius 0.75\n#! ambient 0.25 0.5 1\n#! up 0 1 0\n#! ground\n"
      "#! background none\nf 1 1 1 1 0 9 0 0\n"
      "#! material emission 1 2 3 mirror 0 0.5 0 casts_shadow 0 name my glass\n"
      "#! capped\nc 0 0 0 1 0 0 1 1 c 0 0 0 1 0 0 1 1\n"
      "#! ring 0 1 0\nc 0 0 0 1 0 0 0 2\n#! backdrop\np 3 0 0 0 1 0 0 0 1 0 p 3 0 0 0 1 0 0 0 1 0\n"
      "#! mesh\np 3 0 0 0 1 0 0 0 1 0\n#!usr/bin\n#! nonsense\n");
  const Scene& s = r.scene;
  ASSERT_EQ(s.lights.size(), 3u);
  EXPECT_EQ(std::get<BallLight>(s.lights[0].shape).radius, 0.5f);
  EXPECT_EQ(s.lights[0].falloff, Falloff::inverse_square);
  EXPECT_EQ(s.lights[1].intensity.x, nff_light_intensity(3));
  EXPECT_EQ(s.lights[2].intensity, Color(7, 8, 9));
  EXPECT_EQ(std::get<BallLight>(s.lights[2].shape).radius, 0.75f);
  EXPECT_EQ(s.ambient, Color(0.25f, 0.5f, 1));
  EXPECT_EQ(s.up, Vec3d(0, 1, 0));
  EXPECT_TRUE(s.wants_ground);
  EXPECT_FALSE(s.background);
  EXPECT_EQ(s.materials.at(0).emission, Color(1, 2, 3));
  EXPECT_EQ(s.materials[0].mirror, Color(0, 0.5f, 0));
  EXPECT_FALSE(s.materials[0].casts_shadow);
  EXPECT_EQ(s.materials[0].name, "my glass");
  EXPECT_EQ(s.shapes.cones.at(0).caps, Caps::capped);
  EXPECT_EQ(s.shapes.cones.at(1).caps, Caps::open);
  ASSERT_EQ(s.shapes.rings.size(), 1u);
  EXPECT_EQ(s.shapes.rings[0].normal, Vec3f(0, 1, 0));
  EXPECT_EQ(s.shapes.rings[0].radius, 2);
  EXPECT_EQ(s.shapes.rings[0].inner_radius, 1);
  ASSERT_EQ(s.shapes.meshes.size(), 3u);
  EXPECT_TRUE(s.shapes.meshes[0].is_backdrop);
  EXPECT_FALSE(s.shapes.meshes[1].is_backdrop);
  EXPECT_EQ(r.warnings.size(), 1u);
}

TEST(ReadNff, oddities_are_warned_of_once_a_kind) {
  const Result r = read(
      "s 0 0 0 -1\ns 0 0 0 -2\ns 0 0 0 0\nc 0 0 0 1 0 0 0 1\nc 0 0 0 0 0 0 1 0\n"
      "c 0 0 0 1 0 0 0 2\nf -1 0 0 1 0 0 0 0\n");
  EXPECT_EQ(r.scene.shapes.spheres.size(), 2u);
  EXPECT_EQ(r.scene.shapes.spheres[1].radius, 2);
  EXPECT_EQ(r.scene.shapes.rings.size(), 1u);
  EXPECT_TRUE(r.scene.shapes.cones.empty());
  ASSERT_EQ(r.warnings.size(), 6u);
  EXPECT_TRUE(holds(r.warnings[0], "t.nff:1: "));
  EXPECT_TRUE(holds(r.warnings[0], "(and 1 more)"));
}

TEST(ReadNff, errors_name_the_line) {
  const auto check = [](const std::string& text, const std::string& place,
                        const std::string& what) {
    const std::string error = error_for(text);
    EXPECT_TRUE(error.starts_with("t.nff:" + place + ": ")) << error;
    EXPECT_TRUE(holds(error, what)) << error;
  };
  check("s 0 0 0 1\n\nx 1 2\n", "3", "unknown keyword `x`");
  check("nff\nversion 2.0\n", "1", "unknown keyword `nff`");
  check("s 0 0\n0", "2", "a sphere's radius, found the end");
  check("s 0 0 0 one", "1", "`one`");
  check("s 0 0 nan 1", "1", "no finite number");
  check("s 0 0 1e39 1", "1", "no finite number");
  check("\np 2 0 0 0 1 0 0", "2", "2 corners");
  check("p -5 0 0 0", "1", "-5 corners");
  check("p 999999999999 0 0 0", "1", "only 6 bytes");
  check("pp 9223372036854775807 0 0 0", "1", "bytes follow");
  check("p 3.5 0 0 0", "1", "`3.5`");
  check("v from 0 0 0 at 0 0 0", "1", "same point");
  check("v from 0 0 0 s", "1", "`at`");
  check(std::string(view) + "v from 0 0 0 at 1 0 0 resolution 0 5", "2", "resolution");
  check("v from 0 0 0 at 1 0 0 resolution 1e6 5", "1", "65536");
  check("v from 0 0 0 at 1 0 0 angle 180", "1", "angle");
  check("v from 0 0 0 at 1 0 0 up 1 0 0", "1", "line of sight");
  check("\n#! light disk 0 0 0 0 0 0 1", "2", "no normal");
  check("\n#! light polygon 3 0 0 0 1 0 0", "2", "takes 10 numbers");
  check("#! light disk 0 0 0 0 0 1 1\n#! radius 1", "2", "no ball");
  check("#! light sphere 0 0 0", "1", "takes 4 numbers");
  check("#! intensity 1 1 1", "1", "no light");
  check("l 0 0 0\n#! radius 0", "2", "no ball");
  check("#! material colour 1", "1", "`colour`");
  check("#! ambient 1 1", "1", "the end");
  check("#! ground 5", "1", "`5`");
  check("#! parallel 5", "1", "no view before");
  check("v\nfrom 0 -5 0\nat 0 0 0\nangle 40\n#! parallel 0", "5", "above 0");
  check("v\nfrom 0 -5 0\nat 0 0 0\nangle 40\n#! window 0 0 1", "5", "the end");
  check("#! beam 0 0 1 20 30", "1", "no light");
  check("l 0 0 0\n\n#! beam 0 0 1 30 20", "3", "out of order");
  check("#! light sun 0 0 1 1 beam 0 0 1 20 30", "1", "a sun with a beam");
}

}  // namespace
}  // namespace penumbra
