// SPDX-License-Identifier: MIT
// What Python may give as a light.
#pragma once

#include <pybind11/pybind11.h>

#include <vector>

#include "penumbra/geometry/light_shape.h"
#include "penumbra/scene/light.h"

namespace penumbra::python {

namespace py = pybind11;

/// One of the light classes, a `Light` or the words of `--light`. Throws TypeError for all else.
Light light_of(py::handle object);
LightShape light_shape_of(py::handle object);
std::vector<Light> lights_of(py::handle sequence);

void bind_lights(py::module_& module);

}  // namespace penumbra::python
