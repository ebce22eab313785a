// SPDX-License-Identifier: MIT
// Scenes of files, and pictures of them.
#pragma once

#include <pybind11/pybind11.h>

namespace penumbra::python {

namespace py = pybind11;

void bind_scenes(py::module_& module);
void bind_images(py::module_& module);

}  // namespace penumbra::python
