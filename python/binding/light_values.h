// SPDX-License-Identifier: MIT
// Lights as values of Python: equal where their parts are, hashed, copied and pickled by them.
#pragma once

#include <pybind11/pybind11.h>

#include "penumbra/scene/light.h"

namespace penumbra::python {

namespace py = pybind11;

/// All that a light is, to the last bit: tuples, numbers, and for `Light` its shape.
py::tuple parts_of(const PointLight& light);
py::tuple parts_of(const BallLight& light);
py::tuple parts_of(const ParallelogramLight& light);
py::tuple parts_of(const DiskLight& light);
py::tuple parts_of(const LineLight& light);
py::tuple parts_of(const PolygonLight& light);
py::tuple parts_of(const MeshLight& light);
py::tuple parts_of(const SunLight& light);
py::tuple parts_of(const Light& light);

/// Sets what `parts_of` gave. Throws Error, or what Python raises, for parts of no light.
void set_parts(PointLight& light, const py::tuple& parts);
void set_parts(BallLight& light, const py::tuple& parts);
void set_parts(ParallelogramLight& light, const py::tuple& parts);
void set_parts(DiskLight& light, const py::tuple& parts);
void set_parts(LineLight& light, const py::tuple& parts);
void set_parts(PolygonLight& light, const py::tuple& parts);
void set_parts(MeshLight& light, const py::tuple& parts);
void set_parts(SunLight& light, const py::tuple& parts);
void set_parts(Light& light, const py::tuple& parts);

/// Throws Error for lights that no question takes.
void check_shape(const LightShape& shape);
inline void check_shape(const Light& light) { check_shape(light.shape); }

template <class AnyLight>
void bind_as_value(py::class_<AnyLight>& bound) {
  bound
      .def("__eq__",
           [](const AnyLight& a, py::object b) {
             return py::isinstance<AnyLight>(b) &&
                    parts_of(a).equal(parts_of(py::cast<const AnyLight&>(b)));
           })
      .def("__hash__", [](const AnyLight& light) { return py::hash(parts_of(light)); })
      .def(py::pickle([](const AnyLight& light) { return parts_of(light); },
                      [](const py::tuple& parts) {
                        AnyLight light;
                        set_parts(light, parts);
                        check_shape(light);
                        return light;
                      }));
}

}  // namespace penumbra::python
