// SPDX-License-Identifier: MIT
// The files that a Radiance scene is made of: found as Radiance finds them, each read once.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "penumbra/scene_io/radiance_file.h"

namespace penumbra {

/// Finds and keeps files. Names are looked for beside the file that mentions them, beside the scene
/// and in the folder above it (where Radiance's commands are usually run), in the working folder,
/// and in the folders of the environment variable RAYPATH.
class RadianceLibrary {
 public:
  explicit RadianceLibrary(std::filesystem::path scene) : scene_(std::move(scene)) {}

  /// The parsed file; it lives as long as the library. Throws Error at `place` where there is none,
  /// and what `parse_radiance` throws.
  const RadianceFile& open(const std::string& name, const Error::Place& place);
  /// Its bytes.
  std::string text(const std::string& name, const Error::Place& place) const;
  /// Keeps a file that was made here.
  const RadianceFile& keep(RadianceFile file);

 private:
  std::filesystem::path find(const std::string& name, const Error::Place& place) const;

  std::filesystem::path scene_;
  std::map<std::filesystem::path, std::unique_ptr<RadianceFile>> files_;
  std::vector<std::unique_ptr<RadianceFile>> made_;
};

}  // namespace penumbra
