// SPDX-License-Identifier: MIT
// Arrays of the caller's own, read where they lie.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>

#include "penumbra/geometry/vec.h"

namespace penumbra {

/// Rows of one trivial type in the caller's memory, each `stride` bytes after the one before. Rows
/// need not be aligned. Refers to that memory.
template <class Row>
class Rows {
  static_assert(std::is_trivially_copyable_v<Row>);

 public:
  Rows() = default;
  /// One row after the other: a span, a vector, an array.
  template <class Range>
  requires std::is_convertible_v<const Range&, std::span<const Row>> Rows(
      const Range& rows)  // NOLINT: a view
      : Rows(std::span<const Row>(rows)) {}
  Rows(std::span<const Row> rows) : Rows(rows.data(), rows.size()) {}  // NOLINT: a view
  /// `stride` in bytes, of any sign; 0 repeats the first row.
  Rows(const void* first, std::size_t count, std::ptrdiff_t stride = sizeof(Row))
      : first_(static_cast<const std::byte*>(first)), count_(count), stride_(stride) {}

  std::size_t size() const { return count_; }
  bool empty() const { return count_ == 0; }
  Row operator[](std::size_t i) const {
    Row row;
    std::memcpy(static_cast<void*>(&row), first_ + static_cast<std::ptrdiff_t>(i) * stride_,
                sizeof row);
    return row;
  }

 private:
  const std::byte* first_ = nullptr;
  std::size_t count_ = 0;
  std::ptrdiff_t stride_ = sizeof(Row);
};

/// x, y, z in single precision.
using VectorRows = Rows<Vec3f>;
/// Three vertex numbers a triangle, from 0.
using TriangleRows = Rows<std::array<std::uint32_t, 3>>;
/// Radii.
using NumberRows = Rows<float>;

}  // namespace penumbra
