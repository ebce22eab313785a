// SPDX-License-Identifier: MIT
// Points of a parallelogram, uniform in solid angle.
#pragma once

#include "penumbra/geometry/light_shape.h"
#include "penumbra/geometry/sample_loops.h"

namespace penumbra {

/// Replaces (u, v) by samples minus p: Urena et al. for rectangles, else Arvo's spherical
/// triangles, by area where p sees the light edge-on or too small.
void sample_parallelogram(const ParallelogramLight& light, Vec3f p, SampleArrays samples);

}  // namespace penumbra
