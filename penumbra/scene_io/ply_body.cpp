// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

#include "penumbra/scene_io/numbers.h"
#include "penumbra/scene_io/ply.h"

namespace penumbra {
namespace {

/// Bytes of the machine's order as a number.
template <typename Number>
double number_from(const std::array<char, 8>& bytes) {
  Number number;
  std::memcpy(&number, bytes.data(), sizeof number);
  return static_cast<double>(number);
}

}  // namespace

double ply_value(const char* first, PlyType type, PlyFormat format) {
  const std::string_view raw(first, size_in_bytes(type));
  std::array<char, 8> bytes{};
  const bool is_native =
      (format == PlyFormat::binary_little_endian) == (std::endian::native == std::endian::little);
  if (is_native)
    std::copy(raw.begin(), raw.end(), bytes.begin());
  else
    std::copy(raw.rbegin(), raw.rend(), bytes.begin());
  switch (type) {
    case PlyType::int8: return number_from<std::int8_t>(bytes);
    case PlyType::uint8: return number_from<std::uint8_t>(bytes);
    case PlyType::int16: return number_from<std::int16_t>(bytes);
    case PlyType::uint16: return number_from<std::uint16_t>(bytes);
    case PlyType::int32: return number_from<std::int32_t>(bytes);
    case PlyType::uint32: return number_from<std::uint32_t>(bytes);
    case PlyType::float32: return number_from<float>(bytes);
    case PlyType::float64: break;
  }
  return number_from<double>(bytes);
}

PlyBody::PlyBody(const Source& source, const PlyHeader& header)
    : format_(header.format),
      file_(source.path.string()),
      bytes_(source.bytes),
      at_(header.size),
      last_(header.size),
      tokens_(file_, bytes_.substr(header.size), Comments::none, header.lines + 1) {}

std::size_t PlyBody::remaining() const {
  return format_ == PlyFormat::ascii ? tokens_.remaining() : bytes_.size() - at_;
}

/// A number in text takes a digit and a separator.
std::size_t PlyBody::least_bytes(PlyType type) const {
  return format_ == PlyFormat::ascii ? 2 : size_in_bytes(type);
}

Error::Place PlyBody::place() const {
  if (format_ == PlyFormat::ascii) return {file_, last_, {}};
  return {file_, {}, last_};
}

std::string_view PlyBody::take(std::size_t count) {
  last_ = at_;
  if (count > bytes_.size() - at_)
    throw Error(place(), "the file ends within a value", "it may be cut off");
  at_ += count;
  return bytes_.substr(last_, count);
}

double PlyBody::real(PlyType type) {
  if (format_ != PlyFormat::ascii)
    return ply_value(take(size_in_bytes(type)).data(), type, format_);
  const Token token = tokens_.next();
  last_ = token.line;
  // As float where the file says so: rounded once, not twice.
  if (type == PlyType::float32) {
    if (const std::optional<float> value = parse_float(token.text))
      return static_cast<double>(*value);
  } else if (const std::optional<double> value = parse_double(token.text)) {
    return *value;
  }
  tokens_.fail(token, "a number");
}

std::int64_t PlyBody::integer(PlyType type) {
  if (format_ == PlyFormat::ascii && is_integer(type)) {
    const Token token = tokens_.next();
    last_ = token.line;
    if (const std::optional<std::int64_t> value = parse_integer(token.text)) return *value;
    tokens_.fail(token, "a whole number");
  }
  const double value = real(type);
  if (!(std::abs(value) < 9e15) || value != std::floor(value))
    throw Error(place(), to_text(value) + " stands where a whole number is expected");
  return static_cast<std::int64_t>(value);
}

std::size_t PlyBody::list_length(const PlyProperty& property) {
  const std::int64_t length = integer(*property.count_type);
  if (length < 0)
    throw Error(place(), "a list claims " + std::to_string(length) + " values",
                "give its length, 0 or more");
  const std::size_t least = least_bytes(property.type);
  if (static_cast<std::uint64_t>(length) > (remaining() + 1) / least)
    throw Error(place(),
                "a list claims " + std::to_string(length) + " values, but only " +
                    std::to_string(remaining()) + " bytes follow",
                "the file may be cut off");
  return static_cast<std::size_t>(length);
}

void PlyBody::skip_value(const PlyProperty& property) {
  const std::size_t count = property.count_type ? list_length(property) : 1;
  if (format_ != PlyFormat::ascii) {
    take(count * size_in_bytes(property.type));
    return;
  }
  for (std::size_t i = 0; i < count; ++i) real(property.type);
}

void PlyBody::check_count(const PlyElement& element) const {
  std::uint64_t least = 0;
  for (const PlyProperty& property : element.properties)
    least += least_bytes(property.count_type.value_or(property.type));
  if (least == 0 || element.count <= (remaining() + 1) / least) return;
  throw Error({file_, element.line, {}},
              "the header claims " + std::to_string(element.count) + " rows of " +
                  in_quotes(element.name) + ", but only " + std::to_string(remaining()) +
                  " bytes follow",
              "the file may be cut off");
}

void PlyBody::skip(const PlyElement& element) {
  if (element.properties.empty()) return;
  check_count(element);
  for (std::uint64_t row = 0; row < element.count; ++row)
    for (const PlyProperty& property : element.properties) skip_value(property);
}

}  // namespace penumbra
