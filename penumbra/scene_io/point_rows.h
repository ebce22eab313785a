// SPDX-License-Identifier: MIT
// The formats of points: each reads its header when it is made, then one row after the other. All
// throw Error with line or byte.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "penumbra/geometry/vec.h"
#include "penumbra/scene_io/byte_input.h"
#include "penumbra/scene_io/ply.h"

namespace penumbra {

/// One point; the normal is 0 where a format has none.
struct PointRow {
  Vec3f position, normal;
};

/// The six numbers of a point: x, y, z, nx, ny, nz.
inline constexpr std::size_t point_numbers = 6;
PointRow row_of(const std::array<float, point_numbers>& numbers);

/// Which of the six a column's name means, in capitals or not; `point_numbers` for none.
std::size_t point_number_named(std::string_view name);

/// Throws Error unless columns make points: `has` says which of the six there are.
void check_point_columns(const std::array<bool, point_numbers>& has, const Error::Place& place);

/// Lines of text: comments (#), a line of names or none, numbers between commas, semicolons, tabs
/// or blanks.
class CsvRows {
 public:
  explicit CsvRows(ByteInput& input);
  bool has_normals() const { return has_normals_; }
  std::optional<PointRow> next();

 private:
  enum class Separator { comma, semicolon, tab, blanks };

  bool next_line();
  void read_first_line();
  bool take_names();
  void guess_names(std::string_view comment);
  bool confirm_guess();
  void number_columns();
  void choose_separator(bool may_be_tab);
  void split();
  PointRow row() const;
  Error::Place place() const { return {input_->name(), line_number_, {}}; }

  ByteInput* input_;
  std::string_view line_;  ///< the input's, until it is read on
  std::size_t line_number_ = 0;
  bool was_carriage_return_ = false;
  Separator separator_ = Separator::blanks;
  std::vector<std::string_view> fields_;
  std::vector<std::size_t> column_number_;  ///< which of the six each column is
  std::size_t columns_line_ = 0;            ///< which line said how many there are
  bool has_normals_ = false;
  std::optional<PointRow> first_;
};

/// NumPy's arrays (NEP 1), N x 3 or N x 6.
class NpyRows {
 public:
  explicit NpyRows(ByteInput& input);
  bool has_normals() const { return columns_ == point_numbers; }
  std::optional<PointRow> next();

 private:
  void convert(const char* bytes, std::array<float, point_numbers>& numbers) const;

  ByteInput* input_;
  std::size_t columns_ = 3, value_bytes_ = 4;
  bool is_swapped_ = false;  ///< bytes of values are not in the machine's order
  std::uint64_t left_ = 0;
};

/// The vertices of a PLY file; what else it has is passed over.
class PlyRows {
 public:
  explicit PlyRows(ByteInput& input);
  bool has_normals() const { return has_normals_; }
  std::optional<PointRow> next();

 private:
  void skip(const PlyElement& element);
  void skip_value(const PlyProperty& property);
  double value(PlyType type);
  std::string_view next_word();
  std::string_view take(std::size_t count);

  ByteInput* input_;
  PlyHeader header_;
  PlyElement vertices_;
  std::vector<std::size_t> property_number_;  ///< which of the six each property is
  bool has_normals_ = false;
  std::uint64_t left_ = 0;
  std::size_t line_ = 1;
};

/// Six floats or doubles a point.
class RawRows {
 public:
  RawRows(ByteInput& input, std::size_t value_bytes) : input_(&input), value_bytes_(value_bytes) {}
  bool has_normals() const { return true; }
  std::optional<PointRow> next();

 private:
  ByteInput* input_;
  std::size_t value_bytes_;
};

}  // namespace penumbra
