// SPDX-License-Identifier: MIT
// Surfaces that glow, as lights.
#pragma once

#include <cstddef>

#include "penumbra/scene/scene.h"

namespace penumbra {

/// What became of the glowing triangles.
struct EmitterReport {
  std::size_t surfaces = 0;  ///< glowing surfaces: triangles that hang together, once a placement
  std::size_t lights = 0;    ///< added to the scene
  std::size_t joined = 0;    ///< surfaces that share a light with others, their number being large
  std::size_t dark = 0;      ///< surfaces without an area that float can express: no light
  /// Of all light that the surfaces send far away, each direction by itself, the share that the
  /// lights send elsewhere; 0 for flat and for round ones.
  double misdirected = 0;
};

/// Gives glowing meshes (Material::emission) lights: see docs/formats.md, "Glowing surfaces".
EmitterReport add_emitter_lights(Scene& scene);

}  // namespace penumbra
