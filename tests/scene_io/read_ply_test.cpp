// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "penumbra/scene/image.h"
#include "tests/scene_io/text_source.h"

namespace penumbra {
namespace {

Scene read(const std::string& bytes) {
  const Source source = source_of("t.ply", bytes);
  Warnings warnings("t.ply");
  return read_ply(source, warnings);
}

Mesh mesh_of(const std::string& bytes) { return read(bytes).shapes.meshes.at(0); }

std::string error_for(const std::string& bytes) {
  return error_of([&] { read(bytes); });
}

const std::string vertices =
    "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n";
const std::string faces = "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
const std::string square = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

std::string ascii(const std::string& rest) { return "ply\nformat ascii 1.0\n" + rest; }

template <typename Value>
std::string bytes_of(Value value, bool is_big) {
  std::string bytes(sizeof value, '\0');
  std::memcpy(bytes.data(), &value, sizeof value);
  if (is_big) std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

TEST(ReadPly, ascii_with_extra_properties_and_elements) {
  const Mesh mesh = mesh_of(ascii(
      "comment made by hand\nobj_info num 5\nelement camera 1\nproperty list int float k\n"
      "element vertex 4\nproperty double z\nproperty float confidence\nproperty int x\n"
      "property list uchar float skin\nproperty uchar y\nelement face 1\nproperty uchar flags\n"
      "property list uchar uint vertex_index\nproperty list uchar float texcoord\nend_header\n"
      "2 0.5 0.25\n0 .9 0 1 7 0\n0 .9 1 0 0\n0.5 .9 1 2 7 7 1\n0 .9 0 0 1\n"
      "9 4 0 1 2 3 2 .1 .2\n"));
  ASSERT_EQ(mesh.positions.size(), 4u);
  EXPECT_EQ(mesh.positions[2], Vec3f(1, 1, 0.5f));
  EXPECT_EQ(mesh.triangles.size(), 2u);
}

TEST(ReadPly, all_line_ends) {
  const std::string text = ascii(vertices + faces + square + "4 0 1 2 3\n");
  for (const std::string newline : {"\r\n", "\r"}) {
    std::string other;
    for (const char c : text) other += c == '\n' ? newline : std::string(1, c);
    EXPECT_EQ(mesh_of(other).triangles.size(), 2u);
  }
}

TEST(ReadPly, binary_of_both_orders) {
  for (const bool is_big : {false, true}) {
    std::string bytes = std::string("ply\nformat binary_") + (is_big ? "big" : "little") +
                        "_endian 1.0\nelement vertex 3\nproperty short x\nproperty double y\n"
                        "property float z\nproperty list uchar short extra\nelement face 1\n"
                        "property list ushort ushort vertex_indices\nend_header\n";
    for (int i = 0; i < 3; ++i)
      bytes += bytes_of(static_cast<std::int16_t>(-i), is_big) + bytes_of(0.5 * i * i, is_big) +
               bytes_of(1.5f, is_big) + "\x01" + bytes_of(std::int16_t{7}, is_big);
    bytes += bytes_of(std::uint16_t{3}, is_big);
    for (const std::uint16_t i : {0, 1, 2}) bytes += bytes_of(i, is_big);
    const Mesh mesh = mesh_of(bytes);
    EXPECT_EQ(mesh.positions[2], Vec3f(-2, 2, 1.5f));
    EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}}));
    const std::string cut = error_for(bytes.substr(0, bytes.size() - 1));
    EXPECT_TRUE(holds(cut, "byte ")) << cut;
  }
}

TEST(ReadPly, normals_colours_and_texture_coordinates) {
  const Scene scene = read(ascii(
      "element vertex 3\nproperty float x\nproperty float y\nproperty float z\nproperty float nx\n"
      "property float ny\nproperty float nz\nproperty uchar red\nproperty uchar green\n"
      "property uchar blue\nproperty uchar alpha\nproperty float s\nproperty float t\n" +
      faces +
      "0 0 0 0 0 1 255 128 0 9 0 1\n1 0 0 0 0 1 255 128 0 9 .5 1\n"
      "0 1 0 nan nan nan 255 300 -4 9 0 .25\n3 0 1 2\n"));
  const Mesh& mesh = scene.shapes.meshes.at(0);
  EXPECT_EQ(mesh.normals.at(0), Vec3f(0, 0, 1));
  EXPECT_EQ(mesh.colors.at(0), Color(1, linear_from_srgb(128 / 255.0f), 0));
  EXPECT_EQ(mesh.colors.at(2), Color(1, 1, 0));
  EXPECT_EQ(mesh.uvs.at(1).u, 0.5f);
  EXPECT_EQ(scene.materials.at(0).diffuse, Color(1, 1, 1));
  const Mesh linear = mesh_of(ascii(
      "element vertex 3\nproperty float x\nproperty float y\nproperty float z\nproperty float r\n"
      "property float g\nproperty float b\n" +
      faces + "0 0 0 .25 2 nan\n1 0 0 0 0 0\n0 1 0 0 0 0\n3 0 1 2\n"));
  EXPECT_EQ(linear.colors.at(0), Color(0.25f, 2, 0));
}

TEST(ReadPly, strips_restart_and_alternate) {
  const Mesh mesh =
      mesh_of(ascii("element vertex 6\nproperty float x\nproperty float y\nproperty float z\n"
                    "element tristrips 1\nproperty list int int vertex_indices\nend_header\n"
                    "0 0 0 1 0 0 0 1 0 1 1 0 0 2 0 1 2 0\n10 0 1 2 3 -1 2 3 4 4 5\n"));
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {2, 1, 3}, {2, 3, 4}}));
}

TEST(ReadPly, faces_may_come_first) {
  const Mesh mesh = mesh_of(ascii("element face 1\nproperty list uchar int vertex_indices\n" +
                                  vertices + "end_header\n4 0 1 2 3\n" + square));
  EXPECT_EQ(mesh.triangles.size(), 2u);
}

TEST(ReadPly, errors_name_line_or_byte) {
  const auto check = [](const std::string& text, const std::string& place,
                        const std::string& what) {
    const std::string error = error_for(text);
    EXPECT_TRUE(error.starts_with("t.ply:" + place)) << error;
    EXPECT_TRUE(holds(error, what)) << error;
  };
  const std::string head = ascii(vertices + faces);
  check("play\n", "1", "begins with");
  check("ply\n", "2", "no end_header");
  check("ply\nformat ascii7 1.0\n", "2", "format is not known");
  check(ascii("property float x\n"), "3", "before any element");
  check(ascii("element vertex -1\n"), "3", "a count");
  check(ascii("element vertex 4\nproperty quad x\n"), "4", "`quad`");
  check(ascii("element vertex 4\nproperty list float int x\n"), "4", "length");
  check(ascii("element vertex 1\nproperty float x\nend_header\n1\n"), "3", "lack x, y or z");
  check(ascii("elephant\n"), "3", "`elephant`");
  check(head + "0 0 0\n1 0 x\n1 1 0\n0 1 0\n4 0 1 2 3\n", "11", "`x`");
  check(head + "0 0 0\n1 0 inf\n1 1 0\n0 1 0\n4 0 1 2 3\n", "11", "vertex 1 is not finite");
  check(head + square + "4 0 1 2 4\n", "14", "vertex 4");
  check(head + square + "4 0 1 2 -1\n", "14", "vertex -1");
  check(head + square + "4 0 1 2\n", "15", "found the end");
  check(head + square + "4 0 1 2 2.5\n", "14", "2.5");
  check(head + square + "2000000000 0 1 2 3\n", "14", "claims 2000000000");
  check(head + square + "-3 0 1 2 3\n", "14", "claims -3");
  check(ascii("element vertex 4000000000000\nproperty float x\nproperty float y\nproperty float z\n"
              "end_header\n0 0 0\n"),
        "3", "claims 4000000000000 rows");
  check(
      "ply\nformat binary_little_endian 1.0\nelement vertex 9223372036854775807\n"
      "property float x\nproperty float y\nproperty float z\nend_header\n",
      "3", "claims 9223372036854775807 rows");
  check(ascii(vertices + "end_header\n" + square), " ", "4 points, but no face");
  check(ascii(vertices + "element face 1\nproperty uchar k\nend_header\n" + square + "1"), "7",
        "no list of vertices");
}

TEST(ReadPly, rows_without_properties_cost_nothing) {
  EXPECT_EQ(mesh_of(ascii("element nothing 9000000000000000000\n" + vertices + faces + square +
                          "4 0 1 2 3\n"))
                .triangles.size(),
            2u);
}

TEST(ReadPly, small_faces_are_left_out_with_one_warning) {
  const Source source = source_of(
      "t.ply",
      ascii(vertices + "element face 3\nproperty list uchar int vertex_indices\nend_header\n" +
            square + "2 0 1\n3 0 1 2\n0\n"));
  Warnings warnings("t.ply");
  EXPECT_EQ(read_ply(source, warnings).shapes.meshes.at(0).triangles.size(), 1u);
  ASSERT_EQ(warnings.lines().size(), 1u);
  EXPECT_TRUE(holds(warnings.lines()[0], "t.ply:14: "));
}

}  // namespace
}  // namespace penumbra
