// SPDX-License-Identifier: MIT
// glTF in parts, read.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "tests/scene_io/gltf_text.h"
#include "tests/scene_io/text_source.h"

namespace penumbra {

struct GltfRead {
  Scene scene;
  std::vector<std::string> warnings;
};

inline GltfRead read_valid(const Source& source) {
  Warnings warnings(source.path.string());
  Scene scene = read_gltf(source, warnings);
  validate(scene);
  return {std::move(scene), warnings.lines()};
}

inline GltfRead read(const GltfText& text) { return read_valid(source_of("t.gltf", text.json())); }

/// As the reader leaves it: validate wants instances to be expanded or drawn.
inline Scene parsed(const GltfText& text) {
  Warnings warnings("t.gltf");
  return read_gltf(source_of("t.gltf", text.json()), warnings);
}

inline std::string error_in(const GltfText& text) {
  return error_of([&] { parsed(text); });
}

}  // namespace penumbra
