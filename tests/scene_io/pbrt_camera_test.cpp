// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/pbrt_camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/scene_io/pbrt_text.h"

namespace penumbra {
namespace {

Camera camera_of(const std::string& before_world) {
  return *read_pbrt_text(before_world + " WorldBegin Shape \"sphere\"").scene.camera;
}

/// The direction (parallel cameras: the start) of the ray in the middle of a share of the picture.
Vec3d ray(const Camera& camera, double x, double y) {
  const CameraFrame f = frame(camera, double(camera.width) / camera.height);
  const CameraLine line = line_at(f, 2 * x - 1, 2 * y - 1);
  return f.is_parallel ? line.origin : line.direction;
}

void expect_near(Vec3d a, Vec3d b) {
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(a[axis], b[axis], 1e-9) << axis;
}

constexpr const char* wide =
    "Film \"rgb\" \"integer xresolution\" 200 \"integer yresolution\" 100 ";
constexpr const char* high =
    "Film \"rgb\" \"integer xresolution\" 100 \"integer yresolution\" 200 ";

TEST(PbrtCamera, TheFieldOfViewIsThatOfTheShorterEdge) {
  const std::string camera = "Camera \"perspective\" \"float fov\" 90";
  EXPECT_NEAR(camera_of(wide + camera).fov_deg, 90, 1e-9);
  EXPECT_NEAR(camera_of(high + camera).fov_deg, 2 * std::atan(2) * 180 / std::numbers::pi, 1e-9);
  EXPECT_EQ(camera_of(high + camera).height, 200u);
  EXPECT_EQ(camera_of(camera).width, 1280u);
  EXPECT_EQ(camera_of(camera).height, 720u);
}

TEST(PbrtCamera, PicturesAreAsTheCamerasAxesSay) {
  // pbrt's eye looks along +z with x to the right and y up.
  const Camera plain = camera_of(wide + std::string("Camera \"perspective\" \"float fov\" 90"));
  expect_near(ray(plain, 0.5, 0.5), {0, 0, 1});
  expect_near(ray(plain, 1, 0.5), {2, 0, 1});
  expect_near(ray(plain, 0, 0), {-2, 1, 1});
  // Looking along -z, LookAt's x axis is -x; the usual remedy is to mirror it.
  const std::string look = "LookAt 0 0 5 0 0 0 0 1 0 Camera \"perspective\" \"float fov\" 90";
  expect_near(ray(camera_of(wide + look), 1, 0.5), {-2, 0, -1});
  expect_near(ray(camera_of(wide + ("Scale -1 1 1 " + look)), 1, 0.5), {2, 0, -1});
}

TEST(PbrtCamera, CropsAndScreenWindowsArePartsOfThePicture) {
  const std::string film = "Film \"rgb\" \"integer xresolution\" 200 \"integer yresolution\" 100 ";
  const std::string camera = "Camera \"perspective\" \"float fov\" 90 ";
  const Camera crop = camera_of(film + "\"float cropwindow\" [0.5 1 0 0.5] " + camera);
  EXPECT_EQ(crop.width, 100u);
  EXPECT_EQ(crop.height, 50u);
  expect_near(ray(crop, 0, 1), {0, 0, 1});
  expect_near(ray(crop, 1, 0), {2, 1, 1});
  const Camera bounds = camera_of(film + "\"integer pixelbounds\" [100 200 0 50] " + camera);
  expect_near(ray(bounds, 1, 0), {2, 1, 1});
  const Camera shifted = camera_of(film + camera + "\"float screenwindow\" [0 2 -0.5 0.5]");
  expect_near(ray(shifted, 0, 0.5), {0, 0, 1});
  expect_near(ray(shifted, 1, 0), {2, 0.5, 1});
}

TEST(PbrtCamera, OrthographicRaysAreParallel) {
  const Camera camera =
      camera_of(wide + std::string("Camera \"orthographic\" \"float screenwindow\" [-4 4 -2 2]"));
  EXPECT_EQ(camera.parallel_height, 4);
  expect_near(ray(camera, 1, 0), {4, 2, 0});
  const Camera scaled = camera_of(wide + std::string("Scale 0.5 0.5 0.5 Camera \"orthographic\""));
  EXPECT_NEAR(scaled.parallel_height, 4, 1e-12);
}

TEST(PbrtCamera, OtherCamerasAreWarnedOfOrErrors) {
  EXPECT_TRUE(warns(read_pbrt_text("Camera \"spherical\" WorldBegin Shape \"sphere\""),
                    "a spherical camera is drawn in perspective"));
  EXPECT_TRUE(
      warns(read_pbrt_text("Camera \"perspective\" \"float lensradius\" 1 Shape \"sphere\""),
            "everything is sharp"));
  EXPECT_TRUE(holds(pbrt_error("Camera \"pinhole\" Shape \"sphere\""), "unknown camera `pinhole`"));
  EXPECT_TRUE(holds(pbrt_error("Scale 0 1 1 Camera \"perspective\" Shape \"sphere\""),
                    "cannot be turned round"));
  EXPECT_TRUE(holds(pbrt_error("Camera \"perspective\" \"float fov\" 180 Shape \"sphere\""),
                    "a field of view of 180 degrees"));
  EXPECT_TRUE(holds(pbrt_error("Film \"rgb\" \"integer xresolution\" 0 Shape \"sphere\""),
                    "makes no picture"));
}

}  // namespace
}  // namespace penumbra
