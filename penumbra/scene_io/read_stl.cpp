// SPDX-License-Identifier: MIT
// STL, text and binary. Which of them a file is, its size says: many binary files begin with the
// word that marks text. Stored facet normals are not read: the corners have them.
#include <bit>
#include <cmath>
#include <cstring>
#include <optional>

#include "penumbra/scene_io/faces.h"
#include "penumbra/scene_io/numbers.h"
#include "penumbra/scene_io/source.h"
#include "penumbra/scene_io/tokens.h"
#include "penumbra/scene_io/weld.h"

namespace penumbra {
namespace {

constexpr std::size_t head = 84;   ///< 80 bytes of any content and the number of triangles
constexpr std::size_t facet = 50;  ///< normal, three corners, two bytes more

std::uint32_t little_endian(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 4; i-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
  return value;
}

bool begins_with_solid(std::string_view bytes) {
  const Token first = Tokens({}, bytes.substr(0, 256), Comments::none).next();
  return first.text == "solid" || first.text == "SOLID" || first.text == "Solid";
}

enum class Kind { text, binary };

Kind kind_of(std::string_view bytes) {
  if (bytes.size() >= head && bytes.size() == head + facet * std::size_t{little_endian(bytes, 80)})
    return Kind::binary;
  const bool has_zero = bytes.substr(0, 512).find('\0') != std::string_view::npos;
  return begins_with_solid(bytes) && !has_zero ? Kind::text : Kind::binary;
}

std::string lower(std::string_view text) {
  std::string out(text);
  for (char& c : out)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return out;
}

void add_triangle(Mesh& mesh, const Vec3f (&corners)[3]) {
  const auto base = static_cast<std::uint32_t>(mesh.positions.size());
  // -0 becomes 0: equal positions are to be one.
  for (const Vec3f c : corners) mesh.positions.push_back({c.x + 0.0f, c.y + 0.0f, c.z + 0.0f});
  mesh.triangles.push_back({base, base + 1, base + 2});
}

void expect(Tokens& tokens, std::string_view word) {
  const Token token = tokens.next();
  if (lower(token.text) != word) tokens.fail(token, "`" + std::string(word) + "`");
}

void read_text_facet(Tokens& tokens, Mesh& mesh) {
  expect(tokens, "normal");
  // Often "nan nan nan" for a degenerate facet; not needed.
  for (int i = 0; i < 3; ++i) {
    const Token token = tokens.next();
    if (!parse_float(token.text)) tokens.fail(token, "a normal's coordinate");
  }
  expect(tokens, "outer");
  expect(tokens, "loop");
  Vec3f corners[3];
  for (Vec3f& corner : corners) {
    expect(tokens, "vertex");
    for (int axis = 0; axis < 3; ++axis) corner[axis] = tokens.number("a coordinate");
  }
  expect(tokens, "endloop");
  expect(tokens, "endfacet");
  add_triangle(mesh, corners);
}

Mesh read_text(const Source& source) {
  Tokens tokens(source.path.string(), source.bytes, Comments::none);
  Mesh mesh;
  for (Token word = tokens.next(); !word.text.empty(); word = tokens.next()) {
    const std::string keyword = lower(word.text);
    if (keyword == "facet") {
      check_vertex_count(tokens.place(word), mesh.positions.size() + 3);
      read_text_facet(tokens, mesh);
    } else if (keyword == "solid" || keyword == "endsolid") {
      tokens.skip_line();  // its name
    } else if (keyword != "color") {
      tokens.fail(word, "`facet` or `endsolid`");
    } else {
      tokens.skip_line();
    }
  }
  return mesh;
}

Mesh read_binary(const Source& source, Warnings& warnings) {
  const std::string_view bytes = source.bytes;
  const std::string file = source.path.string();
  if (bytes.size() < head)
    throw Error({file, {}, bytes.size()}, "the file ends within the head of an STL",
                "it may be cut off, or be something else");
  const std::uint32_t count = little_endian(bytes, 80);
  const std::size_t follow = bytes.size() - head;
  if (count > follow / facet)
    throw Error({file, {}, 80},
                "the file claims " + std::to_string(count) + " triangles of 50 bytes, but " +
                    std::to_string(follow) + " bytes follow",
                "it may be cut off, or be something else");
  if (follow != count * facet) warnings.add("bytes after the last triangle are left out");
  check_vertex_count({file, {}, 80}, std::size_t{count} * 3);
  Mesh mesh;
  mesh.positions.reserve(std::size_t{count} * 3);
  mesh.triangles.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t at = head + i * facet + 12;
    Vec3f corners[3];
    for (std::size_t k = 0; k < 9; ++k) {
      const float value = std::bit_cast<float>(little_endian(bytes, at + 4 * k));
      if (!std::isfinite(value))
        throw Error({file, {}, at + 4 * k},
                    "a coordinate of triangle " + std::to_string(i) + " is not finite",
                    "mend or remove the triangle");
      corners[k / 3][static_cast<int>(k % 3)] = value;
    }
    add_triangle(mesh, corners);
  }
  return mesh;
}

}  // namespace

Scene read_stl(const Source& source, Warnings& warnings) {
  Mesh mesh =
      kind_of(source.bytes) == Kind::text ? read_text(source) : read_binary(source, warnings);
  if (mesh.triangles.empty())
    throw Error({source.path.string(), {}, {}}, "has no triangle", "check what the file is");
  weld(mesh);
  Scene scene;
  scene.wants_ground = true;
  scene.shapes.meshes.push_back(std::move(mesh));
  return scene;
}

}  // namespace penumbra
