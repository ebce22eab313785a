// SPDX-License-Identifier: MIT
// pbrt's colours: rgb, blackbody, and spectra by name, by file, or by their samples.
#pragma once

#include <filesystem>
#include <optional>

#include "penumbra/scene_io/pbrt_params.h"
#include "penumbra/scene_io/spectrum.h"

namespace penumbra {

/// The colour of a parameter (not of type texture), not negative and finite; nothing where there is
/// none. As in pbrt the light of spectra and black bodies has luminance 1, whatever their values.
/// Files are looked for beside `scene_file`. Throws Error for unknown names, missing or broken
/// files, and wavelengths that do not increase.
std::optional<Color> pbrt_color(const PbrtParameter* parameter, SpectrumOf of,
                                const std::filesystem::path& scene_file);

}  // namespace penumbra
