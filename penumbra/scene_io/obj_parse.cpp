// SPDX-License-Identifier: MIT
// Read here rather than by tinyobjloader, which in silence takes nan and missing numbers for 0 and
// skips keywords it does not know.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "penumbra/scene/image.h"
#include "penumbra/scene_io/numbers.h"
#include "penumbra/scene_io/obj_data.h"
#include "penumbra/scene_io/text_lines.h"

namespace penumbra {

namespace {

/// Statements of the format that draw no surface, or nothing that we draw.
constexpr std::array<std::string_view, 5> silent{"g", "o", "mg", "lod", "shadow_obj"};
constexpr std::array<std::string_view, 29> unread{
    "p",     "l",      "vp",     "deg",   "bmat",     "step",     "cstype",    "curv",
    "curv2", "surf",   "parm",   "trim",  "hole",     "scrv",     "sp",        "end",
    "con",   "call",   "csh",    "bevel", "c_interp", "d_interp", "trace_obj", "ctech",
    "stech", "usemap", "maplib", "bsp",   "bzp"};

template <typename Words>
bool holds(const Words& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

struct Reader {
  const std::string file;
  Warnings& warnings;
  ObjData data;
  std::map<std::string, std::uint32_t, std::less<>> material_numbers{{"", 0}};
  std::uint32_t material = 0;
  bool is_smooth = false;
  std::size_t line = 0;

  [[noreturn]] void fail(std::string what, std::string hint) const {
    throw Error({file, line, {}}, std::move(what), std::move(hint));
  }
};

float number(const Reader& reader, std::string_view word) {
  const auto value = parse_float(word);
  if (word.empty()) reader.fail("the line ends before its numbers do", "was the file cut off?");
  if (!value) reader.fail(fmt::format("{} is not a number", in_quotes(word)), "mend the line");
  return *value;
}

float finite(const Reader& reader, std::string_view word) {
  const float value = number(reader, word);
  if (!std::isfinite(value))
    reader.fail(fmt::format("{} is not a finite number", in_quotes(word)), "mend the line");
  return value;
}

void read_position(Reader& reader, std::string_view rest) {
  ObjData& data = reader.data;
  std::array<float, 7> values{};
  std::size_t count = 0;
  for (auto word = next_word(rest); !word.empty(); word = next_word(rest)) {
    if (count == values.size()) reader.fail("a vertex with more than 7 numbers", "mend the line");
    values[count++] = finite(reader, word);
  }
  if (count < 3) number(reader, {});
  // x y z [w] or x y z [w] r g b; the weight w counts for free-form curves only.
  const bool has_color = count >= 6;
  if (has_color && data.colors.empty()) data.colors.resize(data.positions.size(), {1, 1, 1});
  data.positions.emplace_back(values[0], values[1], values[2]);
  if (data.colors.empty() && !has_color) return;
  const auto code = [&](std::size_t i) {
    return linear_from_srgb(std::clamp(values[count - 3 + i], 0.0f, 1.0f));
  };
  data.colors.push_back(has_color ? Color{code(0), code(1), code(2)} : Color{1, 1, 1});
}

void read_normal(Reader& reader, std::string_view rest) {
  const float x = number(reader, next_word(rest)), y = number(reader, next_word(rest)),
              z = number(reader, next_word(rest));
  Vec3f normal{x, y, z};
  if (!is_finite(normal)) {
    reader.warnings.add("a normal that is not finite; the faces' own is taken", reader.line);
    normal = {};
  }
  reader.data.normals.push_back(normal);
}

void read_uv(Reader& reader, std::string_view rest) {
  const float u = finite(reader, next_word(rest));
  const std::string_view second = next_word(rest);
  reader.data.uvs.push_back({u, second.empty() ? 0.0f : finite(reader, second)});
}

/// One index of a corner: positive from 1, negative back from the list's present end.
std::int64_t index(const Reader& reader, std::string_view word, std::size_t size) {
  const auto value = parse_integer(word);
  if (!value || *value == 0)
    reader.fail(fmt::format("{} is not an index", in_quotes(word)),
                "indices count from 1, or back from -1");
  if (*value > 0) return *value - 1;
  const auto count = static_cast<std::int64_t>(size);
  if (*value < -count)
    reader.fail(fmt::format("a face reaches back to {}, but only {} are there", *value, count),
                "mend the index");
  return count + *value;
}

ObjCorner corner(const Reader& reader, std::string_view word) {
  const std::size_t slash = word.find('/');
  ObjCorner c;
  c.position = index(reader, word.substr(0, slash), reader.data.positions.size());
  if (slash == std::string_view::npos) return c;
  std::string_view rest = word.substr(slash + 1);
  const std::size_t second = rest.find('/');
  const std::string_view uv = rest.substr(0, second);
  if (!uv.empty()) c.uv = index(reader, uv, reader.data.uvs.size());
  if (second == std::string_view::npos) return c;
  const std::string_view normal = rest.substr(second + 1);
  if (!normal.empty()) c.normal = index(reader, normal, reader.data.normals.size());
  return c;
}

void read_face(Reader& reader, std::string_view rest) {
  ObjData& data = reader.data;
  ObjFace face{data.corners.size(), reader.line, 0, reader.material, reader.is_smooth};
  for (auto word = next_word(rest); !word.empty(); word = next_word(rest))
    data.corners.push_back(corner(reader, word));
  const std::size_t count = data.corners.size() - face.first_corner;
  if (count < 3) reader.fail("a face with fewer than 3 corners", "was the file cut off?");
  if (count > 10'000) reader.fail("a face with more than 10,000 corners", "split it");
  face.corner_count = static_cast<std::uint32_t>(count);
  data.faces.push_back(face);
}

void use_material(Reader& reader, std::string_view name) {
  const auto known = reader.material_numbers.find(name);
  if (known != reader.material_numbers.end()) {
    reader.material = known->second;
    return;
  }
  ObjData& data = reader.data;
  reader.material = static_cast<std::uint32_t>(data.material_names.size());
  data.material_names.emplace_back(name);
  data.first_use.emplace(name, reader.line);
  reader.material_numbers.emplace(name, reader.material);
}

void read_statement(Reader& reader, std::string_view keyword, std::string_view rest) {
  if (keyword == "v") return read_position(reader, rest);
  if (keyword == "f" || keyword == "fo") return read_face(reader, rest);
  if (keyword == "vn") return read_normal(reader, rest);
  if (keyword == "vt") return read_uv(reader, rest);
  if (keyword == "usemtl") return use_material(reader, trimmed(rest));
  if (keyword == "mtllib") {
    reader.data.libraries.push_back({std::string(trimmed(rest)), reader.line});
  } else if (keyword == "s") {
    const std::string_view group = next_word(rest);
    reader.is_smooth = group != "off" && group != "0" && !group.empty();
  } else if (holds(unread, keyword)) {
    reader.warnings.add("points, lines and free-form surfaces are not drawn", reader.line);
  } else if (!holds(silent, keyword)) {
    reader.fail(fmt::format("unknown keyword {}", in_quotes(keyword)), "is this an OBJ file?");
  }
}

}  // namespace

ObjData parse_obj(const Source& source, Warnings& warnings) {
  Reader reader{source.path.string(), warnings, {}};
  TextLines lines(source.bytes, LineJoints::backslash);
  while (auto line = lines.next()) {
    reader.line = lines.number();
    std::string_view rest = *line;
    if (const std::string_view keyword = next_word(rest); !keyword.empty())
      read_statement(reader, keyword, rest);
  }
  return std::move(reader.data);
}

}  // namespace penumbra
