// SPDX-License-Identifier: MIT
// The integral of max(0, n·ω) over the directions of a flat light, by the contour that they fill
// above the horizon. Straight edges: J. H. Lambert, Photometria, 1760. The rim of a disk: see the
// .cpp.
#pragma once

#include <span>

#include "penumbra/geometry/seen_disk.h"
#include "penumbra/geometry/vec.h"

namespace penumbra {

/// Of a planar convex polygon, its corners in order and relative to the receiver; n is unit. From
/// either side. Loses some 10⁻¹⁶ of the angle the polygon subtends.
double projected_solid_angle(std::span<const Vec3d> corners, Vec3d n);

/// Of a disk; height is not 0.
double projected_solid_angle(const SeenDisk& seen, Vec3d n);

}  // namespace penumbra
