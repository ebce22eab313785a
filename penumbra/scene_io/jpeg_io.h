// SPDX-License-Identifier: MIT
// JPEG by libjpeg: stb_image writes past its tables on damaged files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace penumbra {

/// Three bytes (sRGB codes) a pixel, rows from top to bottom; empty where the bytes are no JPEG.
struct JpegImage {
  std::uint32_t width = 0, height = 0;
  std::vector<std::uint8_t> codes;
};

bool is_jpeg(std::string_view bytes);

/// Nothing is allocated for more than `most_pixels`.
JpegImage decode_jpeg(std::string_view bytes, std::size_t most_pixels);

}  // namespace penumbra
