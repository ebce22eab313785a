// SPDX-License-Identifier: MIT
#include "penumbra/shadow/light_hull.h"

#include <cmath>
#include <numbers>

namespace penumbra {
namespace {

/// Corners of the polygon drawn around a disk: 2 % wider.
constexpr int disk_corners = 16;

std::vector<Vec3d> around_disk(Vec3d normal, double radius) {
  const Frame<double> frame = frame_around(normal);
  const double outer = radius / std::cos(std::numbers::pi / disk_corners) * (1 + 1e-12);
  std::vector<Vec3d> corners;
  for (int k = 0; k < disk_corners; ++k) {
    const double angle = 2 * std::numbers::pi * k / disk_corners;
    corners.push_back(frame.u * (outer * std::cos(angle)) + frame.v * (outer * std::sin(angle)));
  }
  return corners;
}

/// From anywhere in the box nothing of it is that far away.
double reach_of(const Box& scene) { return 2 * length(Vec3d(scene.hi) - Vec3d(scene.lo)) + 1e-30; }

}  // namespace

LightHull::LightHull(const LightShape& light, const Box& scene) {
  set_shape(light, scene);
  for (int axis = 0; axis < 3; ++axis) {
    Vec3d n;
    n[axis] = 1;
    spread_box_.hi[axis] = spread(n)[axis], spread_box_.lo[axis] = spread(-n)[axis];
  }
}

void LightHull::set_shape(const LightShape& light, const Box& scene) {
  if (const auto* ball = std::get_if<BallLight>(&light)) {
    center_ = Vec3d(ball->center), size_ = ball->radius;
    return;
  }
  if (const auto* sun = std::get_if<SunLight>(&light)) {
    const double reach = reach_of(scene);
    is_sun_ = is_disk_ = true;
    normal_ = normalize(Vec3d(sun->direction));
    center_ = normal_ * reach;
    size_ = reach * std::tan(double(sun->half_angle_rad)) * (1 + 1e-6);
    corners_ = around_disk(normal_, size_);
    return;
  }
  center_ = Vec3d(*penumbra::center(light));
  if (const auto* disk = std::get_if<DiskLight>(&light)) {
    is_disk_ = true;
    normal_ = normalize(Vec3d(disk->normal)), size_ = disk->radius;
    corners_ = around_disk(normal_, size_);
    return;
  }
  corners_ = penumbra::corners(light);
  for (Vec3d& corner : corners_) corner = corner - center_;
  // Offsets rest on the centre being in the light. A library's caller may have given another.
  if (std::holds_alternative<PolygonLight>(light) || std::holds_alternative<MeshLight>(light))
    corners_.push_back({});
  for (const Vec3d& corner : corners_) size_ = std::max(size_, length(corner));
}

Vec3d LightHull::spread(Vec3d n) const {
  if (is_disk_) {
    const Vec3d across = normalize(n - normal_ * dot(n, normal_));
    return (across - normal_ * dot(across, normal_)) * size_;  // where n is the normal, noise
  }
  if (is_ball()) return normalize(n) * size_;
  Vec3d best = corners_.front();
  for (const Vec3d& corner : corners_)
    if (dot(corner, n) > dot(best, n)) best = corner;
  return best;
}

double LightHull::doubt(Vec3f p) const { return doubt(p, length(center(p) - Vec3d(p))); }

double LightHull::least_height(Vec3f p, Vec3d n) const {
  return dot(n, center(p) - Vec3d(p) + spread(-n)) - doubt(p) * length(n);
}

}  // namespace penumbra
