// SPDX-License-Identifier: MIT
// The built-in scenes: used by demo, tests, benches and `penumbra generate` alike.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "penumbra/scene/scene.h"

namespace penumbra {

/// The scene named `cylinders`, `balls:N`, `rings`, `rings:N`, `molecule` or `bust`; nothing for
/// any other name. Throws Error where N is not in the range that `gallery_help` gives. Coordinates
/// of balls and rings are rounded to the 6 digits that NFF files carry, so that the generated file
/// and the built-in scene agree bit for bit.
std::optional<Scene> gallery_scene(std::string_view name);

/// One line a scene: name and what it shows.
struct GalleryEntry {
  std::string name, description;
};
std::vector<GalleryEntry> gallery_help();

}  // namespace penumbra
