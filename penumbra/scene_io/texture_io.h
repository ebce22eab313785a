// SPDX-License-Identifier: MIT
// Base colour images, and the other files that a scene's file names: found beside it, read with
// limits, decoded once.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "penumbra/scene/scene.h"
#include "penumbra/scene_io/source.h"

namespace penumbra {

/// How an image's codes become numbers: colours are sRGB, everything else is stored as it is.
enum class ImageCoding { srgb, plain };

/// PNG, JPEG, TGA, BMP or OpenEXR (always linear) as a texture, alpha dropped; nothing where the
/// bytes are none of these or more than `most_pixels`. Sizes that the bytes cannot hold are refused
/// before anything is allocated for them.
std::optional<Texture> decode_texture(std::string_view bytes, ImageCoding coding,
                                      std::size_t most_pixels);

/// The regular file that a scene's file calls `name` (slashes of either kind): relative to the
/// folder of `beside`, or of that name in the folder itself; absolute paths are looked for by their
/// last part only. Nothing where there is none.
std::optional<std::filesystem::path> find_beside(const std::filesystem::path& beside,
                                                 std::string_view name);

/// The same for all names of a file.
std::string file_key(const std::filesystem::path& path);

/// How many pixels images of so many bytes together may have: 2^25, and 16 for each byte beyond the
/// first million, up to 2^27. Packed well, a small file could hold far more.
std::size_t most_pixels_of(std::size_t bytes);

/// Puts textures into a scene: each file is decoded once, all of them together stay below
/// `most_pixels_of` their bytes. What cannot be had is one warning, and -1 (no texture).
class TextureLoader {
 public:
  TextureLoader(const Source& source, Scene& scene, Warnings& warnings)
      : source_(source), scene_(scene), warnings_(warnings) {}

  /// Index of the texture in the scene. `mention`: where the file is named, for the warning.
  std::int32_t from_file(std::string_view name, const std::optional<Error::Place>& mention = {});
  /// The same for an image inside the scene's file; `key` names it.
  std::int32_t from_bytes(const std::string& key, std::string_view bytes);

 private:
  const Source& source_;
  Scene& scene_;
  Warnings& warnings_;
  std::map<std::string, std::int32_t> known_;
  std::size_t bytes_ = 0, pixels_ = 0;  ///< of all images so far
};

}  // namespace penumbra
