// SPDX-License-Identifier: MIT
// What pages are made of: text, names and pictures as HTML takes them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace penumbra::reproduce {

/// For text and for attributes in quotes, in HTML and XML: plain text, of which nothing is a tag.
std::string escape(std::string_view text);

/// A file beside the page as a link (RFC 3986): nothing of its name can be taken for a scheme, a
/// query or an anchor.
std::string file_link(std::string_view file);

/// "data:image/png;base64,..." (RFC 2397).
std::string data_uri(std::string_view media, std::string_view bytes);

struct PictureSize {
  std::uint32_t width = 0, height = 0;
};

/// As the head of a PNG, JPEG or SVG (in whole units) says; 0 x 0 of anything else.
PictureSize picture_size(std::string_view bytes);

}  // namespace penumbra::reproduce
