// SPDX-License-Identifier: MIT
// Shapes as user geometry of Embree: cones and rings, which it does not have, and spheres.
#pragma once

#include <embree3/rtcore.h>

#include <vector>

#include "penumbra/kernel/record.h"

namespace penumbra {

/// Attaches them to the scene; the records must live as long. Any hits are tested in
/// SIMD lanes, a ray a lane, by the textbook's formulas; closest hits by our own intersector.
void attach_records(RTCDevice device, RTCScene scene, const std::vector<Record>& records);

}  // namespace penumbra
