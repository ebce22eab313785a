// SPDX-License-Identifier: MIT
// xform, cat and genbox in Radiance scenes; nothing else is carried out, and nothing run.
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <string>
#include <vector>

#include "penumbra/scene_io/radiance_commands.h"
#include "tests/scene_io/radiance_scene.h"

namespace penumbra {
namespace {

constexpr std::size_t many = 1'000'000;

RadianceXform xform(const std::string& options, const std::string& argument_file = {}) {
  return parse_radiance_xform(split_radiance_command("xform " + options + " a.rad", {}).at(0), many,
                              [&](const std::string&) { return argument_file; }, {});
}

/// Where the first placement takes a point.
Vec3d moved(const std::string& options, Vec3d p = {1, 2, 3}) {
  const RadianceXform result = xform(options);
  EXPECT_EQ(result.placements.size(), 1u);
  return apply_point(result.placements.at(0), p);
}

void expect_near(Vec3d a, Vec3d b) {
  EXPECT_NEAR(a.x, b.x, 1e-12);
  EXPECT_NEAR(a.y, b.y, 1e-12);
  EXPECT_NEAR(a.z, b.z, 1e-12);
}

TEST(RadianceXform, transformations_follow_one_another) {
  EXPECT_EQ(moved(""), Vec3d(1, 2, 3));
  EXPECT_EQ(moved("-t 10 0 -1"), Vec3d(11, 2, 2));
  EXPECT_EQ(moved("-s 2 -t 1 1 1"), Vec3d(3, 5, 7));
  EXPECT_EQ(moved("-t 1 1 1 -s 2"), Vec3d(4, 6, 8));
  EXPECT_EQ(moved("-mx"), Vec3d(-1, 2, 3));
  EXPECT_EQ(moved("-my -mz"), Vec3d(1, -2, -3));
}

TEST(RadianceXform, rotations_follow_the_right_hand) {
  EXPECT_EQ(moved("-rx 90"), Vec3d(1, -3, 2));
  EXPECT_EQ(moved("-ry 90"), Vec3d(3, 2, -1));
  EXPECT_EQ(moved("-rz 90"), Vec3d(-2, 1, 3));
  EXPECT_EQ(moved("-rz -90"), Vec3d(2, -1, 3));
  expect_near(moved("-rz 30", {1, 0, 0}), {std::sqrt(0.75), 0.5, 0});
  expect_near(moved("-rx 30", {0, 1, 0}), {0, std::sqrt(0.75), 0.5});
  expect_near(moved("-ry 30", {0, 0, 1}), {0.5, 0, std::sqrt(0.75)});
}

TEST(RadianceXform, iterations_repeat_what_follows) {
  EXPECT_EQ(moved("-i 3 -t 1 0 0"), Vec3d(4, 2, 3));
  EXPECT_EQ(moved("-t 0 1 0 -i 3 -t 1 0 0 -i 1 -t 0 0 5"), Vec3d(4, 3, 8));
  EXPECT_EQ(moved("-i 0 -t 1 0 0"), Vec3d(1, 2, 3));
  EXPECT_EQ(moved("-i 1000000000 -rz 90"), Vec3d(1, 2, 3));
}

TEST(RadianceXform, arrays_are_grids_of_placements) {
  const RadianceXform grid = xform("-rz 90 -a 3 -t 10 0 0 -a 2 -t 0 20 0 -i 1 -t 0 0 1");
  std::vector<Vec3d> places;
  for (const Transform& t : grid.placements) places.push_back(apply_point(t, {1, 0, 0}));
  EXPECT_EQ(places, (std::vector<Vec3d>{
                        {0, 1, 1}, {0, 21, 1}, {10, 1, 1}, {10, 21, 1}, {20, 1, 1}, {20, 21, 1}}));
  // A spiral: each copy is turned and raised once more than the one before.
  EXPECT_EQ(apply_point(xform("-a 4 -rz 90 -t 0 0 1").placements.at(3), {1, 0, 0}),
            Vec3d(0, -1, 3));
}

TEST(RadianceXform, each_line_of_an_argument_file_is_a_placement) {
  const RadianceXform result =
      xform("-t 1 0 0 -f places -mx", "# two\n-t 0 1 0\n\n!xform -a 2 -t 0 2 0\n");
  ASSERT_EQ(result.placements.size(), 3u);
  EXPECT_EQ(result.placements[0].offset, Vec3d(-1, 1, 0));
  EXPECT_EQ(result.placements[1].offset, Vec3d(1, 0, 0));  // -mx is part of the array
  EXPECT_EQ(result.placements[2].offset, Vec3d(-1, 2, 0));
}

TEST(RadianceXform, other_options) {
  const RadianceXform result = xform("-n tree -m bark -m leaf -I -c -e -t 1 2 3");
  EXPECT_EQ(result.modifier, "bark");  // as in xform, the first one
  EXPECT_TRUE(result.is_inverted);
  EXPECT_EQ(result.files, std::vector<std::string>{"a.rad"});
  for (const char* wrong :
       {"-t 1 2", "-q", "-s 0", "-a 0", "-a -3", "-i x", "-rx nan", "-t 1 2 inf", "-a 1000000000",
        "-a 2000 -a 2000", "-f places -f places"})
    EXPECT_NE(error_of([&] { xform(wrong, "-t 0 0 0"); }), "") << wrong;
}

TEST(RadianceCommands, are_split_as_a_shell_does) {
  const auto programs = split_radiance_command("xform -n 'a b' \"c\" | xform -t 1 2 3 # no", {});
  ASSERT_EQ(programs.size(), 2u);
  EXPECT_EQ(programs[0], (std::vector<std::string>{"xform", "-n", "a b", "c"}));
  EXPECT_EQ(programs[1].size(), 5u);
  for (const char* wrong : {"xform a.rad; rm x", "xform `x`", "xform $A", "xform < a", "a | | b",
                            "xform 'a", "", "xform *.rad"})
    EXPECT_NE(error_of([&] { split_radiance_command(wrong, {}); }), "") << wrong;
}

TEST(RadianceBox, is_closed_and_looks_outwards) {
  const auto mesh_of = [](const std::string& options) {
    return all_placed(
               read_rad("void plastic m 0 0 5 .5 .5 .5 0 0\n!genbox m box 2 3 4" + options).scene)
        .meshes.at(0);
  };
  EXPECT_DOUBLE_EQ(six_volume(mesh_of("")) / 6, 24);
  EXPECT_DOUBLE_EQ(six_volume(mesh_of(" -i")) / 6, -24);
  EXPECT_EQ(topology(mesh_of("")).boundary_edges, 0u);
  const Mesh bevelled = mesh_of(" -b .5");
  EXPECT_EQ(topology(bevelled).boundary_edges, 0u);
  // Twelve edges lose a prism, eight corners what the three prisms at each leave over.
  EXPECT_NEAR(six_volume(bevelled) / 6, 24 - 0.125 * 4 * (1 + 2 + 3) - 8 * (0.125 - 1.0 / 48),
              1e-6);
  EXPECT_LT(six_volume(mesh_of(" -b .5 -i")), 0);
}

TEST(RadianceBox, round_edges_are_cylinders_and_balls) {
  const ShapeSet shapes = all_placed(
      read_rad("void plastic m 0 0 5 .5 .5 .5 0 0\n!genbox m box 2 3 4 -r .5 | xform -t 1 0 0")
          .scene);
  EXPECT_EQ(shapes.spheres.size(), 8u);
  EXPECT_EQ(shapes.cones.size(), 12u);
  EXPECT_EQ(shapes.spheres[0].center, Vec3f(1.5f, 0.5f, 0.5f));
  EXPECT_DOUBLE_EQ(area(shapes.meshes.at(0)), 2 * (1 * 2 + 2 * 3 + 1 * 3));
  for (const char* wrong :
       {"m b 1 1", "m b 1 1 0", "m b 1 1 1 -q", "m b 1 1 1 -r .6", "m b 1 1 1 -b"})
    EXPECT_NE(rad_error("!genbox " + std::string(wrong)), "") << wrong;
}

/// Files beside a main one.
class RadianceFiles : public testing::Test {
 protected:
  RadianceRead read(const std::string& text) {
    return read_radiance_source(
        load(folder.put("main.rad", text + "\nvoid sphere far 0 0 4 900 0 0 1\n")));
  }
  std::string error(const std::string& text) {
    return error_of([&] { read(text); });
  }
  TemporaryFolder folder;
};

TEST_F(RadianceFiles, a_file_is_a_group_that_is_placed) {
  folder.put("ball.rad",
             "void plastic p 0 0 5 1 0 0 0 0\np sphere s 0 0 4 1 0 0 .5\n"
             "p polygon q 0 0 9 0 0 0 1 0 0 0 1 0\n");
  const RadianceRead read = this->read(
      "!xform -a 3 -t 0 0 10 ball.rad\n!xform -s 2 -rz 90 ball.rad\n!xform -mx ball.rad\n");
  EXPECT_EQ(read.scene.shapes.groups.size(), 1u);
  EXPECT_EQ(read.scene.shapes.instances.size(), 5u);
  const ShapeSet shapes = all_placed(read.scene);
  ASSERT_EQ(shapes.spheres.size(), 5u);
  EXPECT_EQ(shapes.spheres[2].center, Vec3f(1, 0, 20));
  EXPECT_EQ(shapes.spheres[3].center, Vec3f(0, 2, 0));
  EXPECT_EQ(shapes.spheres[3].radius, 1);
  EXPECT_EQ(shapes.spheres[4].center, Vec3f(-1, 0, 0));
  EXPECT_DOUBLE_EQ(area(shapes.meshes.at(3)), 2);
}

TEST_F(RadianceFiles, names_in_a_file_mean_what_they_mean_where_it_is_included) {
  folder.put("ball.rad", "p sphere s 0 0 4 1 0 0 .5\n");
  folder.put("paints.rad", "void plastic green 0 0 5 0 1 0 0 0\n");
  const RadianceRead read = this->read(
      "void plastic p 0 0 5 1 0 0 0 0\n!xform ball.rad\nvoid plastic p 0 0 5 0 0 1 0 0\n"
      "!xform ball.rad\n!cat paints.rad\n!xform -m green ball.rad\n");
  const ShapeSet shapes = all_placed(read.scene);
  ASSERT_EQ(shapes.spheres.size(), 3u);
  const auto color = [&](std::size_t i) {
    return read.scene.materials[shapes.spheres[i].surface].diffuse;
  };
  EXPECT_EQ(color(0), Color(1, 0, 0));
  EXPECT_EQ(color(1), Color(0, 0, 1));
  EXPECT_EQ(color(2), Color(0, 1, 0));
  EXPECT_TRUE(holds(error("!xform ball.rad"), "ball.rad:1: no material named `p`"));
  EXPECT_EQ(error("!xform paints.rad\n!xform -m green ball.rad\n"), "");
  EXPECT_TRUE(holds(error("!xform -m gren ball.rad"), "no material named `gren`"));
}

TEST_F(RadianceFiles, placements_inside_one_another_are_composed) {
  std::filesystem::create_directory(folder.path() / "parts");
  folder.put("parts/ball.rad", "void sphere s 0 0 4 1 0 0 .5\n");
  folder.put("parts/two.rad", "!xform -a 2 -t 0 0 1 ball.rad\nvoid sphere t 0 0 4 0 0 7 .5\n");
  const RadianceRead read = this->read("!xform -rz 90 -a 2 -t 10 0 0 parts/two.rad\n");
  const ShapeSet shapes = all_placed(read.scene);
  std::vector<Vec3f> centers;
  for (const Sphere& s : shapes.spheres) centers.push_back(s.center);
  EXPECT_EQ(centers, (std::vector<Vec3f>{
                         {0, 1, 0}, {0, 1, 1}, {0, 0, 7}, {10, 1, 0}, {10, 1, 1}, {10, 0, 7}}));
  EXPECT_EQ(read.scene.shapes.groups.size(), 2u);
}

TEST_F(RadianceFiles, pipes_transform_their_output) {
  folder.put("ball.rad", "void sphere s 0 0 4 1 0 0 .5\n");
  const RadianceRead read = this->read("!cat ball.rad ball.rad | xform -t 1 0 0 | xform -rz 90\n");
  const ShapeSet shapes = all_placed(read.scene);
  ASSERT_EQ(shapes.spheres.size(), 2u);
  EXPECT_EQ(shapes.spheres[1].center, Vec3f(0, 2, 0));
}

TEST_F(RadianceFiles, inverted_polygons_turn_about) {
  folder.put("q.rad", "void light l 0 0 3 1 1 1\nl polygon q 0 0 9 0 0 1 1 0 1 0 1 1\n");
  const auto up = [&](const std::string& options) {
    const RadianceRead read = this->read("!xform " + options + " q.rad\n");
    return six_volume(read.scene.shapes.meshes.at(0)) > 0;
  };
  EXPECT_TRUE(up("-t 0 0 0"));
  EXPECT_FALSE(up("-I"));
  EXPECT_TRUE(up("-mx"));  // a mirror keeps the front in front
  EXPECT_FALSE(up("-mx -I"));
}

TEST_F(RadianceFiles, ray_path_is_searched_last) {
  std::filesystem::create_directory(folder.path() / "lib");
  folder.put("lib/ball.rad", "void sphere s 0 0 4 1 0 0 .5\n");
  EXPECT_TRUE(holds(error("!xform ball.rad"), "main.rad:1: the file `ball.rad` is missing"));
  setenv("RAYPATH", (".:" + (folder.path() / "lib").string()).c_str(), 1);
  EXPECT_EQ(error("!xform ball.rad"), "");
  unsetenv("RAYPATH");
}

TEST_F(RadianceFiles, other_commands_are_refused_with_a_way_out) {
  for (const char* command : {"gensky 6 21 12", "genrev m n f g 10", "sh x", "xform -t 1 2 3",
                              "cat main.rad | xform a.rad", "genbox m n 1 1 1 | sort", "xform -"}) {
    const std::string text = error("!" + std::string(command));
    EXPECT_TRUE(holds(text, "main.rad:1: ")) << text;
  }
  EXPECT_TRUE(holds(error("!gensky 6 21 12"), "the command `gensky` is not run"));
  EXPECT_TRUE(holds(error("!gensky 6 21 12"), "xform -e scene.rad > all.rad"));
}

TEST_F(RadianceFiles, hostile_ones_end_soon) {
  const auto start = std::chrono::steady_clock::now();
  EXPECT_TRUE(holds(error("!xform main.rad"), "includes itself"));
  folder.put("b.rad", "!xform c.rad\n");
  folder.put("c.rad", "!xform -t 1 0 0 b.rad\n");
  EXPECT_TRUE(holds(error("!xform b.rad"), "includes itself"));
  folder.put("s.rad", "void sphere s 0 0 4 1 0 0 .5\n");
  EXPECT_TRUE(holds(error("!xform -a 1000000000 s.rad"), "more than 524288 placements"));
  // Each file places the next one a thousand times.
  folder.put("d3.rad", "!xform -a 1000 -t 1 0 0 s.rad\n");
  folder.put("d2.rad", "!xform -a 1000 -t 0 1 0 d3.rad\n");
  folder.put("d1.rad", "!xform -a 1000 -t 0 0 1 d2.rad\n");
  EXPECT_TRUE(holds(error("!xform d1.rad"), "expand to more than"));
  for (int i = 0; i < 70; ++i)
    folder.put("n" + std::to_string(i) + ".rad", "!xform n" + std::to_string(i + 1) + ".rad\n");
  EXPECT_TRUE(holds(error("!xform n0.rad"), "64 files"));
  EXPECT_TRUE(holds(error("!xform -i 100000 -s 1e300 s.rad"), "beyond"));
  EXPECT_TRUE(holds(error("!xform -i 100000 -s 1e-30 s.rad"), "to nothing"));
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5));
}

TEST_F(RadianceFiles, a_control_file_names_scene_and_view) {
  folder.put("m.rad", "void plastic p 0 0 5 1 0 0 0 0\n");
  folder.put("s.rad", "p sphere s 0 0 4 1 0 0 .5\n");
  const RadianceRead read = read_radiance_source(load(
      folder.put("job.rif",
                 "# a job\nUP= +Y\nscene= s.rad # shapes\nmaterials= \\\n m.rad\nRENDER= -ab 1\n"
                 "view= XYZ\nview= north -vp 0 -9 0 -vd 0 1 0 -vh 30 -vv 60\n")));
  EXPECT_EQ(read.scene.shapes.spheres.size(), 1u);
  EXPECT_EQ(read.scene.up, Vec3d(0, 1, 0));
  ASSERT_TRUE(read.scene.camera);
  EXPECT_EQ(read.scene.camera->from, Vec3d(0, -9, 0));
  EXPECT_EQ(read.scene.camera->fov_deg, 60);
  EXPECT_TRUE(holds(error_of([&] { read_radiance_source(source_of("j.rif", "UP= Z\n")); }),
                    "no scene files"));
}

TEST_F(RadianceFiles, a_view_file_beside_is_taken) {
  folder.put("main.vf", "rvu -vtv -vp 1 2 3 -vd 0 0 -1 -vu 0 1 0\n");
  const RadianceRead read = this->read("");
  ASSERT_TRUE(read.scene.camera);
  EXPECT_EQ(read.scene.camera->from, Vec3d(1, 2, 3));
  EXPECT_TRUE(read.warns_of("its view is that of main.vf beside it"));
}

}  // namespace
}  // namespace penumbra
