// SPDX-License-Identifier: MIT
// The same light in every shape there is: of one centre and about one size.
#pragma once

#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "penumbra/geometry/light_shape.h"

namespace penumbra {

inline constexpr std::array light_kinds = {"point", "ball",    "parallelogram", "disk",
                                           "line",  "polygon", "mesh",          "sun"};

/// `size` is the radius; flat lights face `target`, and a sun shines towards it.
inline LightShape light_of_kind(std::string_view kind, Vec3f center, float size, Vec3f target) {
  const Vec3d way = normalize(Vec3d(target) - Vec3d(center));
  const Frame<double> frame = frame_around(way);
  const Vec3f u(frame.u * double(size)), v(frame.v * double(size)), n(frame.n * double(size));
  if (kind == "ball") return BallLight{center, size};
  if (kind == "parallelogram") return ParallelogramLight{center, u, v * 0.7f + u * 0.2f};
  if (kind == "disk") return DiskLight{center, Vec3f(way), size};
  if (kind == "line") return LineLight{center, u};
  if (kind == "polygon") {
    PolygonLight polygon{center, {}};
    for (int k = 0; k < 5; ++k) {
      const float angle = 1.2566371f * static_cast<float>(k);
      polygon.corners.push_back(center + u * std::cos(angle) + v * std::sin(angle));
    }
    return polygon;
  }
  if (kind == "mesh")  // an octahedron
    return MeshLight{
        center,
        {center + u, center - u, center + v, center - v, center + n, center - n},
        {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
  if (kind == "sun") {
    const double distance = length(Vec3d(target) - Vec3d(center));
    return SunLight{Vec3f(-way), static_cast<float>(std::atan(double(size) / distance))};
  }
  return PointLight{center};
}

}  // namespace penumbra
