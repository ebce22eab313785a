// SPDX-License-Identifier: MIT
// NumPy's arrays as the library's rows, read where they lie, and arrays that answers are put into.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "penumbra/visibility/rows.h"

namespace penumbra::python {

namespace py = pybind11;

/// Rows, and the array that holds them.
template <class Row>
struct HeldRows {
  py::array array;
  Rows<Row> rows;
};

/// Throws ValueError for a masked array with a mask, which everything else here would pass over.
void refuse_mask(py::handle object, const char* name);

/// Positions or directions of shape (..., 3). float32 with packed triples is read in place,
/// whatever the other strides; all else that NumPy makes numbers of is copied, and [] is no rows.
/// `name` is the argument's. Throws ValueError.
HeldRows<Vec3f> vector_rows(py::handle object, const char* name);
/// The same for vertex numbers of shape (n, 3): uint32 and int32 in place.
HeldRows<std::array<std::uint32_t, 3>> triangle_rows(py::handle object, const char* name);
/// `count` numbers, or one for all.
HeldRows<float> number_rows(py::handle object, const char* name, std::size_t count);
/// `count` keys, of any whole type.
HeldRows<std::uint64_t> key_rows(py::handle object, const char* name, std::size_t count);

/// Three numbers; a ValueError that names the argument otherwise.
Vec3f vector_of(py::handle object, const char* name);
Vec3d vector_of_doubles(py::handle object, const char* name);
std::vector<Vec3f> vectors_of(py::handle object, const char* name);
py::tuple tuple_of(Vec3f v);
py::tuple tuple_of(Vec3d v);

/// The axes before the last: those of one answer a point. Of []: no answers.
std::vector<py::ssize_t> leading_shape(const py::array& array);

/// `out` unless it is None, else a new array. `out` must be of just this type and shape, C
/// contiguous and writable: a ValueError says so.
py::array answer_array(py::handle out, const py::dtype& type,
                       const std::vector<py::ssize_t>& shape);

/// All of a contiguous array.
template <class Value>
std::span<Value> values_of(py::array& array) {
  return {static_cast<Value*>(array.mutable_data()),
          static_cast<std::size_t>(array.nbytes()) / sizeof(Value)};
}

}  // namespace penumbra::python
