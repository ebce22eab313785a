// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <utility>

#include "penumbra/scene_io/numbers.h"
#include "penumbra/scene_io/point_rows.h"

namespace penumbra {
namespace {

constexpr std::size_t longest_header = std::size_t{1} << 20, longest_word = 1000;

bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

bool ends_line(char c) { return c == '\n' || c == '\r'; }

/// All up to the end of the line `end_header`, and no more than has come by then: who writes may
/// wait for answers.
std::string header_bytes(ByteInput& input) {
  constexpr std::string_view last = "end_header";
  std::string_view bytes = input.peek();
  for (std::size_t from = 0; bytes.size() < longest_header;) {
    const std::size_t found = bytes.find(last, from);
    if (found != bytes.npos && found > 0 && !ends_line(bytes[found - 1])) {
      from = found + 1;  // in a comment
      continue;
    }
    const std::size_t end = found == bytes.npos ? found : bytes.find_first_of("\r\n", found);
    // What follows a \r tells whether it is a line's end by itself.
    if (end != bytes.npos && (bytes[end] == '\n' || end + 1 < bytes.size())) break;
    const std::size_t size = bytes.size();
    from = found != bytes.npos ? found : size - std::min(size, last.size());
    bytes = input.peek(size + 1);
    if (bytes.size() == size) break;
  }
  return std::string(bytes.substr(0, longest_header));
}

}  // namespace

PlyRows::PlyRows(ByteInput& input) : input_(&input) {
  header_ = read_ply_header({input.name(), "ply", header_bytes(input)});
  input.skip(header_.size);
  line_ = header_.lines + 1;
  const auto vertices = std::find_if(header_.elements.begin(), header_.elements.end(),
                                     [](const PlyElement& e) { return e.name == "vertex"; });
  if (vertices == header_.elements.end())
    throw Error({input.name(), header_.lines, {}}, "has no vertices",
                "write `element vertex COUNT` with the properties x, y and z");
  std::for_each(header_.elements.begin(), vertices, [&](const PlyElement& e) { skip(e); });
  vertices_ = *vertices;
  left_ = vertices_.count;
  std::array<bool, point_numbers> has{};
  for (const PlyProperty& property : vertices_.properties) {
    const std::size_t number =
        property.count_type ? point_numbers : point_number_named(property.name);
    const bool is_new = number < point_numbers && !std::exchange(has[number], true);
    property_number_.push_back(is_new ? number : point_numbers);
  }
  // Points with half a normal: as read_ply has it, they have none.
  if (!(has[3] && has[4] && has[5])) has[3] = has[4] = has[5] = false;
  check_point_columns(has, {input.name(), vertices_.line, {}});
  has_normals_ = has[3];
  std::uint64_t least = 0;
  for (const PlyProperty& property : vertices_.properties)
    least += header_.format == PlyFormat::ascii
                 ? 2
                 : size_in_bytes(property.count_type.value_or(property.type));
  const std::optional<std::uint64_t> remaining = input.remaining();
  if (remaining && left_ > (*remaining + 1) / least)
    throw Error({input.name(), vertices_.line, {}},
                "the header claims " + std::to_string(left_) + " vertices, but only " +
                    std::to_string(*remaining) + " bytes follow",
                "the file may be cut off");
}

std::string_view PlyRows::take(std::size_t count) {
  const std::string_view bytes = input_->peek(count);
  if (bytes.size() < count)
    throw Error({input_->name(), {}, input_->at()}, "the file ends within its values",
                "it may be cut off");
  input_->skip(count);
  return bytes.substr(0, count);
}

std::string_view PlyRows::next_word() {
  std::string_view bytes = input_->peek();
  while (!bytes.empty() && is_space(bytes.front())) {
    if (bytes.front() == '\n') ++line_;
    input_->skip(1);
    bytes.remove_prefix(1);
    if (bytes.empty()) bytes = input_->peek();
  }
  for (std::size_t size = 0;;) {
    while (size < bytes.size() && !is_space(bytes[size])) ++size;
    if (size < bytes.size() || size > longest_word) return take(size);
    bytes = input_->peek(size + 1);
    if (bytes.size() == size) return take(size);
  }
}

double PlyRows::value(PlyType type) {
  if (header_.format != PlyFormat::ascii)
    return ply_value(take(size_in_bytes(type)).data(), type, header_.format);
  const std::string_view word = next_word();
  // As float where the file says so: rounded once, not twice.
  if (type == PlyType::float32) {
    if (const std::optional<float> number = parse_float(word)) return *number;
  } else if (const std::optional<double> number = parse_double(word)) {
    return *number;
  }
  const Error::Place place{input_->name(), line_, {}};
  if (word.empty()) throw Error(place, "the file ends within its values", "it may be cut off");
  throw Error(place, "expected a number, found " + in_quotes(word));
}

void PlyRows::skip_value(const PlyProperty& property) {
  double count = 1;
  if (property.count_type) {
    count = value(*property.count_type);
    if (!(count >= 0 && count < 5e9 && count == std::floor(count)))
      throw Error({input_->name(), {}, input_->at()}, "a list claims " + to_text(count) + " values",
                  "give its length, 0 or more");
  }
  for (auto left = static_cast<std::uint64_t>(count); left > 0; --left) value(property.type);
}

void PlyRows::skip(const PlyElement& element) {
  if (element.properties.empty()) return;
  for (std::uint64_t row = 0; row < element.count; ++row)
    for (const PlyProperty& property : element.properties) skip_value(property);
}

std::optional<PointRow> PlyRows::next() {
  if (left_ == 0) return {};
  --left_;
  std::array<float, point_numbers> numbers{};
  for (std::size_t i = 0; i < vertices_.properties.size(); ++i) {
    const PlyProperty& property = vertices_.properties[i];
    const std::size_t number = property_number_[i];
    if (number < point_numbers)
      numbers[number] = static_cast<float>(value(property.type));
    else
      skip_value(property);
  }
  return row_of(numbers);
}

}  // namespace penumbra
