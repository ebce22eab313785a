// SPDX-License-Identifier: MIT
// What points see of lights, as a stream to a file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "penumbra/scene_io/output_file.h"
#include "penumbra/scene_io/read_points.h"

namespace penumbra {

/// csv: with the points and a line of names. ascii: values alone between tabs. npy: rows of
/// float32 (fractions), of uint8 (classes), or of a structure that holds both. ply: the points,
/// with values as properties and grey as they are lit (of classes alone, penumbra is half).
/// float32, float64: values alone.
enum class AnswerFormat { csv, ascii, npy, ply, float32, float64 };

struct AnswerLayout {
  AnswerFormat format = AnswerFormat::csv;
  bool has_classes = true, has_fractions = true;  ///< not both false; for float32 and 64 one alone
  std::size_t lights = 1;
  bool has_normals = false;              ///< the points
  std::vector<std::string> class_names;  ///< of classes 0, 1, ..., for csv
};

/// Of the points of a block, row by row: a value for each light.
struct AnswerBlock {
  std::span<const std::uint8_t> classes;
  std::span<const float> fractions;
};

/// Everything throws Error where it cannot be written.
class AnswerWriter {
 public:
  /// `-` is the standard output. NPY and PLY, which say at their beginning how many points follow,
  /// need a file.
  AnswerWriter(const std::filesystem::path& path, AnswerLayout layout);

  void write(const PointBlock& points, const AnswerBlock& answers);
  /// Gives the file its name.
  void finish();

  const OutputFile& file() const { return file_; }
  std::uint64_t points() const { return points_; }

 private:
  std::string header() const;
  std::string ply_header() const;
  void append_text(const PointBlock& points, const AnswerBlock& answers);
  void append_npy(const AnswerBlock& answers);
  void append_ply(const PointBlock& points, const AnswerBlock& answers);
  void append_numbers(const AnswerBlock& answers);

  AnswerLayout layout_;
  OutputFile file_;
  std::uint64_t points_ = 0;
  std::string bytes_;  ///< of the block
};

}  // namespace penumbra
