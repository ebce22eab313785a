// SPDX-License-Identifier: MIT
// Triangles and boxes by their support mappings.
#pragma once

#include "penumbra/geometry/flat_triangle.h"

namespace penumbra {

struct FlatHull {
  Vec3d a, b, c;
  explicit FlatHull(const FlatTriangle& t) : a(t.a), b(t.b), c(t.c) {}
  Vec3d support(Vec3d n) const {
    const double at_a = dot(a, n), at_b = dot(b, n), at_c = dot(c, n);
    return at_a > at_b ? (at_a > at_c ? a : c) : (at_b > at_c ? b : c);
  }
};

struct BoxHull {
  Vec3d lo, hi;
  explicit BoxHull(const Box& box) : lo(box.lo), hi(box.hi) {}
  Vec3d support(Vec3d n) const {
    return {n.x > 0 ? hi.x : lo.x, n.y > 0 ? hi.y : lo.y, n.z > 0 ? hi.z : lo.z};
  }
};

}  // namespace penumbra
