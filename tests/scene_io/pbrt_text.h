// SPDX-License-Identifier: MIT
// pbrt scenes in tests.
#pragma once

#include <string>
#include <vector>

#include "tests/scene_io/text_source.h"

namespace penumbra {

struct PbrtResult {
  Scene scene;
  std::vector<std::string> warnings;
};

inline PbrtResult read_pbrt_file(const Source& source) {
  Warnings warnings(source.path.string());
  Scene scene = read_pbrt(source, warnings);
  return {std::move(scene), warnings.lines()};
}

inline PbrtResult read_pbrt_text(const std::string& text) {
  return read_pbrt_file(source_of("t.pbrt", text));
}

inline std::string pbrt_error(const std::string& text) {
  return error_of([&] { read_pbrt_text(text); });
}

inline bool warns(const PbrtResult& result, const std::string& part) {
  for (const std::string& line : result.warnings)
    if (holds(line, part)) return true;
  return false;
}

}  // namespace penumbra
