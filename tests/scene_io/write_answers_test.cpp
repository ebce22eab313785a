// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/write_answers.h"

#include <gtest/gtest.h>

#include <cstring>

#include "penumbra/scene_io/ply.h"
#include "penumbra/scene_io/source.h"
#include "tests/scene_io/temporary_folder.h"
#include "tests/scene_io/text_source.h"

namespace penumbra {
namespace {

const PointBlock two_points{{{1, 2, 3}, {0.1f, -1e10f, 0}}, {{0, 0, 1}, {0, 1, 0}}};
const std::vector<std::uint8_t> classes{0, 1, 2, 1};  // of two lights
const std::vector<float> fractions{1, 0.25f, 0, 0.5f};

AnswerLayout layout(AnswerFormat format, bool has_classes, bool has_fractions) {
  return {format, has_classes, has_fractions, 2, true, {"lit", "penumbra", "umbra"}};
}

/// What a file holds after two blocks of two points.
std::string written(const AnswerLayout& layout) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "out";
  AnswerWriter writer(path, layout);
  for (int i = 0; i < 2; ++i) writer.write(two_points, {classes, fractions});
  EXPECT_FALSE(std::filesystem::exists(path));
  writer.finish();
  return load(path).bytes;
}

template <typename Value>
std::vector<Value> values_of(const std::string& bytes) {
  std::vector<Value> values(bytes.size() / sizeof(Value));
  std::memcpy(values.data(), bytes.data(), values.size() * sizeof(Value));
  return values;
}

template <typename Value>
std::vector<Value> twice(std::vector<Value> values) {
  values.insert(values.end(), values.begin(),
                values.begin() + static_cast<std::ptrdiff_t>(values.size()));
  return values;
}

TEST(WriteAnswers, csv_names_its_columns_and_repeats_the_points) {
  const std::string rows =
      "1,2,3,0,0,1,lit,1,penumbra,0.25\n0.1,-1e+10,0,0,1,0,umbra,0,penumbra,0.5\n";
  EXPECT_EQ(written(layout(AnswerFormat::csv, true, true)),
            "x,y,z,nx,ny,nz,class_light0,visibility_light0,class_light1,visibility_light1\n" +
                rows + rows);
  AnswerLayout bare = layout(AnswerFormat::csv, false, true);
  bare.has_normals = false;
  EXPECT_TRUE(written(bare).starts_with(
      "x,y,z,visibility_light0,visibility_light1\n1,2,3,1,0.25\n0.1,-1e+10,0,0,0.5\n"));
}

TEST(WriteAnswers, ascii_holds_values_alone) {
  EXPECT_EQ(written(layout(AnswerFormat::ascii, false, true)),
            "1\t0.25\n0\t0.5\n1\t0.25\n0\t0.5\n");
  EXPECT_TRUE(written(layout(AnswerFormat::ascii, true, true)).starts_with("0\t1\t1\t0.25\n"));
}

TEST(WriteAnswers, raw_numbers) {
  EXPECT_EQ(values_of<float>(written(layout(AnswerFormat::float32, false, true))),
            twice(fractions));
  EXPECT_EQ(values_of<double>(written(layout(AnswerFormat::float64, true, false))),
            (std::vector<double>{0, 1, 2, 1, 0, 1, 2, 1}));
}

TEST(WriteAnswers, numpy_arrays_know_their_length) {
  const std::string floats = written(layout(AnswerFormat::npy, false, true));
  EXPECT_TRUE(holds(floats, "{'descr': '<f4', 'fortran_order': False, 'shape': (4, 2), }"))
      << floats;
  EXPECT_EQ(values_of<float>(floats.substr(256)), twice(fractions));
  const std::string bytes = written(layout(AnswerFormat::npy, true, false));
  EXPECT_TRUE(holds(bytes, "'|u1'") && holds(bytes, "(4, 2)"));
  EXPECT_EQ(values_of<std::uint8_t>(bytes.substr(256)), twice(classes));
  const std::string both = written(layout(AnswerFormat::npy, true, true));
  EXPECT_TRUE(holds(both, "[('class', '|u1', (2,)), ('visibility', '<f4', (2,))]"));
  EXPECT_TRUE(holds(both, "'shape': (4,)"));
  EXPECT_EQ(both.size(), 256u + 4 * 2 * 5);
  EXPECT_EQ(both.substr(256, 2), std::string("\0\1", 2));
}

TEST(WriteAnswers, ply_is_points_again) {
  const std::string bytes = written(layout(AnswerFormat::ply, true, true));
  PointReader reader("t", bytes);
  PointBlock block;
  ASSERT_TRUE(reader.next(block, 100));
  ASSERT_EQ(block.positions.size(), 4u);
  EXPECT_EQ(block.positions[3], two_points.positions[1]);
  EXPECT_EQ(block.normals[2], two_points.normals[0]);
  const PlyHeader header = read_ply_header(source_of("t.ply", bytes));
  ASSERT_EQ(header.elements.size(), 1u);
  EXPECT_EQ(header.elements[0].properties.back().name, "visibility_light1");
  EXPECT_EQ(values_of<float>(bytes.substr(bytes.size() - 4)).at(0), 0.5f);
}

TEST(WriteAnswers, what_is_not_finished_leaves_nothing) {
  const TemporaryFolder folder;
  {
    AnswerWriter writer(folder.path() / "out.csv", layout(AnswerFormat::csv, true, true));
    writer.write(two_points, {classes, fractions});
    EXPECT_FALSE(std::filesystem::is_empty(folder.path()));
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(WriteAnswers, what_cannot_be_written_is_an_error) {
  const auto error = [](const char* path, AnswerFormat format) {
    return error_of([&] {
      AnswerWriter writer(path, layout(format, false, true));
      for (int i = 0; i < 10; ++i) writer.write(two_points, {classes, fractions});
      writer.finish();
    });
  };
  EXPECT_TRUE(holds(error("/no/such/folder/x.csv", AnswerFormat::csv), "cannot be written"));
  EXPECT_TRUE(holds(error("/dev/full", AnswerFormat::csv), "No space left"));
  EXPECT_TRUE(holds(error("/dev/null", AnswerFormat::npy), "-o"));
  EXPECT_EQ(error("/dev/null", AnswerFormat::ascii), "");
}

}  // namespace
}  // namespace penumbra
