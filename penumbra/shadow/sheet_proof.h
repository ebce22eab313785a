// SPDX-License-Identifier: MIT
// Umbra by what stands before the light's centre: which sheet to look at, and whether to look.
#pragma once

#include <cstdint>

#include "penumbra/geometry/light_sampling.h"
#include "penumbra/shadow/seen_light.h"
#include "penumbra/shadow/shadow_scene.h"
#include "penumbra/shadow/sheet.h"

namespace penumbra {

/// Whether a sheet of at most `most_triangles` surely hides the whole light from all receivers: the
/// one nearest to them before the light's centre, or the last. Given up early where a ray to the
/// light's outline is free. `outline` is memory that is reused. Adds to `tests`. Cost: nine rays,
/// then those of the sheets.
bool is_behind_sheet(const ShadowScene& scene, const SeenLight& sight, std::uint32_t most_triangles,
                     LightSamples& outline, SheetScratch& scratch, std::uint64_t& tests);

}  // namespace penumbra
