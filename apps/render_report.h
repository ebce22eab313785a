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

/// Table 2's I_geom and I_shadow: primitives tested in the geometry set a ray, of whatever kind,
/// and grown occluders a ray of the shadow set. 0 where there were no rays.
double geometry_tests_per_ray(const RenderCounters& counters);
double shadow_tests_per_ray(const RenderCounters& counters);

/// The `--stats` file: JSON, keys as docs/formats.md lists them.
std::string stats_json(const RenderReport& report, const Picture& picture);

/// Adds metadata to the image. Of paths only file names are told.
void add_metadata(const RenderReport& report, Picture& picture);

/// "wrote x.png: 512x512, 1.2 s, ..."
std::string summary(const std::string& output, const Picture& picture);

}  // namespace penumbra
