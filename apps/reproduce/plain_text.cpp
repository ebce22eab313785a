// SPDX-License-Identifier: MIT
#include "plain_text.h"

namespace penumbra::reproduce {
namespace {

/// Of the character that begins at `at`; 0 where none does (RFC 3629, section 4).
std::size_t character_bytes(std::string_view bytes, std::size_t at) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(bytes[at + i]); };
  const unsigned char lead = byte(0);
  if (lead < 0x80) return 1;
  if (lead < 0xC2 || lead > 0xF4) return 0;
  const std::size_t count = lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
  if (count > bytes.size() - at) return 0;
  for (std::size_t i = 1; i < count; ++i)
    if ((byte(i) & 0xC0) != 0x80) return 0;
  const bool is_overlong = (lead == 0xE0 && byte(1) < 0xA0) || (lead == 0xF0 && byte(1) < 0x90);
  const bool is_no_character = (lead == 0xED && byte(1) > 0x9F) || (lead == 0xF4 && byte(1) > 0x8F);
  return is_overlong || is_no_character ? 0 : count;
}

}  // namespace

std::string plain_text(std::string_view bytes) {
  std::string text;
  for (std::size_t at = 0; at < bytes.size();) {
    const std::size_t count = character_bytes(bytes, at);
    const bool is_control = static_cast<unsigned char>(bytes[at]) < 32 || bytes[at] == 127;
    text += count == 0 ? "?" : is_control ? " " : bytes.substr(at, count);
    at += count == 0 ? 1 : count;
  }
  return text;
}

}  // namespace penumbra::reproduce
