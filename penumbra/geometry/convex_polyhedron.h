// SPDX-License-Identifier: MIT
// Convex polyhedra around a centre: their planes, and the edges between them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "penumbra/geometry/vec.h"

namespace penumbra {

/// normal · x <= offset
struct HalfSpace {
  Vec3d normal;  ///< unit
  double offset = 0;
};

/// The common part of half-spaces, which holds the origin inside; bounded.
struct ConvexPolyhedron {
  struct Edge {
    Vec3d a, b;
    std::array<std::uint32_t, 2> face;  ///< the two it lies on
  };
  std::vector<HalfSpace> faces;  ///< offset > 0
  std::vector<Edge> edges;
  double inner = 0;  ///< radius of the largest ball around the origin in it
  double outer = 0;  ///< of the smallest around the origin that holds it

  bool is_empty() const { return faces.empty(); }
  bool holds(Vec3d x) const;
};

/// Half-spaces that bound nothing are left out. Every edge is longer than 1e-8 of the result's size
/// and found alike on its two faces, so that faces and edges fit together as those of an exact
/// polyhedron do. Empty where that fails, as it may where four planes meet in a point; where an
/// offset is not positive; where the half-spaces leave a point at `bound` or beyond; and where the
/// result is 10^4 times longer than thick. Cost: O(n²).
ConvexPolyhedron intersection(std::span<const HalfSpace> half_spaces, double bound);

}  // namespace penumbra
