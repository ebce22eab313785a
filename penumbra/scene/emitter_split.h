// SPDX-License-Identifier: MIT
// Private to the layer: from a glowing surface to the few pieces that become lights.
#pragma once

#include <cstddef>
#include <vector>

#include "penumbra/scene/emitter_piece.h"

namespace penumbra {

/// Flat surfaces as convex polygons, round ones as balls, nearly convex ones as their hulls, others
/// cut by planes into nearly convex parts: at most `most` of them, (1) by triangles alone if `most`
/// is 1. Their powers make that of the surface: pi radiance times its area; twice that where it
/// shines from both sides and is not closed, but no more than its hull could have (where a hollow
/// shape is seen through its openings it is as bright inside as outside; for flat ones that is the
/// same).
std::vector<EmitterPiece> split(const GlowingSurface& surface, std::size_t most);

}  // namespace penumbra
