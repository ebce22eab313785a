// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/read_points.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "penumbra/scene_io/npy_header.h"
#include "tests/scene_io/temporary_folder.h"
#include "tests/scene_io/text_source.h"

namespace penumbra {
namespace {

/// All points of a stream, in blocks of `block`.
PointBlock read_all(PointReader& reader, std::size_t block = 1000) {
  PointBlock all, part;
  while (reader.next(part, block)) {
    EXPECT_LE(part.positions.size(), block);
    all.positions.insert(all.positions.end(), part.positions.begin(), part.positions.end());
    all.normals.insert(all.normals.end(), part.normals.begin(), part.normals.end());
  }
  return all;
}

PointBlock points_of(const std::string& bytes, std::optional<PointFormat> format = {},
                     std::size_t block = 1000) {
  PointReader reader("t", bytes, format);
  return read_all(reader, block);
}

std::string error_for(const std::string& bytes, std::optional<PointFormat> format = {}) {
  return error_of([&] { points_of(bytes, format); });
}

template <typename Value>
std::string bytes_of(const std::vector<Value>& values, bool is_big = false) {
  std::string bytes;
  for (const Value value : values) {
    std::string one(sizeof value, '\0');
    std::memcpy(one.data(), &value, sizeof value);
    if (is_big) std::reverse(one.begin(), one.end());
    bytes += one;
  }
  return bytes;
}

void expect_two_points(const PointBlock& points) {
  ASSERT_EQ(points.positions.size(), 2u);
  EXPECT_EQ(points.positions[0], Vec3f(1, 2, 3));
  EXPECT_EQ(points.positions[1], Vec3f(-0.5f, 1e10f, 4));
  ASSERT_EQ(points.normals.size(), 2u);
  EXPECT_EQ(points.normals[0], Vec3f(0, 0, 1));
  EXPECT_EQ(points.normals[1], Vec3f(0, 2, 0));
}

TEST(ReadPoints, lines_of_text_with_any_separator) {
  expect_two_points(points_of("1,2,3,0,0,1\n-.5,1e10,4,0,2,0\n"));
  expect_two_points(points_of("1;2;3;0;0;1\n-.5; +1e10 ;4;0;2;0"));
  expect_two_points(points_of("1\t2\t3\t0\t0\t1\t\n-.5\t1e10\t4\t0\t2\t0\t\n"));
  expect_two_points(points_of("  1 2  3 0 0 1 \r\n\r\n-.5 1e10 4\t0 2 0\r\n"));
  expect_two_points(points_of("1 2 3 0 0 1\r-.5 1e10 4 0 2 0\r"));
  expect_two_points(
      points_of("\xEF\xBB\xBF# any \"comment\n\n1,2,3,0,0,1,\n#,,\n-.5,1e10,4,0,2,0\n"));
}

TEST(ReadPoints, names_in_any_order_and_case) {
  expect_two_points(
      points_of("z,name,NX,ny,nz,Y,X\n3,a,0,0,1,2,1\n4,\"b,\"\"c\"\"\",0,2,0,1e10,-.5\n"));
  expect_two_points(
      points_of("\"x\";\"y\";\"z\";\"normal_x\";\"normal_y\";\"normal_z\"\n"
                "1;2;3;0;0;1\n\"-.5\";1e10;4;0;2;0\n"));
  expect_two_points(
      points_of("x\ty\tnote\tz\tnx\tny\tnz\n1\t2\t\t3\t0\t0\t1\n-.5\t1e10\t,\t4\t0\t2\t0\n"));
  expect_two_points(points_of("# made by hand\n# nx ny nz x y z\n0 0 1 1 2 3\n0 2 0 -.5 1e10 4\n"));
}

TEST(ReadPoints, comments_are_free) {
  for (const char* comment :
       {"# x y z nx ny nz in metres", "#x y z of all of the grid", "# x y z nx", "# x y z x y z",
        "#,x,y,z", "# X, Y and z\tx y z", "# x y z nx ny nz nx ny nz", "# x,y,z"}) {
    SCOPED_TRACE(comment);
    const std::string start = std::string(comment) + "\n";
    expect_two_points(points_of(start + "1 2 3 0 0 1\n-.5 1e10 4 0 2 0\n"));
    expect_two_points(
        points_of(start + "x,y,z,nx,ny,nz\n" + start + "1,2,3,0,0,1\n-.5,1e10,4,0,2,0\n"));
    EXPECT_EQ(points_of(start + "0 0 1\n").positions, (std::vector<Vec3f>{{0, 0, 1}}));
  }
  EXPECT_EQ(points_of("#x y z of the grid\n0 0 1\n").positions, (std::vector<Vec3f>{{0, 0, 1}}));
  EXPECT_EQ(points_of("#" + std::string(998, ',') + "\n1 2 3\n").positions.size(), 1u);
  EXPECT_EQ(points_of("# note x y z\nx 1 2 3\n").positions, (std::vector<Vec3f>{{1, 2, 3}}));
  EXPECT_EQ(points_of("# z y x\n1,2,3\n").positions, (std::vector<Vec3f>{{3, 2, 1}}));
}

TEST(ReadPoints, without_normals) {
  for (const char* text :
       {"1 2 3\n4 5 6\n", "x,y,z\n1,2,3\n4,5,6\n", "z,x,y,id\n3,1,2,9\n6,4,5,8\n"}) {
    PointReader reader("t", text);
    EXPECT_FALSE(reader.has_normals());
    const PointBlock points = read_all(reader);
    EXPECT_EQ(points.positions, (std::vector<Vec3f>{{1, 2, 3}, {4, 5, 6}}));
    EXPECT_TRUE(points.normals.empty());
  }
}

TEST(ReadPoints, no_points_are_none) {
  for (const char* text : {"", "\n\n", "# x y z\n", "x,y,z\n"})
    EXPECT_TRUE(points_of(text).positions.empty()) << text;
}

TEST(ReadPoints, coordinates_need_not_be_finite) {
  const PointBlock points = points_of("nan inf 1e999\n-1e999 0 0\n");
  EXPECT_TRUE(std::isnan(points.positions.at(0).x));
  EXPECT_EQ(points.positions.at(0).z, std::numeric_limits<float>::infinity());
  EXPECT_EQ(points.positions.at(1).x, -std::numeric_limits<float>::infinity());
}

TEST(ReadPoints, wrong_lines_are_errors_with_their_number) {
  const auto check = [](const std::string& text, const std::string& place,
                        const std::string& what) {
    const std::string error = error_for(text);
    EXPECT_TRUE(error.starts_with("t:" + place + ": ")) << error;
    EXPECT_TRUE(holds(error, what)) << error;
  };
  check("\\\n1 2 3\n", "1", "0 columns without names");
  check("1 2\n", "1", "2 columns without names");
  check("#\n1 2 3 4\n", "2", "4 columns without names");
  check("1 2 3\n\n4 5\n", "3", "has 2 columns, but line 1 has 3");
  check("1 2 3\n4 5 6 7\n", "2", "has 4 columns");
  check("x,y,z,nx,ny,nz\n1,2,3,0,0\n", "2", "has 5 columns, but line 1 has 6");
  check("1,2,3\n1,x,3\n", "2", "expected a number for y, found `x`");
  check("1,2,3\n1,,3\n", "2", "found ``");
  check("0,5;1;2\n", "1", "`0,5`");
  check("x,y\n1,2\n", "1", "lack x, y or z");
  check("x,y,z,nx\n1,2,3,0\n", "1", "lack nx, ny or nz");
  check("x,y,z,X\n", "1", "two columns `X`");
  check("1,2,3\n\"1,2,3\n", "2", "quote");
  check("1 2 3\n" + std::string(100'000, '7') + " 2 3\n", "2", "longer than 64 KiB");
  check(std::string(100'000, ' '), "1", "longer than 64 KiB");
  check(std::string(5000, ','), "1", "1000 columns");
}

TEST(ReadPoints, numpy_arrays_of_any_float) {
  const std::vector<float> narrow{1, 2, 3, 0, 0, 1, -0.5f, 1e10f, 4, 0, 2, 0};
  const std::vector<double> wide(narrow.begin(), narrow.end());
  for (const bool is_big : {false, true}) {
    const std::string order = is_big ? "'>" : "'<";
    expect_two_points(points_of(npy_header(order + "f4'", 2, 6) + bytes_of(narrow, is_big)));
    expect_two_points(points_of(npy_header(order + "f8'", 2, 6) + bytes_of(wide, is_big)));
  }
  PointReader bare("t", npy_header("'<f4'", 4, 3) + bytes_of(narrow));
  EXPECT_FALSE(bare.has_normals());
  EXPECT_EQ(read_all(bare).positions.at(3), Vec3f(0, 2, 0));
  EXPECT_TRUE(points_of(npy_header("'<f4'", 0, 6)).positions.empty());
}

TEST(ReadPoints, numpy_headers_of_all_versions) {
  const std::string dictionary = "{\"shape\": (1L, 3L), 'descr': '<f4', 'fortran_order': True}\n";
  const auto size = static_cast<char>(dictionary.size());
  const std::string values = bytes_of<float>({1, 2, 3});
  for (const std::string& start :
       {std::string("\1\0", 2) + size + '\0', std::string("\2\0", 2) + size + std::string(3, '\0'),
        std::string("\3\0", 2) + size + std::string(3, '\0')}) {
    const PointBlock points = points_of("\x93NUMPY" + start + dictionary + values);
    EXPECT_EQ(points.positions, (std::vector<Vec3f>{{1, 2, 3}}));
  }
}

std::string with_dictionary(const std::string& dictionary) {
  std::string bytes = "\x93NUMPY\x01";
  bytes += '\0';
  bytes += static_cast<char>(dictionary.size());
  bytes += '\0';
  return bytes + dictionary;
}

TEST(ReadPoints, numpy_arrays_that_are_no_points_are_errors) {
  const auto check = [](const std::string& bytes, const std::string& what) {
    const std::string error = error_for(bytes);
    EXPECT_TRUE(error.starts_with("t: ")) << error;
    EXPECT_TRUE(holds(error, what)) << error;
  };
  const std::string values = bytes_of<float>({1, 2, 3, 4, 5, 6});
  check(npy_header("'<i8'", 2, 3) + values, "`<i8`");
  check(npy_header("'<f2'", 2, 3) + values, "astype(numpy.float32)");
  check(npy_header("'<f16'", 2, 3) + values, "`<f16`");
  check(npy_header("'|O'", 2, 3) + values, "`|O`");
  check(npy_header("[('x', '<f4')]", 2, 0) + values, "structured");
  check(npy_header("'<f4'", 2, 4) + values, "its shape is (2, 4)");
  check(npy_header("'<f4'", 6, 0) + values, "its shape is (6,)");
  check(with_dictionary("{'descr': '<f4', 'fortran_order': True, 'shape': (2, 3), }") + values,
        "Fortran");
  check(with_dictionary("{'descr': '<f4', 'fortran_order': True, 'shape': (2, 3"), "not NumPy's");
  check(with_dictionary("{'descr': '<f4', 'shape': (2, 3)}"), "not NumPy's");
  check(with_dictionary("{'descr': '<f4', 'odd': 3}"), "not NumPy's");
  check(npy_header("'<f4'", 1'000'000'000'000'000'000, 6) + values, "claims 1000000000000000000");
  check(npy_header("'<f8'", std::numeric_limits<std::int64_t>::max(), 6) + values, "claims");
  check(npy_header("'<f4'", std::numeric_limits<std::uint64_t>::max(), 6), "not NumPy's");
  check(npy_header("'<f4'", 3, 3) + values, "claims 3 points, but only 24 bytes follow");
  check("\x93NUMPY\x04" + std::string(10, '\0'), "version 4");
  check("\x93NUMPY\x02" + std::string(1, '\0') + "\xff\xff\xff\x7f", "claims 2147483647 bytes");
  check("\x93NUMPY\x01", "ends within its header");
}

std::string ply(const std::string& format, const std::string& rest) {
  return "ply\nformat " + format + " 1.0\n" + rest;
}

const std::string vertices =
    "element vertex 2\nproperty float nx\nproperty float ny\nproperty double nz\n"
    "property list uchar short skin\nproperty double x\nproperty float y\nproperty int z\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n";

TEST(ReadPoints, ply_in_text) {
  expect_two_points(
      points_of(ply("ascii", vertices + "0 0 1 2 7 7 1 2 3\n0 2 0\n0 -.5 1e10 4\n3 0 1 1\n")));
  expect_two_points(
      points_of(ply("ascii", "element first 2\nproperty float a\nproperty list uchar float b\n" +
                                 vertices + "7 2 1 1\n8 0\n0 0 1 0 1 2 3\r\n0 2 0 0 -.5 1e10 4")));
}

TEST(ReadPoints, ply_in_both_orders_of_bytes) {
  for (const bool is_big : {false, true}) {
    std::string bytes = ply(is_big ? "binary_big_endian" : "binary_little_endian", vertices);
    const auto row = [&](Vec3f n, std::vector<std::int16_t> skin, Vec3f p) {
      bytes += bytes_of<float>({n.x, n.y}, is_big) + bytes_of<double>({n.z}, is_big);
      bytes += static_cast<char>(skin.size()) + bytes_of(skin, is_big);
      bytes += bytes_of<double>({p.x}, is_big) + bytes_of<float>({p.y}, is_big) +
               bytes_of<std::int32_t>({static_cast<std::int32_t>(p.z)}, is_big);
    };
    row({0, 0, 1}, {}, {1, 2, 3});
    row({0, 2, 0}, {5, 6}, {-0.5f, 1e10f, 4});
    expect_two_points(points_of(bytes));
    const std::string cut = error_for(bytes.substr(0, bytes.size() - 1));
    EXPECT_TRUE(holds(cut, "byte ") && holds(cut, "ends within")) << cut;
  }
}

TEST(ReadPoints, ply_without_points_is_an_error) {
  const auto check = [](const std::string& bytes, const std::string& what) {
    const std::string error = error_for(bytes);
    EXPECT_TRUE(holds(error, what)) << error;
  };
  check(ply("ascii", "element face 0\nend_header\n"), "has no vertices");
  check(ply("ascii", "element vertex 1\nproperty float x\nend_header\n1\n"),
        "t:3: the points lack");
  check(ply("ascii", vertices + "0 0 1 0 1 2 3\n0 2 0 0 -.5 abc 4"), "t:15: expected a number");
  check(ply("ascii", vertices + "0.000 0 1 0 1 2 3\n0 2 0 0 -.5"), "ends within its values");
  check(ply("ascii", vertices + "0 0 1 -1 1 2 3\n0 0 1 0 1 2 3\n"), "a list claims -1");
  check(ply("binary_little_endian",
            "element vertex 9223372036854775807\nproperty float x\nproperty float y\n"
            "property float z\nend_header\n"),
        "t:3: the header claims 9223372036854775807 vertices");
  check(ply("ascii", "element vertex 1\n"), "no end_header");
}

TEST(ReadPoints, raw_numbers) {
  const std::vector<float> narrow{1, 2, 3, 0, 0, 1, -0.5f, 1e10f, 4, 0, 2, 0};
  const std::vector<double> wide(narrow.begin(), narrow.end());
  expect_two_points(points_of(bytes_of(narrow), PointFormat::float32));
  expect_two_points(points_of(bytes_of(wide), PointFormat::float64));
  EXPECT_TRUE(points_of("", PointFormat::float32).positions.empty());
  const std::string error = error_for(bytes_of(narrow) + "abc", PointFormat::float32);
  EXPECT_EQ(error,
            "t: byte 48: the input ends within a point; give six numbers a point: x y z nx ny nz");
}

TEST(ReadPoints, blocks_change_nothing) {
  std::string text = "x y z nx ny nz\n";
  for (int i = 0; i < 1000; ++i) text += std::to_string(i) + " 1 2 0 0 1\n";
  const PointBlock whole = points_of(text);
  for (const std::size_t block : {1, 7, 999, 1000}) {
    const PointBlock parts = points_of(text, {}, block);
    EXPECT_EQ(parts.positions, whole.positions);
    EXPECT_EQ(parts.normals, whole.normals);
  }
}

TEST(ReadPoints, of_files_say_how_far_they_are) {
  const TemporaryFolder folder;
  std::string text;
  for (int i = 0; i < 200'000; ++i) text += std::to_string(i) + " 1 2\n";
  PointReader reader(folder.put("p.csv", text));
  EXPECT_LT(reader.share().value(), 0.01);
  PointBlock block;
  std::size_t count = 0;
  while (reader.next(block, 100'000)) {
    count += block.positions.size();
    EXPECT_NEAR(reader.share().value(), static_cast<double>(count) / 200'000, 0.05);
  }
  EXPECT_EQ(count, 200'000u);
  EXPECT_EQ(block.positions.size(), 0u);
}

TEST(ReadPoints, of_ply_come_through_pipes_as_they_are_written) {
  for (const std::string line_end : {"\n", "\r\n"}) {
    int ends[2];
    ASSERT_EQ(pipe(ends), 0);
    const auto put = [&](const std::string& text) {
      EXPECT_EQ(write(ends[1], text.data(), text.size()), static_cast<ssize_t>(text.size()));
    };
    const std::string values = bytes_of<float>({1, 2, 3, 4, 5, 6});
    for (const char* line :
         {"ply", "format binary_little_endian 1.0", "comment end_header comes", "element vertex 2",
          "property float x", "property float y", "property float z", "end_header"})
      put(line + line_end);
    put(values.substr(0, 12));
    PointReader reader("/dev/fd/" + std::to_string(ends[0]));
    PointBlock block;
    ASSERT_TRUE(reader.next(block, 1));  // would wait forever, did it want more
    EXPECT_EQ(block.positions.at(0), Vec3f(1, 2, 3));
    put(values.substr(12));
    ASSERT_TRUE(reader.next(block, 1));
    EXPECT_EQ(block.positions.at(0), Vec3f(4, 5, 6));
    close(ends[1]);
    EXPECT_FALSE(reader.next(block, 1));
    close(ends[0]);
  }
}

TEST(ReadPoints, come_through_pipes_as_they_are_written) {
  const TemporaryFolder folder;
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  const auto put = [&](const std::string& text) {
    EXPECT_EQ(write(ends[1], text.data(), text.size()), static_cast<ssize_t>(text.size()));
  };
  put("1 2 3\n");
  PointReader reader("/dev/fd/" + std::to_string(ends[0]));
  EXPECT_FALSE(reader.share());
  PointBlock block;
  ASSERT_TRUE(reader.next(block, 1));  // would wait forever, did it want more
  put("4 5 6\n");
  ASSERT_TRUE(reader.next(block, 1));
  EXPECT_EQ(block.positions.at(0), Vec3f(4, 5, 6));
  close(ends[1]);
  EXPECT_FALSE(reader.next(block, 1));
  close(ends[0]);
}

}  // namespace
}  // namespace penumbra
