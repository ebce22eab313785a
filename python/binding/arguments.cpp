// SPDX-License-Identifier: MIT
#include "arguments.h"

namespace penumbra::python {

void refuse(const std::string& name, const std::string& found, const std::string& wanted) {
  throw py::value_error(name + " is " + found + "; give " + wanted);
}

void refuse_type(py::handle object, const std::string& name, const std::string& wanted) {
  const std::string type = py::str(py::type::handle_of(object).attr("__name__"));
  throw py::type_error(name + " is of type " + type + "; give " + wanted);
}

py::object whole_of(py::handle object) {
  PyObject* whole = PyIndex_Check(object.ptr()) ? PyNumber_Index(object.ptr()) : nullptr;
  if (!whole) PyErr_Clear();  // arrays of several numbers say that they have an index, but do not
  return py::reinterpret_steal<py::object>(whole);
}

}  // namespace penumbra::python
