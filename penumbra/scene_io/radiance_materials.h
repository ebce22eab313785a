// SPDX-License-Identifier: MIT
// What Radiance's materials look like, by our model. Radiance: G. Ward, "Measuring and Modeling
// Anisotropic Reflection", 1992, and the reference manual (ray.html); colours are linear, their
// primaries taken for ours.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "penumbra/geometry/vec.h"
#include "penumbra/scene/material.h"
#include "penumbra/scene_io/radiance_file.h"

namespace penumbra {

/// How a material treats the light that it sends out.
enum class RadianceEmission {
  none,   ///< it does not glow
  light,  ///< light, spotlight, glow with a radius: lights the scene
  illum,  ///< the same, unseen; in its place stands another material, or nothing
  glow,   ///< seen, but lights nothing
};

struct RadianceLook {
  Material material;  ///< without emission
  RadianceEmission emission = RadianceEmission::none;
  Color radiance;                  ///< what it sends out
  Color radiance_below;            ///< the same of a source below the horizon
  std::optional<double> spot_deg;  ///< full angle of a spotlight's cone
  Vec3d spot_direction;            ///< in the coordinates of its file
  bool is_drawn = true;            ///< false: a medium, which has no surface
  /// Of glass that absorbs: what passes through a length of 1; `material.transmission` is 1.
  std::optional<Color> passes_per_length;
  std::string warning;  ///< what is not done; empty: nothing
};

/// Throws Error with the line of a material with too few numbers, or with some that make no sense.
RadianceLook radiance_look(const RadianceFile& file, const RadiancePrimitive& material);

}  // namespace penumbra
