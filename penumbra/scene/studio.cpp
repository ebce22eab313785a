// SPDX-License-Identifier: MIT
#include "penumbra/scene/studio.h"

#include <cmath>
#include <numbers>

namespace penumbra::detail {

namespace {

constexpr double degree = std::numbers::pi / 180;

/// Where a studio lamp stands and what it gives; lengths in extents of the subject.
struct Lamp {
  double azimuth_rad, elevation_rad;  ///< from the eye's side, to the left; above the horizontal
  double distance, radius;
  float intensity;
};

constexpr Lamp key{48 * degree, 48 * degree, 3.0, 0.15, 0.72f};
constexpr Lamp fill{-62 * degree, 36 * degree, 2.6, 0.04, 0.2f};

Light ball(Vec3d center, double radius, float intensity) {
  return {BallLight{Vec3f(center), static_cast<float>(radius)},
          {intensity, intensity, intensity},
          Falloff::none};
}

bool is_inside(const Box& box, Vec3d p) {
  return p.x > box.lo.x && p.y > box.lo.y && p.z > box.lo.z && p.x < box.hi.x && p.y < box.hi.y &&
         p.z < box.hi.z;
}

/// Horizontal unit direction from the subject to the eye; any where the eye is right above.
Vec3d side_of(Vec3d eye, Vec3d center, Vec3d up) {
  const Vec3d away = normalize(eye - center);
  const Vec3d flat = away - up * dot(away, up);
  return length(flat) > 1e-3 ? normalize(flat) : front(up);
}

}  // namespace

Mesh ground(const Subject& subject, Vec3d up, double height, std::uint32_t surface) {
  constexpr double half_edge = 50;  // in extents
  const Vec3d u = front(up) * (half_edge * subject.extent), v = cross(up, u);
  const Vec3d center = subject.center + up * (height - dot(subject.center, up));
  Mesh mesh;
  mesh.positions = {Vec3f(center - u - v), Vec3f(center + u - v), Vec3f(center + u + v),
                    Vec3f(center - u + v)};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  mesh.surface = surface;
  mesh.is_backdrop = true;
  return mesh;
}

std::vector<Light> studio_lights(const Subject& subject, Vec3d up, Vec3d eye) {
  const Vec3d side = side_of(eye, subject.center, up);
  std::vector<Light> lights;
  for (const Lamp& lamp : {key, fill}) {
    // Seen from above, the eye's left is clockwise from the direction towards the eye.
    const Vec3d flat = rotated(side, up, -lamp.azimuth_rad);
    Vec3d offset = flat * std::cos(lamp.elevation_rad) + up * std::sin(lamp.elevation_rad);
    offset *= lamp.distance * subject.extent;
    double radius = lamp.radius * subject.extent;
    if (is_inside(subject.box, eye)) {
      const Vec3d half = Vec3d(subject.box.size()) * 0.5;
      const double head_room = std::abs(dot(half, up));
      offset = up * (0.8 * head_room) + flat * (0.3 * std::min({half.x, half.y, half.z}));
      radius = lamp.radius * head_room;
    }
    lights.push_back(ball(subject.center + offset, radius, lamp.intensity));
  }
  return lights;
}

}  // namespace penumbra::detail
