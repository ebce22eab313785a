// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/read_points.h"

#include <algorithm>
#include <cstring>
#include <string>
#include <utility>
#include <variant>

#include "penumbra/scene_io/npy_header.h"
#include "penumbra/scene_io/point_rows.h"

namespace penumbra {
namespace {

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool is_raw(std::optional<PointFormat> format) {
  return format == PointFormat::float32 || format == PointFormat::float64;
}

/// The first bytes say it: numbers in text begin otherwise.
PointFormat format_of(ByteInput& input) {
  const std::string_view start = input.peek(npy_magic.size());
  if (start.starts_with(npy_magic)) return PointFormat::npy;
  if (start.starts_with("ply\n") || start.starts_with("ply\r")) return PointFormat::ply;
  return PointFormat::csv;
}

}  // namespace

PointRow row_of(const std::array<float, point_numbers>& n) {
  return {{n[0], n[1], n[2]}, {n[3], n[4], n[5]}};
}

std::size_t point_number_named(std::string_view name) {
  constexpr std::string_view names[] = {"x",  "y",        "z",        "nx",      "ny",
                                        "nz", "normal_x", "normal_y", "normal_z"};
  std::string small(name.substr(0, 20));
  std::transform(small.begin(), small.end(), small.begin(), lower);
  const auto found = std::find(std::begin(names), std::end(names), small);
  if (found == std::end(names)) return point_numbers;
  const auto index = static_cast<std::size_t>(found - std::begin(names));
  return index < point_numbers ? index : index - 3;
}

void check_point_columns(const std::array<bool, point_numbers>& has, const Error::Place& place) {
  if (!(has[0] && has[1] && has[2]))
    throw Error(place, "the points lack x, y or z", "give them all three");
  if (has[3] != has[4] || has[4] != has[5])
    throw Error(place, "the points lack nx, ny or nz", "give them all three, or none");
}

std::optional<PointRow> RawRows::next() {
  const std::size_t size = point_numbers * value_bytes_;
  const std::string_view bytes = input_->peek(size);
  if (bytes.empty()) return {};
  if (bytes.size() < size)
    throw Error({input_->name(), {}, input_->at()}, "the input ends within a point",
                "give six numbers a point: x y z nx ny nz");
  std::array<float, point_numbers> numbers{};
  if (value_bytes_ == sizeof(float)) {
    std::memcpy(numbers.data(), bytes.data(), size);
  } else {
    std::array<double, point_numbers> wide{};
    std::memcpy(wide.data(), bytes.data(), size);
    std::transform(wide.begin(), wide.end(), numbers.begin(),
                   [](double d) { return static_cast<float>(d); });
  }
  input_->skip(size);
  return row_of(numbers);
}

struct PointReader::Rows {
  std::variant<CsvRows, NpyRows, PlyRows, RawRows> rows;
};

PointReader::PointReader(const std::filesystem::path& path, std::optional<PointFormat> format)
    : input_(std::make_unique<ByteInput>(path,
                                         is_raw(format) ? Packing::none : Packing::detect_gzip)) {
  open(format);
}

PointReader::PointReader(std::string name, std::string bytes, std::optional<PointFormat> format)
    : input_(std::make_unique<ByteInput>(std::move(name), std::move(bytes))) {
  open(format);
}

PointReader::~PointReader() = default;

void PointReader::open(std::optional<PointFormat> format) {
  const auto rows = [&]() -> Rows {
    switch (format ? *format : format_of(*input_)) {
      case PointFormat::csv: return {CsvRows(*input_)};
      case PointFormat::ply: return {PlyRows(*input_)};
      case PointFormat::npy: return {NpyRows(*input_)};
      case PointFormat::float32: return {RawRows(*input_, sizeof(float))};
      case PointFormat::float64: break;
    }
    return {RawRows(*input_, sizeof(double))};
  };
  rows_ = std::make_unique<Rows>(rows());
}

bool PointReader::has_normals() const {
  return std::visit([](const auto& rows) { return rows.has_normals(); }, rows_->rows);
}

bool PointReader::next(PointBlock& block, std::size_t most) {
  block.positions.clear();
  block.normals.clear();
  std::visit(
      [&](auto& rows) {
        const bool has_normals = rows.has_normals();
        while (block.positions.size() < most) {
          const std::optional<PointRow> row = rows.next();
          if (!row) break;
          block.positions.push_back(row->position);
          if (has_normals) block.normals.push_back(row->normal);
        }
      },
      rows_->rows);
  return !block.positions.empty();
}

}  // namespace penumbra
