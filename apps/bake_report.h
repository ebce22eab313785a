// SPDX-License-Identifier: MIT
// What a bake tells about itself: warnings, statistics, metadata, the closing line.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "penumbra/trace/bake.h"
#include "penumbra/trace/bake_objects.h"

namespace penumbra {

/// How textures came to be. Sums over all of them.
struct BakeReport {
  std::string scene;                   ///< as given
  std::vector<std::string> arguments;  ///< the whole command line
  BakeOptions options;
  Method method = Method::shaft;
  UvSet set = UvSet::first;
  std::size_t lights = 0;
  std::vector<std::string> files;
  BakeCounters counters;
  UvFaults faults;
  std::uint64_t triangles = 0;
  std::uint32_t threads = 1;
  double load_seconds = 0, build_seconds = 0, bake_seconds = 0;
};

/// What is left out before anything is baked.
std::vector<std::string> warnings_of(const BakeObjects& objects);
/// What of the coordinates was in the way. `is_atlas`: several objects share a texture.
std::vector<std::string> warnings_of(const BakeReport& report, bool is_atlas);

/// The `--stats` file: JSON, keys as docs/formats.md lists them.
std::string stats_json(const BakeReport& report);

void add_metadata(const BakeReport& report, Image& image);

/// "wrote x.png: 1024x1024, 1 light, ..."
std::string summary(const BakeReport& report);

}  // namespace penumbra
