// SPDX-License-Identifier: MIT
// Surfaces that glow, as lights.
#pragma once

#include <cstddef>

#include "penumbra/scene/scene.h"

namespace penumbra {

/// Gives every emissive parallelogram of two triangles (connected to no other glowing triangle) a
/// light of its radiance, and its triangles a material that casts no shadow, so that the light is
/// not blocked by its own surface. Of more than 64 the strongest are taken.
/// Returns how many connected glowing parts are no lights.
std::size_t add_emitter_lights(Scene& scene);

}  // namespace penumbra
