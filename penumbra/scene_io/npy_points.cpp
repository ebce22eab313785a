// SPDX-License-Identifier: MIT
// NumPy's format: numpy.lib.format in NumPy's manual (NEP 1).
#include <algorithm>
#include <bit>
#include <cstring>

#include "penumbra/scene_io/npy_header.h"
#include "penumbra/scene_io/numbers.h"
#include "penumbra/scene_io/point_rows.h"

namespace penumbra {

NpyRows::NpyRows(ByteInput& input) : input_(&input) {
  const NpyHeader header = read_npy_header(input);
  const Error::Place place{input.name(), {}, {}};
  const bool is_real = header.kind == 'f' && (header.value_bytes == 4 || header.value_bytes == 8);
  if (!is_real)
    throw Error(place, "its values are of NumPy's type " + in_quotes(header.type),
                "save a plain array of floats: points.astype(numpy.float32)");
  if (header.shape.size() != 2 || (header.shape[1] != 3 && header.shape[1] != point_numbers))
    throw Error(place, "its shape is " + header.shape_text(),
                "save N x 3 (x y z) or N x 6 (x y z nx ny nz) numbers");
  if (header.is_fortran_order && header.shape[0] > 1)
    throw Error(place, "its numbers are in Fortran order, column by column",
                "save numpy.ascontiguousarray(points)");
  columns_ = header.shape[1];
  value_bytes_ = header.value_bytes;
  is_swapped_ = header.is_big_endian == (std::endian::native == std::endian::little);
  left_ = header.shape[0];
  const std::optional<std::uint64_t> remaining = input.remaining();
  if (remaining && left_ > *remaining / (columns_ * value_bytes_))
    throw Error(place,
                "claims " + std::to_string(left_) + " points, but only " +
                    std::to_string(*remaining) + " bytes follow",
                "the file may be cut off");
}

void NpyRows::convert(const char* bytes, std::array<float, point_numbers>& numbers) const {
  for (std::size_t i = 0; i < columns_; ++i) {
    std::array<char, 8> value{};
    std::memcpy(value.data(), bytes + i * value_bytes_, value_bytes_);
    if (is_swapped_)
      std::reverse(value.begin(), value.begin() + static_cast<std::ptrdiff_t>(value_bytes_));
    if (value_bytes_ == sizeof(float))
      numbers[i] = std::bit_cast<std::array<float, 2>>(value)[0];
    else
      numbers[i] = static_cast<float>(std::bit_cast<double>(value));
  }
}

std::optional<PointRow> NpyRows::next() {
  if (left_ == 0) return {};
  --left_;
  const std::size_t size = columns_ * value_bytes_;
  const std::string_view bytes = input_->peek(size);
  if (bytes.size() < size)
    throw Error({input_->name(), {}, input_->at()},
                "the file ends, but " + std::to_string(left_ + 1) + " more points should follow",
                "it may be cut off");
  std::array<float, point_numbers> numbers{};
  if (is_swapped_ || value_bytes_ != sizeof(float))
    convert(bytes.data(), numbers);
  else
    std::memcpy(numbers.data(), bytes.data(), size);
  input_->skip(size);
  return row_of(numbers);
}

}  // namespace penumbra
