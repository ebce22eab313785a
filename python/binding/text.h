// SPDX-License-Identifier: MIT
// Texts that hold what files hold, and so may be no UTF-8.
#pragma once

#include <pybind11/pybind11.h>

#include <string_view>

namespace penumbra::python {

/// With U+FFFD for each byte that is none.
inline pybind11::object text_of(std::string_view bytes) {
  PyObject* text =
      PyUnicode_DecodeUTF8(bytes.data(), static_cast<Py_ssize_t>(bytes.size()), "replace");
  if (!text) throw pybind11::error_already_set();
  return pybind11::reinterpret_steal<pybind11::object>(text);
}

/// As Python names files: what it opens again.
inline pybind11::object path_of(std::string_view bytes) {
  PyObject* path =
      PyUnicode_DecodeFSDefaultAndSize(bytes.data(), static_cast<Py_ssize_t>(bytes.size()));
  if (!path) throw pybind11::error_already_set();
  return pybind11::reinterpret_steal<pybind11::object>(path);
}

}  // namespace penumbra::python
