// SPDX-License-Identifier: MIT
// What C hands over, checked, as what C++ takes. All of it throws ApiError.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>

#include "penumbra/geometry/light_shape.h"
#include "penumbra/geometry/transform.h"
#include "penumbra/penumbra_c.h"
#include "penumbra/visibility/c_api_error.h"
#include "penumbra/visibility/occluders.h"
#include "penumbra/visibility/rows.h"

namespace penumbra {

/// The rows' stride in bytes, as Rows has it; the pointer is not NULL, and the last row does not
/// lie beyond the end of the address space.
std::ptrdiff_t checked_stride(const penumbra_rows& rows, std::size_t row_size, const char* name);

template <class Row>
Rows<Row> rows_of(const penumbra_rows& rows, const char* name) {
  if (rows.count == 0) return {};
  return {rows.data, rows.count, checked_stride(rows, sizeof(Row), name)};
}

inline void check_pointer(const void* pointer, const char* name) {
  if (!pointer) refuse_argument(std::string(name) + " is NULL");
}

/// `struct_size` must be that of the first version of the struct, or of a later one that this
/// library knows. There has been but one.
void check_struct_size(std::size_t given, std::size_t known, const char* name);

/// A struct that begins with `struct_size`, wherever it lies.
template <class Struct>
Struct read_struct(const Struct* given, const char* name) {
  check_pointer(given, name);
  std::size_t size = 0;
  std::memcpy(&size, static_cast<const void*>(given), sizeof size);
  check_struct_size(size, sizeof(Struct), name);
  Struct read;
  std::memcpy(static_cast<void*>(&read), static_cast<const void*>(given), sizeof read);
  return read;
}

/// Over a struct that `read_struct` was content with.
template <class Struct>
void write_struct(Struct* out, Struct values) {
  values.struct_size = sizeof values;
  std::memcpy(static_cast<void*>(out), &values, sizeof values);
}

/// Memory of the caller's to be written to.
template <class Row>
std::span<Row> written(Row* out, std::size_t count, const char* name) {
  if (count == 0) return {};
  check_pointer(out, name);
  if (reinterpret_cast<std::uintptr_t>(out) % alignof(Row) != 0)
    refuse_argument(std::string(name) + " is not aligned");
  if (count > PTRDIFF_MAX / sizeof(Row))
    refuse_argument(std::string(name) + " has a count beyond all memory");
  return {out, count};
}

/// 3 floats, aligned or not.
Vec3f vector_of(const float* given, const char* name);
void write_vector(float* out, Vec3f v, const char* name);

/// Of 3 rows of 4.
Transform transform_of(const double* placement);

LightShape light_of(const penumbra_light* light);

Points points_of(const penumbra_points* points);

/// NULL: the defaults. What it returns calls the progress function.
AskOptions ask_options_of(const penumbra_ask_options* options);

}  // namespace penumbra
