// SPDX-License-Identifier: MIT
// Surfaces that glow, as lights.
#pragma once

#include <cstddef>

#include "penumbra/scene/scene.h"

namespace penumbra {

struct EmitterOptions {
  std::size_t most_lights = 32;    ///< in all, at least 1: what there is to compute grows with their number
  std::size_t most_a_surface = 8;  ///< pieces that a surface is cut into
};

/// What became of the glowing triangles.
struct EmitterReport {
  std::size_t surfaces = 0;  ///< glowing surfaces: triangles that hang together, once a placement
  std::size_t lights = 0;    ///< added to the scene
  std::size_t joined = 0;    ///< surfaces that share a light with others
  std::size_t dark = 0;      ///< surfaces too thin or too large to be a light; they cast no shadow either
  /// Of the light that the surfaces send far away, each direction by itself, the share that the
  /// lights send elsewhere; 0 for what is flat, some hundredths for round and nearly convex ones.
  double misdirected = 0;
};

/// Gives triangles that glow (Material::emission), those in placed groups too, lights of the same
/// power in their place, and a material that casts no shadow, so that they don't block what they
/// send. Which surface becomes what: docs/formats.md, "Glowing surfaces". The scene need not be
/// validated: what is broken is passed over. The lights depend on the triangles in the world alone,
/// not on their order. Cost: O(n log n), less than a second for 10⁵ triangles.
EmitterReport add_emitter_lights(Scene& scene, const EmitterOptions& options = {});

}  // namespace penumbra
