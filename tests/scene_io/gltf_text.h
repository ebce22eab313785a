// SPDX-License-Identifier: MIT
// A small glTF file in parts that tests exchange: four corners of a square and their indices.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>

namespace penumbra {

inline std::string base64(const std::string& bytes) {
  static constexpr char digits[] =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k <= bytes.size() ? digits[group >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

/// One opaque pixel.
inline std::string tiny_png_base64() {
  return "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNk+"
         "M9QDwADhgGAWjR9awAAAABJRU5ErkJg"
         "gg==";
}

/// 16 x 8 greys.
inline std::string tiny_jpeg_base64() {
  return "/9j/4AAQSkZJRgABAQAAAQABAAD/2wBDABALDA4MChAODQ4SERATGCgaGBYWGDEjJR0oOjM9PDkzODdASFxOQERX"
         "RTc4UG1RV19iZ2hnPk1xeXBkeFxlZ2P/wAALCAAIABABAREA/8QAFAABAAAAAAAAAAAAAAAAAAAAAP/EABcQAAMB"
         "AAAAAAAAAAAAAAAAAAAWY6H/2gAIAQEAAD8AO9dDvXT/2Q==";
}

struct GltfText {
  std::string scene_nodes = "0", nodes = R"({"mesh":0})", primitive, rest, buffer_uri;
  std::string more_views, more_buffers;
  std::string positions = R"("bufferView":0,"componentType":5126,"type":"VEC3","count":4)";
  std::string indices = R"("bufferView":1,"componentType":5121,"count":3)";

  /// 0: positions (48 bytes), 48: 0 1 2 3 in bytes, 52: in 16 bits, 60: in 32 bits.
  static std::string bytes() {
    const float corners[12] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};
    const std::uint8_t small[4] = {0, 1, 2, 3};
    const std::uint16_t medium[4] = {0, 1, 2, 3};
    const std::uint32_t large[4] = {0, 1, 2, 3};
    std::string all(76, '\0');
    std::memcpy(all.data(), corners, 48);
    std::memcpy(all.data() + 48, small, 4);
    std::memcpy(all.data() + 52, medium, 8);
    std::memcpy(all.data() + 60, large, 16);
    return all;
  }

  std::string json_with_buffer(const std::string& buffer) const {
    return R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[)" + scene_nodes + R"(]}],"nodes":[)" +
           nodes + R"(],"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1)" +
           primitive + R"(}]}],"accessors":[{)" + positions + R"(},{"type":"SCALAR",)" + indices +
           R"(}],"bufferViews":[{"buffer":0,"byteLength":48},
    {"buffer":0,"byteOffset":48,"byteLength":4},{"buffer":0,"byteOffset":52,"byteLength":8},
    {"buffer":0,"byteOffset":60,"byteLength":16},{"buffer":0,"byteOffset":48,"byteLength":4},
    {"buffer":0,"byteOffset":60,"byteLength":1000})" +
           more_views + R"(],"buffers":[{"byteLength":76)" + buffer + "}" + more_buffers + "]" +
           rest + "}";
  }

  std::string json() const {
    const std::string uri =
        buffer_uri.empty() ? "data:application/octet-stream;base64," + base64(bytes()) : buffer_uri;
    return json_with_buffer(R"(,"uri":")" + uri + "\"");
  }

  std::string glb() const {
    std::string text = json_with_buffer("");
    while (text.size() % 4 != 0) text += ' ';
    const auto u32 = [](std::size_t n) {
      const auto value = static_cast<std::uint32_t>(n);
      std::string four(4, '\0');
      std::memcpy(four.data(), &value, 4);
      return four;
    };
    const std::string body =
        u32(text.size()) + "JSON" + text + u32(bytes().size()) + std::string("BIN\0", 4) + bytes();
    return "glTF" + u32(2) + u32(12 + body.size()) + body;
  }
};

}  // namespace penumbra
