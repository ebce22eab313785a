// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/gltf_uri.h"

#include <array>
#include <charconv>
#include <cstdint>

namespace penumbra {

namespace {

constexpr std::array<std::int8_t, 256> base64_values() {
  constexpr std::string_view digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::array<std::int8_t, 256> values{};
  values.fill(-1);
  for (std::size_t i = 0; i < digits.size(); ++i)
    values[static_cast<unsigned char>(digits[i])] = static_cast<std::int8_t>(i);
  return values;
}

std::optional<std::string> decode_base64(std::string_view text) {
  constexpr auto values = base64_values();
  while (text.ends_with('=')) text.remove_suffix(1);
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3 + 3);
  std::uint32_t pending = 0;
  int bits = 0;
  for (char c : text) {
    const std::int8_t value = values[static_cast<unsigned char>(c)];
    if (value < 0) return std::nullopt;
    pending = (pending << 6 | static_cast<std::uint32_t>(value)) & 0xFFFF;
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes += static_cast<char>(pending >> bits & 0xFF);
  }
  return bytes;
}

}  // namespace

bool is_data_uri(std::string_view uri) { return uri.starts_with("data:"); }

std::optional<std::string> decode_data_uri(std::string_view uri) {
  const std::size_t comma = uri.find(',');
  if (!is_data_uri(uri) || comma == std::string_view::npos) return std::nullopt;
  if (!uri.substr(0, comma).ends_with(";base64")) return std::nullopt;
  return decode_base64(uri.substr(comma + 1));
}

std::string decode_uri(std::string_view uri) {
  std::string name;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    std::uint8_t code = 0;
    if (uri[i] == '%' && i + 2 < uri.size()) {
      const char* begin = uri.data() + i + 1;
      const auto [stop, problem] = std::from_chars(begin, begin + 2, code, 16);
      if (problem == std::errc{} && stop == begin + 2) {
        name += static_cast<char>(code);
        i += 2;
        continue;
      }
    }
    name += uri[i];
  }
  return name;
}

}  // namespace penumbra
