// SPDX-License-Identifier: MIT
#include "axis.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace penumbra::reproduce {
namespace {

Axis log_axis(double low, double high) {
  const double room = std::max(std::pow(high / low, 0.05), 1.1);
  return {low / room, high * room, true};
}

Axis linear_axis(double low, double high) {
  if (low >= 0 && low < 0.5 * high) low = 0;
  double room = 0.05 * (high - low);
  if (!(room > 0)) room = std::max(0.1 * std::abs(high), 1e-3);
  return {low == 0 ? 0 : low - room, high + room, false};
}

std::string tic(double value, int exponent, bool has_long_numbers) {
  const double mantissa = std::round(value / std::pow(10, exponent));
  if (!has_long_numbers) return fmt::format("\"{:g}\" {:g}", value, value);
  if (mantissa == 1) return fmt::format("\"10^{{{}}}\" {:g}", exponent, value);
  return fmt::format("\"{:g}·10^{{{}}}\" {:g}", mantissa, exponent, value);
}

}  // namespace

Axis axis_around(const std::vector<double>& values, bool has_log) {
  std::vector<double> kept;
  for (double value : values)
    if (std::isfinite(value) && (value > 0 || !has_log)) kept.push_back(value);
  if (kept.empty()) return has_log ? Axis{1, 10, true} : Axis{};
  const auto [low, high] = std::minmax_element(kept.begin(), kept.end());
  return has_log ? log_axis(*low, *high) : linear_axis(*low, *high);
}

std::string log_tics(const Axis& axis) {
  const double decades = std::log10(axis.high / axis.low);
  const bool has_long_numbers = axis.low < 1e-3 || axis.high >= 1e5;
  const int first = static_cast<int>(std::floor(std::log10(axis.low)));
  const int last = static_cast<int>(std::ceil(std::log10(axis.high)));
  const int step = decades > 8 ? 2 : 1;
  std::vector<std::string> tics;
  for (int exponent = first; exponent <= last; exponent += step)
    for (int mantissa = 1; mantissa < 10; ++mantissa) {
      const double value = mantissa * std::pow(10, exponent);
      if (value < axis.low || value > axis.high) continue;
      const bool is_named =
          mantissa == 1 || (decades < 1 && mantissa % 2 == 0) ||
          (decades < (has_long_numbers ? 1.5 : 3) && (mantissa == 2 || mantissa == 5));
      tics.push_back(is_named ? tic(value, exponent, has_long_numbers)
                              : fmt::format("\"\" {:g} 1", value));
    }
  return fmt::format("({})", fmt::join(tics, ", "));
}

}  // namespace penumbra::reproduce
