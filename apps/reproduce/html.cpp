// SPDX-License-Identifier: MIT
#include "html.h"

#include <fmt/format.h>

#include <charconv>

#include "plain_text.h"

namespace penumbra::reproduce {
namespace {

std::uint32_t byte_at(std::string_view bytes, std::size_t i) {
  return static_cast<unsigned char>(bytes[i]);
}

std::uint32_t two_bytes(std::string_view bytes, std::size_t i) {
  return byte_at(bytes, i) << 8 | byte_at(bytes, i + 1);
}

PictureSize png_size(std::string_view bytes) {
  if (bytes.size() < 24) return {};
  return {two_bytes(bytes, 16) << 16 | two_bytes(bytes, 18),
          two_bytes(bytes, 20) << 16 | two_bytes(bytes, 22)};
}

/// From segment to segment (marker, length) up to the frame header, C0 to CF without C4, C8, CC
/// (ITU-T T.81, B.1 and B.2).
PictureSize jpeg_size(std::string_view bytes) {
  for (std::size_t at = 2; at + 9 <= bytes.size(); at += 2 + two_bytes(bytes, at + 2)) {
    const std::uint32_t marker = byte_at(bytes, at + 1);
    if (marker == 0xC0 || (marker > 0xC0 && marker <= 0xCF && marker % 4 != 0))
      return {two_bytes(bytes, at + 7), two_bytes(bytes, at + 5)};
  }
  return {};
}

std::uint32_t svg_length(std::string_view head, std::string_view name) {
  std::uint32_t length = 0;
  if (const auto at = head.find(name); at != head.npos)
    std::from_chars(head.data() + at + name.size(), head.data() + head.size(), length);
  return length;
}

PictureSize svg_size(std::string_view text) {
  const auto begin = text.find("<svg");
  if (begin == text.npos) return {};
  const std::string_view head = text.substr(begin, text.find('>', begin) - begin);
  return {svg_length(head, " width=\""), svg_length(head, " height=\"")};
}

bool is_plain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
         c == '_' || c == '.' || c == '/';
}

}  // namespace

std::string escape(std::string_view text) {
  std::string escaped;
  for (char c : plain_text(text)) {
    switch (c) {
      case '&': escaped += "&amp;"; break;
      case '<': escaped += "&lt;"; break;
      case '>': escaped += "&gt;"; break;
      case '"': escaped += "&quot;"; break;
      case '\'': escaped += "&#39;"; break;
      default: escaped += c;
    }
  }
  return escaped;
}

std::string file_link(std::string_view file) {
  std::string link;
  for (char c : file)
    link += is_plain(c) ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  return link;
}

std::string data_uri(std::string_view media, std::string_view bytes) {
  static constexpr char digits[] =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text = fmt::format("data:{};base64,", media);
  text.reserve(text.size() + bytes.size() / 3 * 4 + 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8 | (i + k < bytes.size() ? byte_at(bytes, i + k) : 0);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k <= bytes.size() ? digits[group >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

PictureSize picture_size(std::string_view bytes) {
  if (bytes.starts_with("\x89PNG")) return png_size(bytes);
  if (bytes.starts_with("\xFF\xD8")) return jpeg_size(bytes);
  return svg_size(bytes);
}

}  // namespace penumbra::reproduce
