// SPDX-License-Identifier: MIT
// glTF's typed arrays: any component type, strided, sparse, normalised.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "penumbra/scene_io/gltf_document.h"

namespace penumbra {

/// Rows of `width` floats.
struct GltfRows {
  std::size_t width = 0;
  std::vector<float> values;

  std::size_t count() const { return width == 0 ? 0 : values.size() / width; }
  const float* row(std::size_t i) const { return values.data() + i * width; }
};

/// Reads an accessor as floats, integers by their value or, where normalised, in [-1, 1]. Counts
/// are checked against the bytes there are before anything is allocated. Throws Error, with the
/// byte for a number that is not finite.
GltfRows read_rows(GltfDocument& gltf, std::size_t accessor);

/// Reads an accessor of unsigned whole numbers.
std::vector<std::uint32_t> read_indices(GltfDocument& gltf, std::size_t accessor);

}  // namespace penumbra
