// SPDX-License-Identifier: MIT
// Comma-separated values (RFC 4180).
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace penumbra::reproduce {

/// One line, with its end. Values with commas, quotes or line ends are quoted.
std::string csv_line(const std::vector<std::string>& values);

/// Lines of values. Never fails: an unclosed quote ends with the text.
std::vector<std::vector<std::string>> read_csv(std::string_view text);

}  // namespace penumbra::reproduce
