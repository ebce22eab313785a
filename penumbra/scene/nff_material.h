// SPDX-License-Identifier: MIT
// The surface of an NFF fill line ("f r g b Kd Ks Shine T IOR"): one mapping for the reader and for
// the built-in scenes that agree with files.
#pragma once

#include <cstddef>

#include "penumbra/scene/material.h"

namespace penumbra {

/// NFF colours are what the display shows, so they are taken as sRGB. Ks is both the highlight and
/// the mirror, as in the format; `shine` of 100000 (how the SPD writes a half-intensity angle of 0)
/// means no highlight. The index of refraction counts only where t > 0.
Material nff_material(Color display_rgb, float kd, float ks, float shine, float t, float ior);

/// Irradiance of each of `count` lights that have no colour of their own: sqrt(L) / (2 L), as the
/// SPD suggests.
float nff_light_intensity(std::size_t count);

/// A display colour of an NFF file as linear RGB.
Color nff_color(Color display_rgb);

}  // namespace penumbra
