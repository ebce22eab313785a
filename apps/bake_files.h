// SPDX-License-Identifier: MIT
// Which files a bake becomes, and what is in them.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "penumbra/scene_io/image_io.h"
#include "penumbra/trace/bake.h"
#include "penumbra/trace/bake_objects.h"

namespace penumbra {

enum class BakeChannel { per_light, mean };

struct BakeOutput {
  std::string path;  ///< .png or .exr
  BakeChannel channel = BakeChannel::per_light;
  bool has_classes = false, has_coverage = false;  ///< layers of an .exr
  GreyCoding png;
};

/// Of one texture: an .exr holds all lights, a .png one; where there are several, their number
/// comes before the extension.
std::vector<std::string> files_of(const BakeOutput& output, std::size_t lights);

/// The output for each object: its name, as far as file names go, before the extension, and a
/// number behind it where another has that name already. No two are the same.
std::vector<BakeOutput> outputs_of(const BakeOutput& output,
                                   const std::vector<BakeObject>& objects);

/// Writes them, in the order of `files_of`. Throws Error.
void write_bake(const BakeOutput& output, Image baked, std::size_t lights);

}  // namespace penumbra
