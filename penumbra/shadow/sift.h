// SPDX-License-Identifier: MIT
// Float tests of sixteen candidates at once: which of them a shaft surely misses.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "penumbra/shadow/light_hull.h"

namespace penumbra {

/// The light as float sees it from p: a ball, a disk, or corners, around `way`, grown by its doubt.
struct SeenLight {
  Vec3f way;       ///< c - p
  float distance;  ///< its length
  float size;      ///< the largest |l - c|, rounded up
  float doubt;     ///< of samples
  bool is_ball = false, is_disk = false;
  Vec3f normal;                  ///< of the disk
  std::array<Vec3f, 16> corner;  ///< minus c
  std::uint32_t corners = 0;     ///< 0: more than fit; then the ball around them counts
};

SeenLight seen_light(const LightHull& light, Vec3f p);

/// Bit i: ball i (x, y, z, radius) is not surely missed. Exact, to float, for ball lights; others
/// count as the ball around them.
std::uint32_t sift_balls(const float* const ball[4], const SeenLight& light, Vec3f p);

/// The same for triangles (corners a, b, c): by the side of their plane, and by the planes through
/// p and an edge.
std::uint32_t sift_triangles(const float* const triangle[9], const SeenLight& light, Vec3f p);

}  // namespace penumbra
