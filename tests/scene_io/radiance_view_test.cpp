// SPDX-License-Identifier: MIT
// Radiance's views as cameras.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "penumbra/scene_io/radiance_view.h"
#include "tests/scene_io/temporary_folder.h"
#include "tests/scene_io/text_source.h"

namespace penumbra {
namespace {

Camera view(const std::string& options) { return parse_radiance_view(options).camera; }

TEST(RadianceView, what_is_not_given_is_radiances_default) {
  const Camera camera = view("-vp 1 2 3");
  EXPECT_EQ(camera.from, Vec3d(1, 2, 3));
  EXPECT_EQ(camera.at, Vec3d(1, 3, 3));
  EXPECT_EQ(camera.up, Vec3d(0, 0, 1));
  EXPECT_EQ(camera.fov_deg, 45);
  EXPECT_EQ(camera.parallel_height, 0);
  EXPECT_EQ(camera.width, 512u);
  EXPECT_EQ(camera.height, 512u);
}

TEST(RadianceView, both_angles_give_the_pictures_shape) {
  const Camera camera = view("-vtv -vd 2 0 0 -vh 90 -vv 53.13010235 -vo 0.5");
  EXPECT_EQ(camera.at, Vec3d(1, 0, 0));
  EXPECT_NEAR(camera.fov_deg, 53.13, 0.01);
  EXPECT_EQ(camera.width, 1024u);  // tan 45° is twice tan 26.57°
  EXPECT_EQ(camera.height, 512u);
  EXPECT_EQ(camera.near, 0.5);
}

TEST(RadianceView, parallel_views_have_sizes) {
  const Camera camera = view("-vtl -vh 30 -vv 15");
  EXPECT_EQ(camera.parallel_height, 15);
  EXPECT_EQ(camera.width, 1024u);
}

TEST(RadianceView, shift_and_lift_move_the_window) {
  const ImageWindow window = view("-vs 0.5 -vl 0.25").window;
  EXPECT_EQ(window.left, 0.5);
  EXPECT_EQ(window.right, 1.5);
  EXPECT_EQ(window.top, -0.25);  // upwards
  EXPECT_EQ(window.bottom, 0.75);
}

TEST(RadianceView, other_projections_are_drawn_in_perspective) {
  const RadianceView fisheye = parse_radiance_view("-vth -vh 180 -vv 180");
  EXPECT_EQ(fisheye.camera.fov_deg, 100);
  EXPECT_TRUE(holds(fisheye.warning, "-vth"));
  EXPECT_EQ(view("-vta -vh 60 -vv 60").fov_deg, 60);
  EXPECT_NE(parse_radiance_view("-va 10").warning, "");
}

TEST(RadianceView, lines_of_a_file_change_one_another) {
  const TemporaryFolder folder;
  folder.put("base.vf", "rvu -vtv -vp 1 1 1 -vv 30\n");
  const auto file =
      folder.put("a.vf",
                 "# -vp 9 9 9\nrview -vf base.vf -vh 20\nsome text -vp 8 8 8\n"
                 "VIEW= -vtv -vp 4 5 6 \\\n -vd 0 0 -1 -vu 0 1 0\nrpict -w -vp 7 5 6 -x 100\n");
  const Camera camera = read_radiance_view(file).camera;
  EXPECT_EQ(camera.from, Vec3d(7, 5, 6));
  EXPECT_EQ(camera.at, Vec3d(7, 5, 5));
  EXPECT_EQ(camera.fov_deg, 30);
  EXPECT_LT(camera.width, camera.height);
  EXPECT_EQ(parse_radiance_view(file.string()).camera.from, camera.from);
  EXPECT_EQ(parse_radiance_view("-vf a.vf -vv 10", folder.path()).camera.fov_deg, 10);
}

TEST(RadianceView, errors_say_what_is_wrong) {
  for (const char* wrong : {"", "-vp 1 2", "-vp 1 2 x", "-vh 0", "-vv 180", "-vd 0 0 1", "-vtq",
                            "-q", "-vp 1 2 3 4", "-vf", "missing.vf", "-vp 1 2 1e999"})
    EXPECT_NE(error_of([&] { view(wrong); }), "") << wrong;
  const TemporaryFolder folder;
  const auto loop = folder.put("loop.vf", "rvu -vf loop.vf\n");
  EXPECT_TRUE(holds(error_of([&] { read_radiance_view(loop); }), "without end"));
  const auto none = folder.put("none.vf", "nothing\n");
  EXPECT_TRUE(holds(error_of([&] { read_radiance_view(none); }), "holds no view"));
}

}  // namespace
}  // namespace penumbra
