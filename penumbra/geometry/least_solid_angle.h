// SPDX-License-Identifier: MIT
// Where formulas in solid angle give way to those in area, or to a single direction.
#pragma once

namespace penumbra {

/// Below this solid angle the formulas have lost more digits than samples by area have error.
inline constexpr double least_solid_angle = 1e-9;

}  // namespace penumbra
