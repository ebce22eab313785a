// SPDX-License-Identifier: MIT
// Files of the Radiance executive control program rad (`.rif`): lines `variable= values` that name
// a scene's files and its views.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "penumbra/geometry/vec.h"
#include "penumbra/scene_io/source.h"

namespace penumbra {

struct RadianceJob {
  struct Mention {
    std::string text;
    std::size_t line = 1;
  };
  std::vector<Mention> files;  ///< materials, illum and scene, in the order in which rad gives them
  std::optional<Mention> view;  ///< the first with options
  Vec3d up{0, 0, 1};
};

/// Throws Error for a file that names no scene.
RadianceJob parse_radiance_job(const Source& source);

}  // namespace penumbra
