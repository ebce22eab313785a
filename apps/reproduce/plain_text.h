// SPDX-License-Identifier: MIT
// Text that any reader takes. Names come from files, and those are but bytes.
#pragma once

#include <string>
#include <string_view>

namespace penumbra::reproduce {

/// One line of UTF-8 (RFC 3629): control characters become spaces, bytes that are no UTF-8 "?".
std::string plain_text(std::string_view bytes);

}  // namespace penumbra::reproduce
