// SPDX-License-Identifier: MIT
// Ear clipping in the plane, for `triangulate`.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "penumbra/geometry/mesh.h"

namespace penumbra {

struct PlanePoint {
  double x = 0, y = 0;
  constexpr bool operator==(const PlanePoint&) const = default;
};

/// Twice the signed area of a triangle: positive when counter-clockwise. For points that come from
/// floats of like size the sign is exact: differences and products fit into a double.
inline double twice_area(PlanePoint a, PlanePoint b, PlanePoint c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Cuts the counter-clockwise ring of points into ring.size() - 2 triangles. Where it crosses
/// itself corners are cut off without care, and fewer triangles may come out.
std::vector<Triangle> clip_ears(std::span<const PlanePoint> points,
                                std::span<const std::uint32_t> ring);

}  // namespace penumbra
