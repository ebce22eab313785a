// SPDX-License-Identifier: MIT
// What the package `penumbra` (python/penumbra) is built on: thin, without defaults. Documentation
// is in the Python files and, for what is used from here as it is, here.
#include <pybind11/pybind11.h>

#include <array>
#include <string>
#include <utility>

#include "lights.h"
#include "occluders.h"
#include "penumbra/scene/error.h"
#include "scenes.h"
#include "text.h"

namespace penumbra::python {
namespace {

/// `Error` with what it knows, as attributes.
void raise(const Error& error) {
  const py::object type = py::module_::import("penumbra._penumbra").attr("Error");
  const py::object raised = type(text_of(error.what()));
  const auto optional = [](const auto& value) {
    return value ? py::object(py::int_(*value)) : py::object(py::none());
  };
  raised.attr("file") = error.place.file.empty() ? py::none() : path_of(error.place.file);
  raised.attr("line") = optional(error.place.line);
  raised.attr("byte") = optional(error.place.byte);
  raised.attr("problem") = text_of(error.problem);
  raised.attr("hint") = text_of(error.hint);
  PyErr_SetObject(type.ptr(), raised.ptr());
}

void bind_errors(py::module_& m) {
  py::exception<Error> bad_input(m, "Error", PyExc_ValueError);
  bad_input.attr("__doc__") =
      "Input that cannot be meant: `file:line: what is wrong; what to do`. Its parts are `file`, "
      "`line`, `byte` (None where there is none), `problem` and `hint`.";
  py::exception<Cancelled> cancelled(m, "Cancelled", PyExc_RuntimeError);
  cancelled.attr("__doc__") =
      "A call whose `progress` returned False, or what else is false but not None. What was to be "
      "filled is filled in part.";
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const Error& error) {
      raise(error);
    }
  });
}

}  // namespace

Method method_of(const std::string& name) {
  constexpr std::array<std::pair<const char*, Method>, 6> methods = {
      {{"shaft", Method::shaft},
       {"stochastic", Method::stochastic},
       {"offset", Method::offset},
       {"reduced", Method::reduced},
       {"umbra", Method::umbra},
       {"hard", Method::hard}}};
  for (const auto& [known, method] : methods)
    if (name == known) return method;
  throw py::value_error("there is no method '" + name +
                        "'; there are shaft, stochastic, offset, reduced, umbra and hard");
}

}  // namespace penumbra::python

PYBIND11_MODULE(_penumbra, m) {
  m.attr("version") = PENUMBRA_VERSION;
  penumbra::python::bind_errors(m);
  penumbra::python::bind_lights(m);
  penumbra::python::bind_occluders(m);
  penumbra::python::bind_scenes(m);
  penumbra::python::bind_images(m);
}
