// SPDX-License-Identifier: MIT
// Pictures in memory: named planes of floats.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace penumbra {

/// A named plane of floats, width x height, rows from top to bottom.
struct Channel {
  std::string name;  ///< OpenEXR's convention: R, G, B, A, or layer.channel such as "class.light0"
  std::vector<float> values;
};

/// A picture: any number of planes of one size.
struct Image {
  std::uint32_t width = 0, height = 0;
  std::vector<Channel> channels;
  std::map<std::string, std::string> metadata;  ///< how it was made
};

/// The channel of that name, or nullptr.
const Channel* find_channel(const Image& image, std::string_view name);

/// Linear value to the 8-bit sRGB code (IEC 61966-2-1), rounded to nearest; NaN and negatives give
/// 0.
std::uint8_t srgb_from_linear(float value);

/// sRGB code, as a fraction of 255 in [0, 1], to the linear value.
float linear_from_srgb(float code);

}  // namespace penumbra
