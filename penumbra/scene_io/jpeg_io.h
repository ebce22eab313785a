// SPDX-License-Identifier: MIT
// JPEG by libjpeg: stb_image writes past its tables on damaged files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "penumbra/scene/image.h"

namespace penumbra {

/// Three bytes (sRGB codes) a pixel, rows from top to bottom; empty where the bytes are no JPEG.
struct JpegImage {
  std::uint32_t width = 0, height = 0;
  std::vector<std::uint8_t> codes;
};

bool is_jpeg(std::string_view bytes);

/// Nothing is allocated for more than `most_pixels`.
JpegImage decode_jpeg(std::string_view bytes, std::size_t most_pixels);

/// R, G and B with the tone curve of the PNG writer; `quality` from 1 to 100, all colours in full
/// resolution. Throws Error where a channel is missing or the picture is empty or more than 65500
/// pixels wide or high.
std::string encode_jpeg(const Image& image, int quality, float exposure_ev = 0);

}  // namespace penumbra
