// SPDX-License-Identifier: MIT
// Pictures as files: PNG (8-bit sRGB) and OpenEXR (32-bit float, any number of layers).
#pragma once

#include <filesystem>

#include "penumbra/scene/image.h"

namespace penumbra {

/// By extension: `.png` takes the channels R, G, B times 2^exposure_ev (exposure is for PNG alone)
/// and stores metadata as text chunks, `.exr` stores all channels as they are and metadata as
/// string attributes. Nothing appears at `path` unless all of it was written. Throws Error.
void write_image(const std::filesystem::path& path, const Image& image, float exposure_ev = 0);

/// How values of a grey PNG are stored.
struct GreyCoding {
  int bits = 8;          ///< or 16
  bool is_srgb = false;  ///< of 8 bits: as sRGB codes, for what is decoded as a colour; else value
                         ///< x 255 or 65535, for what is data
};

/// The one channel of an image as a grey PNG, values cut off at 0 and 1. As `write_image` else.
void write_grey_image(const std::filesystem::path& path, const Image& image,
                      const GreyCoding& coding);

/// Throws Error unless `write_image` could write there: known extension, writable folder. Call it
/// before hours of work.
void check_image_path(const std::filesystem::path& path);

/// Throws Error unless a file can be made there: finds out by making one beside it, and removes it.
/// What is there and no file (a pipe) is left alone.
void check_output_path(const std::filesystem::path& path);

/// Reads PNG (R, G, B as stored codes / 255, not linearised) or EXR (all channels). Throws Error;
/// more than 2^28 pixels, and pixels that the file is too short to hold, are refused before
/// anything is allocated for them.
Image read_image(const std::filesystem::path& path);

}  // namespace penumbra
