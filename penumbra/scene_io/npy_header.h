// SPDX-License-Identifier: MIT
// The header of NumPy's arrays on disk (numpy.lib.format), versions 1 to 3.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "penumbra/scene_io/byte_input.h"

namespace penumbra {

struct NpyHeader {
  std::string type;             ///< as NumPy writes it, `<f4`; cut short
  char kind = 'f';              ///< NumPy's letter: f, i, u, ...; V for structured arrays
  std::size_t value_bytes = 0;  ///< of one value
  bool is_big_endian = false;
  bool is_fortran_order = false;  ///< column by column
  std::vector<std::uint64_t> shape;

  std::string shape_text() const;  ///< `(100, 3)`
};

inline constexpr std::string_view npy_magic = "\x93NUMPY";

/// Goes on to the first value. Throws Error.
NpyHeader read_npy_header(ByteInput& input);

/// The header, of 256 bytes, of rows in C order. `type` is as NumPy writes it in Python, with its
/// quotes or brackets; no longer than 100 characters. `columns` 0: of one dimension.
std::string npy_header(const std::string& type, std::uint64_t rows, std::uint64_t columns);

}  // namespace penumbra
