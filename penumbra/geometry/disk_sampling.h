// SPDX-License-Identifier: MIT
// Points of a disk, uniform in solid angle.
#pragma once

#include "penumbra/geometry/light_shape.h"
#include "penumbra/geometry/sample_loops.h"

namespace penumbra {

/// Replaces (u, v) by samples minus p: a radial map of the spherical ellipse that the disk fills,
/// continuous on the square; by area where p sees the light edge-on or too small. The density is
/// uniform to 10⁻⁴ of itself, to 10⁻³ where p nearly touches the rim.
void sample_disk(const DiskLight& light, Vec3f p, SampleArrays samples);

}  // namespace penumbra
