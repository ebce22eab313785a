// SPDX-License-Identifier: MIT
// Surface points that ask for light, as a stream: some at a time, however many there are.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "penumbra/geometry/vec.h"
#include "penumbra/scene_io/byte_input.h"

namespace penumbra {

/// csv: lines of text, with or without commas and names. float32, float64: six numbers a point, in
/// the machine's order of bytes, as Radiance's tools pass them on.
enum class PointFormat { csv, ply, npy, float32, float64 };

/// Points that follow one another in a stream.
struct PointBlock {
  std::vector<Vec3f> positions;
  std::vector<Vec3f> normals;  ///< as many, or none; as in the file, not unit
};

class PointReader {
 public:
  /// Reads as far as it takes to know what is there. `-` is the standard input. Without a format,
  /// that of a file's name or first bytes: PLY, NPY, else lines of text. All but float32 and
  /// float64 may be gzipped. Throws Error with line or byte.
  explicit PointReader(const std::filesystem::path& path, std::optional<PointFormat> format = {});
  /// The same for a file in memory.
  PointReader(std::string name, std::string bytes, std::optional<PointFormat> format = {});
  ~PointReader();

  /// Replaces what is in `block` by the next points, at most `most` of them; false where there are
  /// none left. Coordinates need not be finite. Throws Error with line or byte.
  bool next(PointBlock& block, std::size_t most);

  bool has_normals() const;
  /// The share of the file that was read, in [0, 1]; nothing for pipes.
  std::optional<double> share() const { return input_->share(); }

 private:
  struct Rows;
  void open(std::optional<PointFormat> format);

  std::unique_ptr<ByteInput> input_;
  std::unique_ptr<Rows> rows_;
};

}  // namespace penumbra
