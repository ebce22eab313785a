// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cstring>
#include <limits>

#include "tests/scene_io/text_source.h"

namespace penumbra {
namespace {

Mesh read(const std::string& bytes) {
  const Source source = source_of("t.stl", bytes);
  Warnings warnings("t.stl");
  return read_stl(source, warnings).shapes.meshes.at(0);
}

std::string error_for(const std::string& bytes) {
  return error_of([&] { read(bytes); });
}

const std::string facet =
    "facet normal nan nan nan\n outer loop\n vertex 0 0 0\n vertex 1 0 -0\n vertex 0 1e0 0\n"
    "endloop\n endfacet\n";

/// Two triangles that share an edge.
std::string binary(const std::string& head, std::uint32_t claimed = 2) {
  std::string bytes = head;
  bytes.resize(80, ' ');
  bytes.append(reinterpret_cast<const char*>(&claimed), 4);
  const float corners[2][9] = {{0, 0, 0, 1, 0, 0, 0, 1, 0}, {1, 0, -0.0f, 1, 1, 0, 0, 1, 0}};
  for (const auto& triangle : corners) {
    bytes.append(12, '\0');
    bytes.append(reinterpret_cast<const char*>(triangle), sizeof triangle);
    bytes.append(2, '\0');
  }
  return bytes;
}

TEST(ReadStl, text_with_several_solids_and_any_case) {
  const Mesh mesh = read("solid a facet b\n" + facet + "endsolid a\nSOLID\n" +
                         "FACET NORMAL 0 0 1 OUTER LOOP VERTEX 0 0 0 VERTEX 1 0 0 VERTEX 0 1 0 "
                         "ENDLOOP ENDFACET\nendsolid\n");
  EXPECT_EQ(mesh.triangles.size(), 2u);
  EXPECT_EQ(mesh.positions.size(), 3u);
}

TEST(ReadStl, binary_by_size_even_when_it_begins_with_solid) {
  for (const char* head : {"", "solid thing made by CAD", "COLOR=abcd"}) {
    const Mesh mesh = read(binary(head));
    EXPECT_EQ(mesh.triangles.size(), 2u);
    EXPECT_EQ(mesh.positions.size(), 4u);
  }
}

TEST(ReadStl, bytes_after_the_last_triangle_are_warned_of) {
  const Source source = source_of("t.stl", binary("x") + "more");
  Warnings warnings("t.stl");
  EXPECT_EQ(read_stl(source, warnings).shapes.meshes.at(0).triangles.size(), 2u);
  EXPECT_EQ(warnings.lines().size(), 1u);
}

TEST(ReadStl, errors_name_line_or_byte) {
  const auto check = [](const std::string& bytes, const std::string& place,
                        const std::string& what) {
    const std::string error = error_for(bytes);
    EXPECT_TRUE(error.starts_with("t.stl:" + place)) << error;
    EXPECT_TRUE(holds(error, what)) << error;
  };
  check("", " byte 0", "head");
  check("garbage", " byte 7", "head");
  check(binary("x", 1u << 31), " byte 80", "claims 2147483648");
  check(binary("x").substr(0, 150), " byte 80", "66 bytes follow");
  check("solid\nendsolid\n", " ", "no triangle");
  check("solid\n" + facet.substr(0, 60), "5", "found the end");
  check("solid\nfacet normal 0 0 x", "2", "`x`");
  check("solid\nfacet normal 0 0 1 outer loop\nvertex 0 inf 0", "3", "no finite number");
  check("solid\nnonsense", "2", "`nonsense`");
  std::string bytes = binary("x");
  const float infinite = std::numeric_limits<float>::infinity();
  std::memcpy(bytes.data() + 84 + 50 + 12 + 8, &infinite, 4);
  check(bytes, " byte 154", "triangle 1");
}

}  // namespace
}  // namespace penumbra
