// SPDX-License-Identifier: MIT
// Private to the layer: the glowing triangles of a scene, as surfaces that hang together.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "penumbra/scene/scene.h"

namespace penumbra {

using GlowingTriangle = std::array<Vec3f, 3>;

/// Twice the area long.
Vec3d normal_of(const GlowingTriangle& triangle);
double area_of(const GlowingTriangle& triangle);
double area_of(std::span<const GlowingTriangle> triangles);

/// Triangles that hang together by corners and glow alike, in the world, each there once: of
/// several in one place one is left, or one a side where they shine from their front alone.
struct GlowingSurface {
  std::vector<GlowingTriangle> triangles;  ///< in an order that depends on themselves alone
  Color radiance;
  bool is_two_sided = true;
  bool is_closed = false;    ///< every edge belongs to an even number of triangles
  bool is_oriented = false;  ///< closed, and neighbours turn the same way
};

/// Those of all meshes, and of the groups as often as they are placed, in an order that depends on
/// themselves alone. Triangles whose corners or materials don't exist, that have no area or a
/// coordinate that isn't finite, or glow negatively, are passed over. Where placements make more
/// than some millions of triangles, one hull stands for the surfaces of a group. Cost: O(n log n).
std::vector<GlowingSurface> glowing_surfaces(const Scene& scene);

}  // namespace penumbra
