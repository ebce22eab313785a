// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/npy_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>

#include "penumbra/scene/error.h"
#include "penumbra/scene_io/numbers.h"

namespace penumbra {
namespace {

constexpr std::size_t longest_header = std::size_t{1} << 16, most_dimensions = 64;

/// Reads the dictionary, a Python literal, as NumPy writes it: nothing else stands there.
class Literal {
 public:
  Literal(std::string_view text, const std::string& file) : rest_(text), file_(file) {}

  NpyHeader header() {
    NpyHeader header;
    bool has_type = false, has_order = false, has_shape = false;
    expect('{');
    while (!take('}')) {
      const std::string_view key = string();
      expect(':');
      if (key == "descr") {
        read_type(header);
        has_type = true;
      } else if (key == "fortran_order") {
        header.is_fortran_order = boolean();
        has_order = true;
      } else if (key == "shape") {
        read_shape(header);
        has_shape = true;
      } else {
        fail();
      }
      if (take(',')) continue;
      expect('}');
      break;
    }
    if (!has_type || !has_order || !has_shape) fail();
    return header;
  }

 private:
  [[noreturn]] void fail() const {
    throw Error({file_, {}, {}}, "the header is not NumPy's", "write it with numpy.save");
  }
  void skip_space() {
    rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t\r\n"), rest_.size()));
  }
  bool take(char c) {
    skip_space();
    if (!rest_.starts_with(c)) return false;
    rest_.remove_prefix(1);
    return true;
  }
  void expect(char c) {
    if (!take(c)) fail();
  }
  std::string_view string() {
    skip_space();
    if (rest_.empty() || (rest_[0] != '\'' && rest_[0] != '"')) fail();
    const std::size_t end = rest_.find(rest_[0], 1);
    if (end == rest_.npos) fail();
    const std::string_view text = rest_.substr(1, end - 1);
    rest_.remove_prefix(end + 1);
    return text;
  }
  bool boolean() {
    skip_space();
    const bool is_true = rest_.starts_with("True");
    if (!is_true && !rest_.starts_with("False")) fail();
    rest_.remove_prefix(is_true ? 4 : 5);
    return is_true;
  }

  void read_type(NpyHeader& header) {
    skip_space();
    if (rest_.starts_with('['))
      throw Error({file_, {}, {}}, "is a structured array",
                  "save a plain one: "
                  "numpy.lib.recfunctions.structured_to_unstructured(points[['x', 'y', 'z']])");
    const std::string_view type = string();
    header.type = type.substr(0, 40);
    if (type.size() < 2) fail();
    header.is_big_endian = type[0] == '>';
    header.kind = type[1];
    const std::optional<std::int64_t> bytes = parse_integer(type.substr(2));
    header.value_bytes = bytes && *bytes > 0 ? static_cast<std::size_t>(*bytes) : 0;
  }

  void read_shape(NpyHeader& header) {
    expect('(');
    while (!take(')')) {
      skip_space();
      const std::size_t digits = std::min(rest_.find_first_not_of("0123456789"), rest_.size());
      const std::optional<std::int64_t> count = parse_integer(rest_.substr(0, digits));
      if (!count || header.shape.size() == most_dimensions) fail();
      header.shape.push_back(static_cast<std::uint64_t>(*count));
      rest_.remove_prefix(digits);
      take('L');  // of Python 2
      if (take(',')) continue;
      expect(')');
      break;
    }
  }

  std::string_view rest_;
  const std::string& file_;
};

}  // namespace

std::string NpyHeader::shape_text() const {
  std::string text = "(";
  for (const std::uint64_t count : shape)
    text += (text.size() > 1 ? ", " : "") + std::to_string(count);
  return text + (shape.size() == 1 ? ",)" : ")");
}

NpyHeader read_npy_header(ByteInput& input) {
  const auto at_least = [&](std::size_t size) {
    const std::string_view bytes = input.peek(size);
    if (bytes.size() < size)
      throw Error({input.name(), {}, bytes.size()}, "the file ends within its header",
                  "it may be cut off");
    return bytes;
  };
  const std::string_view start = at_least(npy_magic.size() + 4);
  if (!start.starts_with(npy_magic))
    throw Error({input.name(), {}, 0}, "does not begin as NumPy's files do",
                "write it with numpy.save");
  const auto byte = [&](std::string_view bytes, std::size_t i) {
    return static_cast<std::size_t>(static_cast<unsigned char>(bytes[npy_magic.size() + i]));
  };
  const std::size_t version = byte(start, 0);
  if (version < 1 || version > 3)
    throw Error({input.name(), {}, npy_magic.size()},
                fmt::format("is of version {} of NumPy's format", version),
                "versions 1 to 3 are known");
  const std::size_t length_bytes = version == 1 ? 2 : 4;
  const std::string_view head = at_least(npy_magic.size() + 2 + length_bytes);
  std::size_t length = 0;
  for (std::size_t i = length_bytes; i-- > 0;) length = 256 * length + byte(head, 2 + i);
  if (length > longest_header)
    throw Error({input.name(), {}, npy_magic.size() + 2},
                fmt::format("the header claims {} bytes", length), "write it with numpy.save");
  const std::size_t begin = npy_magic.size() + 2 + length_bytes;
  const std::string_view whole = at_least(begin + length);
  const NpyHeader header = Literal(whole.substr(begin, length), input.name()).header();
  input.skip(begin + length);
  return header;
}

std::string npy_header(const std::string& type, std::uint64_t rows, std::uint64_t columns) {
  constexpr std::size_t size = 256;
  std::string header = std::string(npy_magic) + '\1' + '\0' + static_cast<char>(size - 10) + '\0';
  header += fmt::format("{{'descr': {}, 'fortran_order': False, 'shape': ({},", type, rows);
  if (columns > 0) header += fmt::format(" {}", columns);
  header += "), }";
  header.resize(size - 1, ' ');
  return header + '\n';
}

}  // namespace penumbra
