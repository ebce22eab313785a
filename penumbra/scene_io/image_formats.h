// SPDX-License-Identifier: MIT
// The picture formats, bytes to picture and back; `image_io.h` chooses between them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "penumbra/scene/image.h"
#include "penumbra/scene_io/image_io.h"

namespace penumbra {

// `name` is the file's name in messages. All throw Error.
std::string to_png(const std::filesystem::path& name, const Image& image, float exposure_ev);
std::string to_grey_png(const std::filesystem::path& name, const Image& image,
                        const GreyCoding& coding);
Image from_png(const std::filesystem::path& name, std::string_view bytes);
std::string to_exr(const std::filesystem::path& name, const Image& image);
Image from_exr(const std::filesystem::path& name, std::string_view bytes);

/// Three bytes (sRGB codes) a pixel, rows from top to bottom, of R, G and B times 2^exposure_ev.
/// Throws Error where one of them is missing.
std::vector<std::uint8_t> srgb_codes(const std::filesystem::path& name, const Image& image,
                                     float exposure_ev);

/// Throws Error where a header claims more than 2^28 pixels, none, or more raw bytes than `stored`
/// bytes can unpack to. Call it before allocating.
void check_picture_size(const std::filesystem::path& name, std::uint64_t width,
                        std::uint64_t height, std::uint64_t bytes_per_pixel, std::uint64_t stored);

}  // namespace penumbra
