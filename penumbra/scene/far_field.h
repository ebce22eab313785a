// SPDX-License-Identifier: MIT
// Private to the layer: what glowing surfaces, and the lights in their place, send far away.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "penumbra/geometry/vec.h"
#include "penumbra/scene/glowing_surface.h"
#include "penumbra/scene/light.h"

namespace penumbra {

/// Radiant intensity, red, green and blue together, in so many evenly spread directions.
using FarField = std::array<float, 48>;

/// Which sides of triangles send light: their fronts; both; or fronts that no light comes from
/// behind of, as those of closed surfaces, whichever way they turn.
enum class Sides { front, both, outside };

/// Of triangles that don't shade each other, of this power (over pi) together.
FarField field_of(std::span<const GlowingTriangle> triangles, Sides sides, Vec3d power);

FarField field_of(const Light& light);

void add(FarField& sum, const FarField& field);

/// Half the sum of all differences: the part of the light that goes elsewhere.
double misdirected(const FarField& wanted, const FarField& is);
double total(const FarField& field);

}  // namespace penumbra
