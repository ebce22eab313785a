// SPDX-License-Identifier: MIT
#include "number_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>

namespace penumbra::reproduce {

std::string grouped(std::int64_t number) {
  std::string digits = std::to_string(number);
  const std::ptrdiff_t sign = number < 0 ? 1 : 0;
  for (auto i = static_cast<std::ptrdiff_t>(digits.size()) - 3; i > sign; i -= 3)
    digits.insert(digits.begin() + i, ',');
  return digits;
}

std::string rounded(double number) {
  if (!std::isfinite(number)) return "-";
  if (number == 0) return "0";
  const double shown = std::strtod(fmt::format("{:.2e}", number).c_str(), nullptr);
  if (std::abs(shown) >= 1000 && std::abs(shown) < 1e15)
    return grouped(static_cast<std::int64_t>(shown));
  const int before_point = static_cast<int>(std::floor(std::log10(std::abs(shown)) + 1e-9)) + 1;
  if (before_point < -3 || before_point > 15) return fmt::format("{:.2e}", shown);
  return fmt::format("{:.{}f}", shown, std::max(0, 3 - before_point));
}

}  // namespace penumbra::reproduce
