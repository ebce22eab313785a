// SPDX-License-Identifier: MIT
// Points of a parallelogram, uniform in solid angle.
#pragma once

#include "penumbra/geometry/light_shape.h"
#include "penumbra/geometry/sample_loops.h"

namespace penumbra {

/// Below this solid angle the formulas have lost more digits than samples by area have error.
inline constexpr double least_solid_angle = 1e-9;

/// Replaces (u, v) by samples minus p: Urena et al. for rectangles, else Arvo's spherical
/// triangles, by area where p sees the light edge-on or too small.
void sample_parallelogram(const ParallelogramLight& light, Vec3f p, SampleArrays samples);

}  // namespace penumbra
