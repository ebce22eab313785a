// SPDX-License-Identifier: MIT
// Numbers as text, both ways, the same under every locale.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace penumbra {

// The whole token as a number in C's decimal notation, a leading '+' allowed; nothing if it is
// none. Rounded correctly. Beyond the range: infinite or zero, so that callers need only ask for
// finite.
std::optional<float> parse_float(std::string_view token);
std::optional<double> parse_double(std::string_view token);
/// Decimal digits only; nothing beyond 64 bits.
std::optional<std::int64_t> parse_integer(std::string_view token);

// 6 significant digits when they read back to the same number, else as many as it takes (9, 17).
std::string to_text(float value);
std::string to_text(double value);

/// The token in backquotes for messages: at most 40 characters of it, unprintable ones as '?'.
std::string in_quotes(std::string_view token);

}  // namespace penumbra
