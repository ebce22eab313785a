// SPDX-License-Identifier: MIT
// Private to the layer: glowing surfaces in one plane, cut into convex polygons.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "penumbra/scene/emitter_piece.h"

namespace penumbra {

/// At most `most` pieces (twice as many where front and back differ) that are the surface to float
/// precision where so few convex polygons make it. Nothing where it isn't flat to a two-thousandth
/// of its size. Slabs that thin are the two sides of a plane.
std::optional<std::vector<EmitterPiece>> flat_pieces_of(const GlowingSurface& surface,
                                                        std::size_t most);

}  // namespace penumbra
