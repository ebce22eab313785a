// SPDX-License-Identifier: MIT
// What glTF writes in "uri" (RFC 3986, RFC 2397, RFC 4648).
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace penumbra {

bool is_data_uri(std::string_view uri);

/// The bytes of a base64 data URI; nothing where it is none.
std::optional<std::string> decode_data_uri(std::string_view uri);

/// A relative reference as a file name: %20 becomes a space.
std::string decode_uri(std::string_view uri);

}  // namespace penumbra
