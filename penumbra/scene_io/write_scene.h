// SPDX-License-Identifier: MIT
// Scenes -> files.
#pragma once

#include <filesystem>
#include <string>

#include "penumbra/scene/scene.h"

namespace penumbra {

/// Writes `.nff` (everything but textures, smooth normals only as patches) or `.ply` (triangle
/// meshes only, binary little endian), chosen by extension; what instances place as shapes of its
/// own. Nothing appears at `path` unless all of
/// it was written. Throws Error for an unknown extension, a scene the format cannot hold, and a
/// path that cannot be written.
void write_scene(const std::filesystem::path& path, const Scene& scene);

/// NFF text of a scene without instances: numbers with 6 significant digits when that reads back to
/// the same float, else with 9.
std::string to_nff(const Scene& scene);

/// Writes all of `bytes` to a temporary file beside `path`, then renames it. Throws Error.
void write_file(const std::filesystem::path& path, std::string_view bytes);

}  // namespace penumbra
