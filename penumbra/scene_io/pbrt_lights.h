// SPDX-License-Identifier: MIT
// pbrt's lights: LightSource, and AreaLightSource on a shape.
#pragma once

#include <optional>

#include "penumbra/scene_io/pbrt_scene.h"

namespace penumbra {

/// LightSource, in the current transformation.
void add_pbrt_light(PbrtScene& pbrt, const PbrtDefinition& definition);

/// What a shape sends out.
struct PbrtGlow {
  Color radiance;
  bool is_two_sided = false;
};

/// Of a shape that is `parts` lights to pbrt (triangles each are one) and has this area together;
/// nothing where no area light is on, where it is black, and in objects, where pbrt has none.
std::optional<PbrtGlow> pbrt_glow(PbrtScene& pbrt, double area, std::size_t parts);

/// Brings lights, emission and surroundings to what a picture shows; all shapes and lights, those
/// of glowing meshes too, must be there. The exposure is the file's (pbrt shows radiance times the
/// film's iso / 100 and the time that the shutter is open), unless it leaves hardly anything
/// between black and white; then it is that of `balance_lights`.
void expose_pbrt(PbrtScene& pbrt);

}  // namespace penumbra
