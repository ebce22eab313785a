// SPDX-License-Identifier: MIT
// Python's arguments as values, with errors that name the argument and say what is wanted.
#pragma once

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <limits>
#include <optional>
#include <string>
#include <type_traits>

namespace penumbra::python {

namespace py = pybind11;

/// ValueError: "threads is out of range; give a whole number from 0 to 4294967295".
[[noreturn]] void refuse(const std::string& name, const std::string& found,
                         const std::string& wanted);
/// TypeError: "offset is of type str; give a number".
[[noreturn]] void refuse_type(py::handle object, const std::string& name,
                              const std::string& wanted);

/// The int that an object counts as, such as NumPy's numbers but never 1.5; else null.
py::object whole_of(py::handle object);

template <class Value>
constexpr bool is_whole = std::is_integral_v<Value> && !std::is_same_v<Value, bool>;

/// "a whole number from 0 to 255"
template <class Value>
std::string wanted_for() {
  if constexpr (is_whole<Value>)
    return "a whole number from " + std::to_string(std::numeric_limits<Value>::min()) + " to " +
           std::to_string(std::numeric_limits<Value>::max());
  else if constexpr (std::is_same_v<Value, bool>)
    return "True or False";
  else if constexpr (std::is_same_v<Value, std::string>)
    return "text";
  else
    return "a number";
}

/// What `object` is as a value: whole numbers by `whole_of`. Throws TypeError, or ValueError for
/// whole numbers out of range.
template <class Value>
Value cast_named(py::handle object, const std::string& name,
                 const std::string& wanted = wanted_for<Value>()) {
  const py::object whole = is_whole<Value> ? whole_of(object) : py::object();
  const py::handle from = is_whole<Value> ? py::handle(whole) : object;
  py::detail::make_caster<Value> caster;
  if (caster.load(from, true)) return py::detail::cast_op<Value>(caster);
  const bool is_int = whole || PyLong_Check(object.ptr());
  if (std::is_arithmetic_v<Value> && is_int) refuse(name, "out of range", wanted);
  refuse_type(object, name, wanted);
}

/// None is nothing.
template <class Value>
std::optional<Value> optional_named(py::handle object, const std::string& name) {
  if (object.is_none()) return {};
  return cast_named<Value>(object, name);
}

}  // namespace penumbra::python
