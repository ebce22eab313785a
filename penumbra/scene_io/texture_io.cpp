// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/texture_io.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <system_error>

#include <fmt/format.h>

#include "penumbra/scene/image.h"
#include "penumbra/scene_io/image_formats.h"
#include "penumbra/scene_io/jpeg_io.h"

// Compiled here, without the formats we don't take, so that none of their decoders is reachable.
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_NO_STDIO
#define STBI_NO_FAILURE_STRINGS
#define STBI_ONLY_PNG
#define STBI_ONLY_TGA
#define STBI_ONLY_BMP
#include <stb/stb_image.h>

namespace penumbra {

namespace {

/// More than the densest image any of the formats can hold (one-bit PNG: 8 pixels in each of the
/// 1032 bytes that deflate makes of one), so that a claimed size needs bytes to back it.
constexpr std::size_t most_pixels_per_byte = 8 * 1032;

std::array<float, 256> code_table(ImageCoding coding) {
  std::array<float, 256> table{};
  for (std::size_t i = 0; i < table.size(); ++i) {
    const float code = static_cast<float>(i) / 255;
    table[i] = coding == ImageCoding::srgb ? linear_from_srgb(code) : code;
  }
  return table;
}

Texture to_texture(std::uint32_t width, std::uint32_t height, const std::uint8_t* codes,
                   ImageCoding coding) {
  Texture texture{width, height, std::vector<Color>(std::size_t{width} * height)};
  const std::array<float, 256> table = code_table(coding);
  for (Color& pixel : texture.pixels) {
    pixel = {table[codes[0]], table[codes[1]], table[codes[2]]};
    codes += 3;
  }
  return texture;
}

bool is_exr(std::string_view bytes) { return bytes.starts_with("\x76\x2f\x31\x01"); }

/// Colours are linear as they are; what is negative or not finite becomes 0.
std::optional<Texture> decode_exr(std::string_view bytes, std::size_t most_pixels) {
  Image image;
  try {
    image = from_exr("texture.exr", bytes);
  } catch (const Error&) {
    return std::nullopt;
  }
  const Channel* grey = image.channels.size() == 1 ? image.channels.data() : nullptr;
  const Channel* rgb[] = {grey, grey, grey};
  for (std::size_t c = 0; c < 3 && !grey; ++c)
    rgb[c] = find_channel(image, std::string_view("RGB").substr(c, 1));
  if (!rgb[0] || !rgb[1] || !rgb[2] || rgb[0]->values.size() > most_pixels) return std::nullopt;
  Texture texture{image.width, image.height, {}};
  const auto clean = [](float v) { return v > 0 && std::isfinite(v) ? v : 0; };
  for (std::size_t i = 0; i < rgb[0]->values.size(); ++i)
    texture.pixels.push_back(
        {clean(rgb[0]->values[i]), clean(rgb[1]->values[i]), clean(rgb[2]->values[i])});
  return texture;
}

/// False where a chunk of a PNG claims more bytes than follow: stb asks for as many (up to a
/// gigabyte) before it looks. Other formats pass.
bool has_whole_chunks(std::string_view bytes) {
  constexpr std::string_view signature("\x89PNG\r\n\x1a\n", 8);
  if (!bytes.starts_with(signature)) return true;
  for (std::size_t at = signature.size(); at + 8 <= bytes.size();) {
    std::size_t size = 0;
    for (std::size_t i = 0; i < 4; ++i)
      size = size << 8 | static_cast<unsigned char>(bytes[at + i]);
    if (bytes.substr(at + 4, 4) == "IEND") return true;
    if (size > bytes.size() - at - 8) return false;
    at += 12 + size;
  }
  return true;
}

}  // namespace

std::optional<Texture> decode_texture(std::string_view bytes, ImageCoding coding,
                                      std::size_t most_pixels) {
  if (bytes.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) return std::nullopt;
  if (is_exr(bytes)) return decode_exr(bytes, most_pixels);
  most_pixels = std::min(most_pixels, bytes.size() * most_pixels_per_byte);
  if (is_jpeg(bytes)) {
    const JpegImage image = decode_jpeg(bytes, most_pixels);
    if (image.codes.empty()) return std::nullopt;
    return to_texture(image.width, image.height, image.codes.data(), coding);
  }
  if (!has_whole_chunks(bytes)) return std::nullopt;
  const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
  const int size = static_cast<int>(bytes.size());
  int width = 0, height = 0, channels = 0;
  if (!stbi_info_from_memory(data, size, &width, &height, &channels)) return std::nullopt;
  if (width <= 0 || height <= 0) return std::nullopt;
  if (static_cast<std::size_t>(width) > most_pixels / static_cast<std::size_t>(height))
    return std::nullopt;
  const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> codes(
      stbi_load_from_memory(data, size, &width, &height, &channels, 3), &stbi_image_free);
  if (!codes) return std::nullopt;
  return to_texture(static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height),
                    codes.get(), coding);
}

std::size_t most_pixels_of(std::size_t bytes) {
  constexpr std::size_t always = std::size_t{1} << 25, most = std::size_t{1} << 27;
  constexpr std::size_t free_bytes = 1'000'000;
  const std::size_t earning = bytes - std::min(bytes, free_bytes);
  return always + std::min(earning, (most - always) / 16) * 16;
}

std::optional<std::filesystem::path> find_beside(const std::filesystem::path& beside,
                                                 std::string_view name) {
  std::string text(name);
  for (char& c : text)
    if (c == '\\') c = '/';
  if (text.empty() || text.find('\0') != std::string::npos) return std::nullopt;
  const std::filesystem::path path(text), folder = beside.parent_path();
  const auto is_file = [](const std::filesystem::path& p) {
    std::error_code problem;
    return std::filesystem::is_regular_file(p, problem);
  };
  if (!path.is_absolute() && is_file(folder / path)) return folder / path;
  if (path.has_filename() && is_file(folder / path.filename())) return folder / path.filename();
  return std::nullopt;
}

std::string file_key(const std::filesystem::path& path) {
  std::error_code problem;
  const std::filesystem::path canonical = std::filesystem::weakly_canonical(path, problem);
  return problem ? path.string() : canonical.string();
}

std::int32_t TextureLoader::from_file(std::string_view name,
                                      const std::optional<Error::Place>& mention) {
  const auto warn = [&](const std::string& kind) {
    mention ? warnings_.add(kind, *mention) : warnings_.add(kind);
  };
  const std::string key = "file " + std::string(name);
  if (const auto known = known_.find(key); known != known_.end()) return known->second;
  const auto path = find_beside(source_.path, name);
  if (!path) {
    warn(fmt::format("the texture '{}' is missing; its surfaces are plain", name));
    return known_[key] = -1;
  }
  const std::string file = "file " + file_key(*path);
  if (const auto known = known_.find(file); known != known_.end())
    return known_[key] = known->second;
  try {
    return known_[key] = known_[file] = from_bytes(key, load(*path).bytes);
  } catch (const Error& error) {
    warn(fmt::format("the texture '{}' cannot be read: {}", name, error.problem));
    return known_[key] = -1;
  }
}

std::int32_t TextureLoader::from_bytes(const std::string& key, std::string_view bytes) {
  if (const auto known = known_.find(key); known != known_.end()) return known->second;
  bytes_ += bytes.size();
  auto texture = decode_texture(bytes, ImageCoding::srgb, most_pixels_of(bytes_) - pixels_);
  if (!texture) {
    warnings_.add(fmt::format(
        "the image of {} is no PNG, JPEG, TGA, BMP or OpenEXR, is damaged, or is too large; its "
        "surfaces are plain",
        key));
    return known_[key] = -1;
  }
  pixels_ += texture->pixels.size();
  scene_.textures.push_back(std::move(*texture));
  return known_[key] = static_cast<std::int32_t>(scene_.textures.size()) - 1;
}

}  // namespace penumbra
