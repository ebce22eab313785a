// SPDX-License-Identifier: MIT
// pbrt-v4's directives (pbrt.org/fileformat-v4), each a function that reads what follows its name.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "penumbra/scene_io/pbrt_scene.h"

namespace penumbra {

/// What AttributeBegin, TransformBegin, ObjectBegin or Attribute are to bring back.
struct PbrtSaved {
  std::string_view begin;  ///< the directive
  PbrtPlace place;
  PbrtGraphics graphics;
};

struct PbrtParser {
  explicit PbrtParser(PbrtScene& scene) : pbrt(scene) {}

  PbrtScene& pbrt;
  std::vector<PbrtSaved> saved;
  std::size_t files_deep = 0, files = 0, repeated_bytes = 0;
  std::set<std::string> known_files;
};

using PbrtDirective = void (*)(PbrtParser&, PbrtTokens&, PbrtPlace);

// The directive of that name among those that move things, and among all others; nullptr where
// there is none.
PbrtDirective find_pbrt_transformation(std::string_view name);
PbrtDirective find_pbrt_directive(std::string_view name);

/// Reads a text's directives. Throws Error for those that pbrt-v4 does not have.
void parse_pbrt(PbrtParser& parser, PbrtTokens& tokens);

// What blocks are made of: saves the graphics state; brings it back, checking that `begin` was the
// last block begun.
void open_pbrt_block(PbrtParser& parser, std::string_view begin, PbrtPlace place);
PbrtSaved close_pbrt_block(PbrtParser& parser, std::string_view begin, std::string_view end,
                           PbrtPlace place);

}  // namespace penumbra
