// SPDX-License-Identifier: MIT
// Mesh lights from points, by Qhull (C. B. Barber, D. P. Dobkin, H. Huhdanpaa, The Quickhull
// Algorithm for Convex Hulls, ACM Trans. Mathematical Software 1996).
#pragma once

#include <optional>
#include <span>

#include "penumbra/geometry/light_shape.h"

namespace penumbra {

/// The convex hull of the points as a light around its centroid. Its corners are those of the
/// points that span it, in their order: the hull of these corners is the same light, to the bit.
/// Nothing where the points lie in one plane, or are not finite.
std::optional<MeshLight> convex_hull(std::span<const Vec3f> points);

}  // namespace penumbra
