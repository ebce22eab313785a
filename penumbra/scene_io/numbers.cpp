// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/numbers.h"

#include <fmt/format.h>

#include <charconv>
#include <concepts>
#include <limits>

namespace penumbra {
namespace {

std::string_view without_plus(std::string_view token) {
  const bool has_plus = token.size() > 1 && token[0] == '+' && token[1] != '-' && token[1] != '+';
  return has_plus ? token.substr(1) : token;
}

/// Whether a decimal number that is out of range is too large, not too small: by the decimal place
/// of its first digit that is not 0.
bool is_huge(std::string_view token) {
  const std::size_t exponent_at = token.find_first_of("eE");
  const std::string_view mantissa = token.substr(0, exponent_at);
  const std::size_t point = std::min(mantissa.find('.'), mantissa.size());
  const std::size_t first = mantissa.find_first_of("123456789");
  if (first == std::string_view::npos) return false;
  auto place = static_cast<std::int64_t>(point) - static_cast<std::int64_t>(first);
  if (exponent_at == std::string_view::npos) return place > 0;
  const std::string_view exponent = token.substr(exponent_at + 1);
  const std::optional<std::int64_t> value = parse_integer(exponent);
  return value ? *value > -place : exponent[0] != '-';
}

template <std::floating_point Number>
std::optional<Number> parse_real(std::string_view token) {
  token = without_plus(token);
  Number value = 0;
  const char* const end = token.data() + token.size();
  const auto [stop, error] = std::from_chars(token.data(), end, value);
  if (error == std::errc::invalid_argument || stop != end) return std::nullopt;
  if (error == std::errc{}) return value;
  const Number size = is_huge(token) ? std::numeric_limits<Number>::infinity() : Number(0);
  return token[0] == '-' ? -size : size;
}

template <std::floating_point Number>
std::string shortest(Number value, std::optional<Number> (*parse)(std::string_view)) {
  std::string text = fmt::format("{:.6g}", value);
  if (parse(text) == value) return text;
  return fmt::format("{:.{}g}", value, std::numeric_limits<Number>::max_digits10);
}

}  // namespace

std::optional<float> parse_float(std::string_view token) { return parse_real<float>(token); }
std::optional<double> parse_double(std::string_view token) { return parse_real<double>(token); }

std::optional<std::int64_t> parse_integer(std::string_view token) {
  token = without_plus(token);
  std::int64_t value = 0;
  const char* const end = token.data() + token.size();
  const auto [stop, error] = std::from_chars(token.data(), end, value);
  if (error != std::errc{} || stop != end) return std::nullopt;
  return value;
}

std::string to_text(float value) { return shortest(value, parse_float); }
std::string to_text(double value) { return shortest(value, parse_double); }

std::string in_quotes(std::string_view token) {
  constexpr std::size_t longest = 40;
  std::string text = "`";
  for (const char c : token.substr(0, longest)) text += c >= ' ' && c <= '~' ? c : '?';
  if (token.size() > longest) text += "...";
  return text + "`";
}

}  // namespace penumbra
