// SPDX-License-Identifier: MIT
// Private to the layer: how much of a hull is not the surface in it.
#pragma once

#include <span>

#include "penumbra/geometry/light_shape.h"
#include "penumbra/scene/glowing_surface.h"

namespace penumbra {

/// Of the hull's silhouettes, in the mean over directions, the part that the triangles leave empty:
/// what looks bright and should not. Where it shines along an axis (not 0) directions count by
/// their cosine with it. To some hundredths. Cost: linear, 1 microsecond a triangle.
double empty_part(std::span<const GlowingTriangle> triangles, const MeshLight& hull, Vec3d axis);

}  // namespace penumbra
