// SPDX-License-Identifier: MIT
// Points of a segment, uniform in the angle it subtends, and what else a receiver sees of it.
#pragma once

#include "penumbra/geometry/light_shape.h"
#include "penumbra/geometry/sample_loops.h"
#include "penumbra/geometry/vec.h"

namespace penumbra {

/// Relative to the receiver p, in double.
struct SeenLine {
  Vec3d center, half;
  double near_length = 0, far_length = 0;  ///< distances of center - half and center + half
  double angle = 0;                        ///< between them at p, in [0, pi]
};

SeenLine seen_from(const LineLight& light, Vec3f p);

/// Mean of max(0, n·ω) over the angle, for a unit normal n.
double mean_cosine(const SeenLine& seen, Vec3d n);

/// Mean of 1 / distance² over the length: what a row of points of intensity 1 in all gives at p.
double mean_inverse_square(const SeenLine& seen);

/// Replaces (u, v) by samples minus p; v is not used. From along its own direction, where a line
/// subtends no angle, the limit: density as 1 / distance². Uniform in length for p on the line.
void sample_line(const LineLight& light, Vec3f p, SampleArrays samples);

}  // namespace penumbra
