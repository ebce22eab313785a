// SPDX-License-Identifier: MIT
// What blocks light, and the questions about it.
#pragma once

#include <pybind11/pybind11.h>

#include "kept_occluders.h"

namespace penumbra::python {

using OccludersClass = py::class_<KeptOccluders>;

void bind_occluders(py::module_& module);
void bind_questions(py::module_& module, OccludersClass& occluders);

/// By name; ValueError for another.
Method method_of(const std::string& name);

}  // namespace penumbra::python
