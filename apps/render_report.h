// SPDX-License-Identifier: MIT
// What a rendering tells about itself: statistics, picture metadata, the closing line.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "penumbra/trace/render.h"

namespace penumbra {

/// How a picture came to be, beside what `Picture` says.
struct RenderReport {
  std::string scene;                   ///< as given
  std::vector<std::string> arguments;  ///< the whole command line
  RenderOptions options;
  Method method = Method::stochastic;
  double load_seconds = 0, build_seconds = 0;
  std::size_t geometry_bytes = 0, shadow_bytes = 0;
  std::size_t verified = 0;  ///< answers that the judge confirmed
};

/// The `--stats` file: JSON, keys as docs/formats.md lists them.
std::string stats_json(const RenderReport& report, const Picture& picture);

/// Adds metadata to the image. Of paths only file names are told.
void add_metadata(const RenderReport& report, Picture& picture);

/// "wrote x.png: 512x512, 1.2 s, ..."
std::string summary(const std::string& output, const Picture& picture);

}  // namespace penumbra
