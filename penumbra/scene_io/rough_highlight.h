// SPDX-License-Identifier: MIT
// Roughness, as formats of today have it, as Phong's highlight.
#pragma once

#include "penumbra/scene/material.h"

namespace penumbra {

/// Gives the material a highlight of this colour whose lobe is as wide as that of a surface of
/// roughness alpha (Walter et al. 2007), and as bright as the normalised lobe (Lafortune and
/// Willems 1994) as far as a picture shows it.
void set_rough_highlight(Material& material, Color specular, double alpha);

}  // namespace penumbra
