// SPDX-License-Identifier: MIT
#include "arrays.h"

#include <pybind11/stl.h>

#include <string>

#include "arguments.h"

namespace penumbra::python {
namespace {

std::string shape_text(const std::vector<py::ssize_t>& shape) {
  std::string text = "(";
  for (std::size_t i = 0; i < shape.size(); ++i)
    text += (i > 0 ? ", " : "") + std::to_string(shape[i]);
  return text + (shape.size() == 1 ? ",)" : ")");
}

std::vector<py::ssize_t> shape_of(const py::array& array) {
  return {array.shape(), array.shape() + array.ndim()};
}

std::string type_name(const py::dtype& type) { return py::str(py::handle(type)); }

bool holds_whole(const py::array& array) {
  return array.dtype().kind() == 'i' || array.dtype().kind() == 'u';
}

bool is_empty_list(const py::array& array) { return array.ndim() == 1 && array.size() == 0; }

/// The object itself where it is an array of this type, else a copy.
template <class Number>
py::array numbers(py::handle object, const char* name, const char* wanted) {
  refuse_mask(object, name);
  py::array array =
      py::array_t<Number, py::array::forcecast>::ensure(py::reinterpret_borrow<py::object>(object));
  if (!array) refuse(name, "nothing that makes an array of numbers", wanted);
  return array;
}

/// Of any whole type; an empty list, which NumPy takes for floats, is among them.
py::array whole_numbers(py::handle object, const char* name, const char* wanted) {
  refuse_mask(object, name);
  py::array array = py::array::ensure(py::reinterpret_borrow<py::object>(object));
  if (!array) refuse(name, "nothing that makes an array of numbers", wanted);
  if (array.size() > 0 && !holds_whole(array))
    refuse(name, "of type " + type_name(array.dtype()), wanted);
  return array;
}

/// (n, 3) with packed triples, without a copy where the strides allow it.
py::array triples(py::array array, const char* name, const char* wanted) {
  if (is_empty_list(array)) array = array.reshape({py::ssize_t(0), py::ssize_t(3)});
  if (array.ndim() < 1 || array.shape(array.ndim() - 1) != 3)
    refuse(name, "of shape " + shape_text(shape_of(array)), wanted);
  if (array.ndim() != 2) array = array.reshape({py::ssize_t(-1), py::ssize_t(3)});
  if (array.strides(1) == array.itemsize()) return array;
  return py::module_::import("numpy").attr("ascontiguousarray")(array);
}

template <class Row>
HeldRows<Row> rows_of(py::array array) {
  const Rows<Row> rows(array.data(), static_cast<std::size_t>(array.shape(0)), array.strides(0));
  return {std::move(array), rows};
}

template <class Number>
HeldRows<Number> flat_rows(py::array array, const char* name, std::size_t count, const char* what) {
  const std::string wanted = std::to_string(count) + " " + what;
  if (array.ndim() != 1) array = array.reshape({py::ssize_t(-1)});
  if (static_cast<std::size_t>(array.shape(0)) != count)
    refuse(name, std::to_string(array.shape(0)) + " numbers", wanted);
  return rows_of<Number>(std::move(array));
}

}  // namespace

void refuse_mask(py::handle object, const char* name) {
  if (py::isinstance<py::array>(object) &&
      py::cast<bool>(py::module_::import("numpy.ma").attr("is_masked")(object)))
    refuse(name, "masked in part", "what its mask leaves, or .filled(...) with values");
}

HeldRows<Vec3f> vector_rows(py::handle object, const char* name) {
  constexpr const char* wanted = "an array of shape (n, 3), best float32";
  return rows_of<Vec3f>(triples(numbers<float>(object, name, wanted), name, wanted));
}

HeldRows<std::array<std::uint32_t, 3>> triangle_rows(py::handle object, const char* name) {
  constexpr const char* wanted = "vertex numbers of shape (n, 3), best uint32";
  py::array array = whole_numbers(object, name, wanted);
  const bool is_in_place =
      holds_whole(array) && array.itemsize() == 4 && array.dtype().byteorder() == '=';
  if (!is_in_place) {
    // Wider numbers must not come around to valid ones. (Negative int32 are beyond any vertex.)
    if (array.size() > 0 && (py::cast<double>(array.attr("min")()) < 0 ||
                             py::cast<double>(array.attr("max")()) > 0xffffffffu))
      refuse(name, "beyond 32 bits", wanted);
    array = numbers<std::uint32_t>(array, name, wanted);
  }
  if (array.ndim() != 2 && !is_empty_list(array))
    refuse(name, "of shape " + shape_text(shape_of(array)), wanted);
  return rows_of<std::array<std::uint32_t, 3>>(triples(std::move(array), name, wanted));
}

HeldRows<float> number_rows(py::handle object, const char* name, std::size_t count) {
  py::array array = numbers<float>(object, name, "a number, or an array of them");
  if (array.ndim() > 0) return flat_rows<float>(std::move(array), name, count, "(or one)");
  const Rows<float> rows(array.data(), count, 0);
  return {std::move(array), rows};
}

HeldRows<std::uint64_t> key_rows(py::handle object, const char* name, std::size_t count) {
  constexpr const char* wanted = "an array of uint64";
  const py::array array = whole_numbers(object, name, wanted);
  if (array.size() > 0 && py::cast<double>(array.attr("min")()) < 0)
    refuse(name, "negative in part", wanted);
  return flat_rows<std::uint64_t>(numbers<std::uint64_t>(array, name, wanted), name, count, "keys");
}

Vec3d vector_of_doubles(py::handle object, const char* name) {
  const py::array array = numbers<double>(object, name, "three numbers");
  if (array.ndim() != 1 || array.shape(0) != 3)
    refuse(name, "of shape " + shape_text(shape_of(array)), "three numbers");
  const Rows<double> at = rows_of<double>(array).rows;
  return {at[0], at[1], at[2]};
}

Vec3f vector_of(py::handle object, const char* name) {
  return Vec3f(vector_of_doubles(object, name));
}

std::vector<Vec3f> vectors_of(py::handle object, const char* name) {
  const HeldRows<Vec3f> held = vector_rows(object, name);
  std::vector<Vec3f> vectors(held.rows.size());
  for (std::size_t i = 0; i < vectors.size(); ++i) vectors[i] = held.rows[i];
  return vectors;
}

py::tuple tuple_of(Vec3f v) { return py::make_tuple(v.x, v.y, v.z); }
py::tuple tuple_of(Vec3d v) { return py::make_tuple(v.x, v.y, v.z); }

std::vector<py::ssize_t> leading_shape(const py::array& array) {
  std::vector<py::ssize_t> shape = shape_of(array);
  if (!shape.empty() && !is_empty_list(array)) shape.pop_back();
  return shape;
}

py::array answer_array(py::handle out, const py::dtype& type,
                       const std::vector<py::ssize_t>& shape) {
  if (out.is_none()) return py::array(type, shape);
  const std::string wanted =
      "a writable, C contiguous array of " + type_name(type) + " and shape " + shape_text(shape);
  if (!py::isinstance<py::array>(out)) refuse("out", "no array", wanted);
  py::array array = py::reinterpret_borrow<py::array>(out);
  if (!array.dtype().equal(type)) refuse("out", type_name(array.dtype()), wanted);
  if (shape_of(array) != shape) refuse("out", "of shape " + shape_text(shape_of(array)), wanted);
  if (!array.writeable()) refuse("out", "read-only", wanted);
  constexpr int layout = int{py::array::c_style} | int{py::detail::npy_api::NPY_ARRAY_ALIGNED_};
  if ((array.flags() & layout) != layout) refuse("out", "not contiguous", wanted);
  return array;
}

}  // namespace penumbra::python
