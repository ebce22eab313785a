// SPDX-License-Identifier: MIT
// Directives: what moves, what is saved, what stands in other files.
#include <gtest/gtest.h>

#include "tests/scene_io/pbrt_text.h"
#include "tests/scene_io/temporary_folder.h"

namespace penumbra {
namespace {

/// Where the origin goes, by a sphere put there.
Vec3f origin_after(const std::string& directives) {
  const Scene scene = read_pbrt_text("WorldBegin\n" + directives + "\nShape \"sphere\"").scene;
  return scene.shapes.spheres.at(0).center;
}

void expect_near(Vec3f a, Vec3f b) {
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(a[axis], b[axis], 1e-5) << axis;
}

TEST(ReadPbrt, transformations_act_the_last_written_first) {
  expect_near(origin_after("Translate 1 2 3"), {1, 2, 3});
  expect_near(origin_after("Scale 2 2 2 Translate 1 2 3"), {2, 4, 6});
  expect_near(origin_after("Rotate 90 0 0 1 Translate 1 0 0"), {0, 1, 0});
  expect_near(origin_after("Translate 1 2 3 Identity"), {0, 0, 0});
  expect_near(origin_after("Transform [1 0 0 0 0 1 0 0 0 0 1 0 4 5 6 1]"), {4, 5, 6});
  expect_near(origin_after("Translate 1 0 0 ConcatTransform [1 0 0 0 0 1 0 0 0 0 1 0 4 5 6 1]"),
              {5, 5, 6});
  // The eye's frame: what is 5 in front of it.
  expect_near(origin_after("LookAt 0 0 5  0 0 0  0 1 0"), {0, 0, 5});
}

TEST(ReadPbrt, coordinate_systems_are_named_and_found) {
  expect_near(origin_after("Translate 1 0 0 CoordinateSystem \"here\" Translate 5 5 5 "
                           "CoordSysTransform \"here\""),
              {1, 0, 0});
  const Scene scene = read_pbrt_text(
                          "LookAt 3 4 5 0 0 0 0 1 0 Camera \"perspective\" WorldBegin "
                          "CoordSysTransform \"camera\" Shape \"sphere\"")
                          .scene;
  expect_near(scene.shapes.spheres[0].center, {3, 4, 5});
  EXPECT_TRUE(holds(pbrt_error("CoordSysTransform \"there\""), "t.pbrt:1: there is no coordinate"));
}

TEST(ReadPbrt, attributes_are_saved_and_brought_back) {
  const Scene scene = read_pbrt_text(
                          "WorldBegin Translate 1 0 0 AttributeBegin Translate 1 0 0 Material "
                          "\"diffuse\" \"rgb reflectance\" [1 0 0] Shape \"sphere\" AttributeEnd "
                          "Shape \"sphere\" TransformBegin Translate 0 9 0 Material \"diffuse\" "
                          "\"rgb reflectance\" [0 1 0] TransformEnd Shape \"sphere\"")
                          .scene;
  const auto& spheres = scene.shapes.spheres;
  ASSERT_EQ(spheres.size(), 3u);
  EXPECT_EQ(spheres[0].center, Vec3f(2, 0, 0));
  EXPECT_EQ(spheres[1].center, Vec3f(1, 0, 0));
  EXPECT_EQ(spheres[2].center, Vec3f(1, 0, 0));
  EXPECT_EQ(scene.materials[spheres[0].surface].diffuse, Color(1, 0, 0));
  EXPECT_EQ(scene.materials[spheres[1].surface].diffuse, Color(0.5f, 0.5f, 0.5f));
  // TransformBegin is AttributeBegin in pbrt-v4.
  EXPECT_EQ(scene.materials[spheres[2].surface].diffuse, Color(0.5f, 0.5f, 0.5f));
}

TEST(ReadPbrt, the_end_of_a_block_makes_transformations_count_again) {
  expect_near(origin_after("AttributeBegin ActiveTransform EndTime Translate 9 9 9 AttributeEnd "
                           "Translate 1 2 3"),
              {1, 2, 3});
  expect_near(origin_after("Translate 1 2 3 CoordinateSystem \"here\" Identity ActiveTransform "
                           "EndTime CoordSysTransform \"here\""),
              {1, 2, 3});  // of all times, whichever is active
}

TEST(ReadPbrt, blocks_that_do_not_match_are_errors_with_the_line) {
  EXPECT_TRUE(holds(pbrt_error("\nAttributeEnd"), "t.pbrt:2: AttributeEnd without"));
  EXPECT_TRUE(holds(pbrt_error("AttributeBegin\nShape \"sphere\""), "t.pbrt:1: AttributeBegin is"));
  EXPECT_TRUE(holds(pbrt_error("AttributeBegin TransformBegin\nAttributeEnd"),
                    "t.pbrt:2: AttributeEnd where TransformBegin of line 1"));
  std::string deep;
  for (int i = 0; i < 5000; ++i) deep += "AttributeBegin ";
  EXPECT_TRUE(holds(pbrt_error(deep), "blocks in each other"));
}

TEST(ReadPbrt, attribute_gives_shapes_what_they_lack) {
  const Scene scene = read_pbrt_text(
                          "Attribute \"shape\" \"float radius\" 3 Shape \"sphere\" Shape "
                          "\"sphere\" \"float radius\" [2]")
                          .scene;
  EXPECT_EQ(scene.shapes.spheres[0].radius, 3);
  EXPECT_EQ(scene.shapes.spheres[1].radius, 2);
}

TEST(ReadPbrt, objects_are_groups_placed_by_instances) {
  const Scene scene =
      read_pbrt_text(
          "WorldBegin ObjectInstance \"later\" Translate 0 0 1 ObjectBegin \"later\" "
          "Scale 2 2 2 Shape \"sphere\" ObjectEnd Translate 5 0 0 ObjectInstance "
          "\"later\"")
          .scene;
  ASSERT_EQ(scene.shapes.groups.size(), 1u);
  ASSERT_EQ(scene.shapes.groups[0].spheres.size(), 1u);
  EXPECT_EQ(scene.shapes.groups[0].spheres[0].center, Vec3f(0, 0, 1));
  EXPECT_EQ(scene.shapes.groups[0].spheres[0].radius, 2);
  ASSERT_EQ(scene.shapes.instances.size(), 2u);
  EXPECT_EQ(scene.shapes.instances[0].placement.offset, Vec3d(0, 0, 0));
  EXPECT_EQ(scene.shapes.instances[1].placement.offset, Vec3d(5, 0, 1));
  EXPECT_TRUE(scene.shapes.spheres.empty());
  EXPECT_TRUE(
      holds(pbrt_error("\nObjectInstance \"none\""), "t.pbrt:2: there is no object `none`"));
  EXPECT_TRUE(holds(pbrt_error("ObjectBegin \"a\" ObjectBegin \"b\""), "inside an object"));
  EXPECT_TRUE(holds(pbrt_error("ObjectBegin \"a\" ObjectInstance \"a\""), "inside an object"));
  EXPECT_TRUE(holds(pbrt_error("ObjectBegin \"a\" ObjectEnd\nObjectBegin \"a\" ObjectEnd"),
                    "t.pbrt:2: object `a` is defined twice"));
}

TEST(ReadPbrt, what_pbrt_only_works_with_is_read_past_in_silence) {
  const PbrtResult r = read_pbrt_text(
      "# comment\nOption \"seed\" 5 Option \"disablepixeljitter\" true Option "
      "\"msereferenceimage\" \"a.exr\" ColorSpace \"srgb\"\nIntegrator "
      "\"path\" \"integer maxdepth\" [ 5 ] Sampler \"halton\" \"integer pixelsamples\" 16 "
      "PixelFilter \"box\" Accelerator \"bvh\" \"string splitmethod\" \"sah\" Film \"rgb\" "
      "\"string "
      "filename\" [\"a.exr\"] Camera \"perspective\" WorldBegin Shape \"sphere\"");
  EXPECT_TRUE(r.warnings.empty()) << r.warnings[0];
}

TEST(ReadPbrt, what_is_not_done_is_one_warning_a_kind) {
  const PbrtResult r = read_pbrt_text(
      "MakeNamedMedium \"fog\" \"string type\" \"homogeneous\"\nMediumInterface \"fog\" \"\"\n"
      "ActiveTransform EndTime Translate 9 9 9 ActiveTransform All\nShape \"sphere\" \"float "
      "what\" "
      "1\nColorSpace \"rec2020\"");
  EXPECT_EQ(r.warnings.size(), 4u);
  EXPECT_TRUE(warns(r, "t.pbrt:1: media (fog, smoke) are not drawn (and 1 more)"));
  EXPECT_TRUE(warns(r, "t.pbrt:3: nothing moves"));
  EXPECT_TRUE(warns(r, "t.pbrt:4: parameter `what` of Shape `sphere` is not read"));
  EXPECT_TRUE(warns(r, "t.pbrt:5: colours are taken as sRGB"));
  EXPECT_EQ(r.scene.shapes.spheres[0].center, Vec3f(0, 0, 0));
}

TEST(ReadPbrt, includes_are_beside_the_main_file_and_messages_name_them) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "parts");
  folder.put("parts/ball.pbrt", "Translate 1 0 0\nShape \"sphere\"\n");
  folder.put("parts/more.pbrt", "Include \"parts/ball.pbrt\"");  // from the main file's folder
  folder.put("parts/bad.pbrt", "\n\nShape \"blob\"");
  const auto read = [&](const std::string& text) {
    return read_pbrt_file(load(folder.put("main.pbrt", text)));
  };
  const Scene scene =
      read("Include \"parts/more.pbrt\" Import \"parts/ball.pbrt\" Shape \"sphere\"").scene;
  ASSERT_EQ(scene.shapes.spheres.size(), 3u);
  EXPECT_EQ(scene.shapes.spheres[1].center, Vec3f(2, 0, 0));
  EXPECT_EQ(scene.shapes.spheres[2].center, Vec3f(1, 0, 0));  // Import brings the state back
  EXPECT_TRUE(holds(error_of([&] { read("Include \"parts/bad.pbrt\""); }),
                    "parts/bad.pbrt:3: unknown shape `blob`"));
  EXPECT_TRUE(holds(error_of([&] { read("\nInclude \"none.pbrt\""); }),
                    "main.pbrt:2: there is no file `none.pbrt`"));
  EXPECT_TRUE(
      holds(error_of([&] { read("Include \"main.pbrt\""); }), "does a file include itself?"));
}

TEST(ReadPbrt, warnings_of_images_name_the_file_that_asks_for_them) {
  const TemporaryFolder folder;
  folder.put("materials.pbrt",
             "\nTexture \"t\" \"spectrum\" \"imagemap\" \"string filename\" \"none.png\"\n"
             "Material \"diffuse\" \"texture reflectance\" \"t\"");
  const PbrtResult r =
      read_pbrt_file(load(folder.put("main.pbrt", "Include \"materials.pbrt\" Shape \"sphere\"")));
  EXPECT_TRUE(warns(r, "materials.pbrt:2: the texture 'none.png' is missing"));
}

TEST(ReadPbrt, broken_text_is_an_error_with_the_line) {
  EXPECT_TRUE(holds(pbrt_error("\nNonsense"), "t.pbrt:2: unknown directive `Nonsense`"));
  EXPECT_TRUE(holds(pbrt_error("Shape \"sphere"), "t.pbrt:1: a quotation mark is not closed"));
  EXPECT_TRUE(holds(pbrt_error("Translate 1 2"), "but the file ends"));
  EXPECT_TRUE(holds(pbrt_error("Translate 1 2 x"), "expected a translation, found `x`"));
  EXPECT_TRUE(holds(pbrt_error("Shape \"sphere\" \"float radius\" [1 2]"), "has 2 values instead"));
  EXPECT_TRUE(holds(pbrt_error("Shape \"sphere\" \"float radius\" [1"), "but the file ends"));
  EXPECT_TRUE(holds(pbrt_error("Shape \"sphere\" \"string radius\" \"1\""), "is of the type"));
  EXPECT_TRUE(holds(pbrt_error("Shape \"sphere\" \"flaot radius\" 1"), "unknown parameter type"));
  EXPECT_TRUE(holds(pbrt_error("Shape \"sphere\" \"radius\" 1"), "type and name"));
  EXPECT_TRUE(holds(pbrt_error("Shape \"sphere\" \"float radius\" 1 \"float radius\" 1"), "twice"));
  EXPECT_TRUE(holds(pbrt_error("Transform [1 0 0 1 0 1 0 0 0 0 1 0 0 0 0 1]"), "fourth number"));
  EXPECT_TRUE(holds(pbrt_error("WorldBegin"), "there are no shapes"));
}

}  // namespace
}  // namespace penumbra
