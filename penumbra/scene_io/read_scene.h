// SPDX-License-Identifier: MIT
// Files -> scenes. One reader a format, chosen by extension (and content where extensions lie).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "penumbra/scene/error.h"
#include "penumbra/scene/scene.h"

namespace penumbra {

/// How atoms and bonds are drawn.
enum class MoleculeStyle { ball_and_stick, space_filling };

/// Of molecules alone.
struct ReadOptions {
  MoleculeStyle style = MoleculeStyle::ball_and_stick;
  bool waters = false;  ///< keep water molecules
};

/// A scene, and what was odd about the file: one line a kind of oddity, with its place.
struct SceneFile {
  Scene scene;
  std::vector<std::string> warnings;
};

/// Reads any known format, `.gz` of any of them included; the scene is validated. Throws Error.
SceneFile read_scene(const std::filesystem::path& path, const ReadOptions& options = {});

}  // namespace penumbra
