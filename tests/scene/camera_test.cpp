// SPDX-License-Identifier: MIT
#include "penumbra/scene/camera.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace penumbra {
namespace {

TEST(Camera, RightIsForwardCrossUp) {
  Camera camera;
  camera.from = {0, -4, 0}, camera.at = {}, camera.fov_deg = 90;
  const CameraFrame f = frame(camera, 1);
  EXPECT_NEAR(f.forward.y, 1, 1e-12);
  EXPECT_NEAR(f.right.x, 1, 1e-12);
  EXPECT_NEAR(f.up.z, 1, 1e-12);
}

TEST(Camera, FieldOfViewIsVerticalAndFull) {
  Camera camera;
  camera.from = {1, 2, 3}, camera.at = {4, -1, 0}, camera.fov_deg = 50;
  const CameraFrame f = frame(camera, 2);
  const double half = std::tan(25 * std::acos(-1.0) / 180);
  EXPECT_NEAR(length(f.up), half, 1e-12);
  EXPECT_NEAR(length(f.right), 2 * half, 1e-12);
  EXPECT_NEAR(length(f.forward), 1, 1e-12);
  EXPECT_NEAR(dot(f.up, f.right), 0, 1e-12);
  EXPECT_NEAR(dot(f.up, f.forward), 0, 1e-12);
}

TEST(Camera, LookingAlongUpStillGivesAFrame) {
  Camera camera;
  camera.from = {0, 0, 5}, camera.at = {};
  const CameraFrame f = frame(camera, 1);
  EXPECT_GT(length(f.right), 0.1);
  EXPECT_NEAR(dot(f.right, f.forward), 0, 1e-12);
}

TEST(Camera, UnitOfLengthDoesNotMatter) {
  for (double scale : {1e-30, 1e30}) {
    Camera camera;
    camera.from = {0, -4 * scale, 0}, camera.at = {0, 0, 0}, camera.up = {0, 0, scale};
    const CameraFrame f = frame(camera, 1);
    EXPECT_NEAR(f.forward.y, 1, 1e-12);
    EXPECT_GT(f.up.z, 0);
  }
}

TEST(Camera, ParallelRaysStartAcrossThePicture) {
  Camera camera;
  camera.from = {0, -4, 0}, camera.at = {}, camera.parallel_height = 3;
  const CameraFrame f = frame(camera, 2);
  const CameraLine left = line_at(f, -1, 0), top = line_at(f, 0, -1);
  EXPECT_NEAR(length(left.origin - Vec3d{-3, -4, 0}), 0, 1e-12);
  EXPECT_NEAR(length(top.origin - Vec3d{0, -4, 1.5}), 0, 1e-12);
  EXPECT_EQ(left.direction, (Vec3d{0, 1, 0}));
  EXPECT_EQ(top.direction, (Vec3d{0, 1, 0}));
}

TEST(Camera, TheWholePictureHasTheAspectThatFitsTheWindow) {
  Camera camera;
  camera.from = {0, -4, 0}, camera.at = {}, camera.fov_deg = 90;
  // The right half of a whole that is as wide as high, in a picture half as wide as high.
  camera.window = {0.5, 0, 1, 1};
  const CameraFrame f = frame(camera, 0.5);
  EXPECT_NEAR(length(line_at(f, -1, 0).direction - Vec3d{0, 1, 0}), 0, 1e-12);
  EXPECT_NEAR(length(line_at(f, 1, 0).direction - Vec3d{1, 1, 0}), 0, 1e-12);
  EXPECT_NEAR(length(line_at(f, 1, -1).direction - Vec3d{1, 1, 1}), 0, 1e-12);
}

TEST(Camera, AWindowTheOtherWayRoundMirrors) {
  Camera camera;
  camera.from = {0, -4, 0}, camera.at = {}, camera.fov_deg = 90;
  camera.window = {1, 0, 0, 1};
  EXPECT_NEAR(length(line_at(frame(camera, 1), 1, 0).direction - Vec3d{-1, 1, 0}), 0, 1e-12);
}

}  // namespace
}  // namespace penumbra
