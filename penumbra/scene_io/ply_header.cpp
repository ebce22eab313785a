// SPDX-License-Identifier: MIT
#include <algorithm>

#include "penumbra/scene_io/light_spec.h"
#include "penumbra/scene_io/numbers.h"
#include "penumbra/scene_io/ply.h"

namespace penumbra {
namespace {

struct TypeName {
  std::string_view name;
  PlyType type;
};

constexpr TypeName type_names[] = {
    {"char", PlyType::int8},      {"int8", PlyType::int8},       {"uchar", PlyType::uint8},
    {"uint8", PlyType::uint8},    {"short", PlyType::int16},     {"int16", PlyType::int16},
    {"ushort", PlyType::uint16},  {"uint16", PlyType::uint16},   {"int", PlyType::int32},
    {"int32", PlyType::int32},    {"uint", PlyType::uint32},     {"uint32", PlyType::uint32},
    {"float", PlyType::float32},  {"float32", PlyType::float32}, {"double", PlyType::float64},
    {"float64", PlyType::float64}};

/// One line of the header, cut into words.
struct Line {
  std::vector<std::string> words;
  Error::Place place;
};

class HeaderReader {
 public:
  explicit HeaderReader(const Source& source) : source_(source) {
    const std::string_view bytes = source.bytes;
    if (bytes.starts_with("\xEF\xBB\xBF")) at_ = 3;
    // Old Mac files end their lines with \r alone; elsewhere a \r may be the first byte of data.
    const std::size_t end = bytes.find_first_of("\r\n", at_);
    const bool is_mac = end != std::string_view::npos && bytes[end] == '\r' &&
                        (end + 1 == bytes.size() || bytes[end + 1] != '\n');
    newline_ = is_mac ? '\r' : '\n';
  }

  Line next() {
    ++line_;
    if (at_ >= source_.bytes.size())
      throw Error(place(), "the header has no end_header", "the file may be cut off");
    const std::string_view bytes = source_.bytes;
    const std::size_t end = std::min(bytes.find(newline_, at_), bytes.size());
    Line line{split_words(bytes.substr(at_, end - at_)), place()};
    at_ = std::min(end + 1, bytes.size());
    return line;
  }

  std::size_t at() const { return at_; }
  std::size_t line() const { return line_; }

 private:
  Error::Place place() const { return {source_.path.string(), line_, {}}; }

  const Source& source_;
  std::size_t at_ = 0, line_ = 0;
  char newline_ = '\n';
};

PlyType type_named(const Line& line, const std::string& name) {
  for (const TypeName& entry : type_names)
    if (entry.name == name) return entry.type;
  throw Error(line.place, "unknown type " + in_quotes(name), "PLY knows char to double");
}

PlyFormat format_of(const Line& line) {
  if (line.words.size() >= 2) {
    if (line.words[1] == "ascii") return PlyFormat::ascii;
    if (line.words[1] == "binary_little_endian") return PlyFormat::binary_little_endian;
    if (line.words[1] == "binary_big_endian") return PlyFormat::binary_big_endian;
  }
  throw Error(line.place, "the format is not known",
              "PLY knows ascii, binary_little_endian and binary_big_endian");
}

PlyElement element_of(const Line& line) {
  const auto count = line.words.size() == 3 ? parse_integer(line.words[2]) : std::nullopt;
  if (!count || *count < 0)
    throw Error(line.place, "an element needs a name and a count", "write `element vertex 8`");
  return {line.words[1], static_cast<std::uint64_t>(*count), {}, *line.place.line};
}

PlyProperty property_of(const Line& line) {
  const std::vector<std::string>& words = line.words;
  PlyProperty property;
  if (words.size() == 3) {
    property.type = type_named(line, words[1]);
    property.name = words[2];
    return property;
  }
  if (words.size() != 5 || words[1] != "list")
    throw Error(line.place, "a property needs a type and a name",
                "write `property float x` or `property list uchar int vertex_indices`");
  property.count_type = type_named(line, words[2]);
  property.type = type_named(line, words[3]);
  property.name = words[4];
  if (!is_integer(*property.count_type))
    throw Error(line.place, "a list's length has the type " + in_quotes(words[2]),
                "use an integer type");
  return property;
}

}  // namespace

std::size_t size_in_bytes(PlyType type) {
  switch (type) {
    case PlyType::int8:
    case PlyType::uint8: return 1;
    case PlyType::int16:
    case PlyType::uint16: return 2;
    case PlyType::int32:
    case PlyType::uint32:
    case PlyType::float32: return 4;
    case PlyType::float64: break;
  }
  return 8;
}

bool is_integer(PlyType type) { return type != PlyType::float32 && type != PlyType::float64; }

namespace {

/// `comment up x y z`, as `write_scene` leaves it; a comment that is none of these is free text.
void read_up(const Line& line, PlyHeader& header) {
  if (line.words.size() != 5 || line.words[1] != "up") return;
  Vec3d up;
  for (int axis = 0; axis < 3; ++axis) {
    const auto value = parse_double(line.words[static_cast<std::size_t>(axis) + 2]);
    if (!value) return;
    up[axis] = *value;
  }
  if (is_finite(up) && max_abs(up) > 0) header.up = normalize(up);
}

}  // namespace

PlyHeader read_ply_header(const Source& source) {
  HeaderReader reader(source);
  PlyHeader header;
  const Line magic = reader.next();
  if (magic.words != std::vector<std::string>{"ply"})
    throw Error(magic.place, "a PLY file begins with a line `ply`", "check what the file is");
  bool has_format = false;
  for (;;) {
    const Line line = reader.next();
    const std::string word = line.words.empty() ? "comment" : line.words[0];
    if (word == "comment") read_up(line, header);
    if (word == "comment" || word == "obj_info") continue;
    if (word == "end_header") break;
    if (word == "format") {
      header.format = format_of(line);
      has_format = true;
    } else if (word == "element") {
      header.elements.push_back(element_of(line));
    } else if (word == "property") {
      if (header.elements.empty())
        throw Error(line.place, "a property comes before any element", "give the element first");
      header.elements.back().properties.push_back(property_of(line));
    } else {
      throw Error(line.place, "unknown word " + in_quotes(word) + " in a PLY header",
                  "check whether the header ends with end_header");
    }
  }
  header.size = reader.at();
  header.lines = reader.line();
  if (!has_format)
    throw Error({source.path.string(), header.lines, {}}, "the header names no format",
                "write `format ascii 1.0`");
  return header;
}

}  // namespace penumbra
