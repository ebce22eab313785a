// SPDX-License-Identifier: MIT
#include "light_values.h"

#include <pybind11/stl.h>

#include <array>
#include <cstdint>
#include <vector>

#include "arguments.h"
#include "arrays.h"
#include "lights.h"
#include "penumbra/visibility/lights.h"

namespace penumbra::python {
namespace {

py::tuple tuples_of(const std::vector<Vec3f>& corners) {
  py::tuple tuples(corners.size());
  for (std::size_t i = 0; i < corners.size(); ++i) tuples[i] = tuple_of(corners[i]);
  return tuples;
}

py::tuple tuples_of(const std::vector<std::array<std::uint32_t, 3>>& triangles) {
  py::tuple tuples(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i)
    tuples[i] = py::make_tuple(triangles[i][0], triangles[i][1], triangles[i][2]);
  return tuples;
}

float number_of(py::handle part) { return cast_named<float>(part, "a light's part"); }
Vec3f vector_in(py::handle part) { return vector_of(part, "a light's part"); }
std::vector<Vec3f> corners_in(py::handle part) { return vectors_of(part, "a light's part"); }

}  // namespace

py::tuple parts_of(const PointLight& l) { return py::make_tuple(tuple_of(l.center)); }
void set_parts(PointLight& l, const py::tuple& parts) { l.center = vector_in(parts[0]); }

py::tuple parts_of(const BallLight& l) { return py::make_tuple(tuple_of(l.center), l.radius); }
void set_parts(BallLight& l, const py::tuple& parts) {
  l = {vector_in(parts[0]), number_of(parts[1])};
}

py::tuple parts_of(const ParallelogramLight& l) {
  return py::make_tuple(tuple_of(l.center), tuple_of(l.u), tuple_of(l.v));
}
void set_parts(ParallelogramLight& l, const py::tuple& parts) {
  l = {vector_in(parts[0]), vector_in(parts[1]), vector_in(parts[2])};
}

py::tuple parts_of(const DiskLight& l) {
  return py::make_tuple(tuple_of(l.center), tuple_of(l.normal), l.radius);
}
void set_parts(DiskLight& l, const py::tuple& parts) {
  l = {vector_in(parts[0]), vector_in(parts[1]), number_of(parts[2])};
}

py::tuple parts_of(const LineLight& l) {
  return py::make_tuple(tuple_of(l.center), tuple_of(l.half));
}
void set_parts(LineLight& l, const py::tuple& parts) {
  l = {vector_in(parts[0]), vector_in(parts[1])};
}

py::tuple parts_of(const PolygonLight& l) {
  return py::make_tuple(tuple_of(l.center), tuples_of(l.corners));
}
void set_parts(PolygonLight& l, const py::tuple& parts) {
  l = {vector_in(parts[0]), corners_in(parts[1])};
}

py::tuple parts_of(const MeshLight& l) {
  return py::make_tuple(tuple_of(l.center), tuples_of(l.corners), tuples_of(l.triangles));
}
void set_parts(MeshLight& l, const py::tuple& parts) {
  const HeldRows<std::array<std::uint32_t, 3>> triangles =
      triangle_rows(py::object(parts[2]), "a light's part");
  l = {vector_in(parts[0]), corners_in(parts[1]), {}};
  for (std::size_t i = 0; i < triangles.rows.size(); ++i) l.triangles.push_back(triangles.rows[i]);
}

py::tuple parts_of(const SunLight& l) {
  return py::make_tuple(tuple_of(l.direction), l.half_angle_rad);
}
void set_parts(SunLight& l, const py::tuple& parts) {
  l = {vector_in(parts[0]), number_of(parts[1])};
}

py::tuple parts_of(const Light& l) {
  py::object beam = py::none();
  if (l.beam) beam = py::make_tuple(tuple_of(l.beam->axis), l.beam->cos_full, l.beam->cos_none);
  return py::make_tuple(l.shape, tuple_of(l.intensity), l.falloff == Falloff::inverse_square, beam);
}
void set_parts(Light& l, const py::tuple& parts) {
  l.shape = light_shape_of(py::object(parts[0]));
  l.intensity = vector_in(parts[1]);
  l.falloff =
      cast_named<bool>(parts[2], "a light's part") ? Falloff::inverse_square : Falloff::none;
  if (py::object(parts[3]).is_none()) return;
  const py::tuple beam = parts[3];
  l.beam = {vector_in(beam[0]), number_of(beam[1]), number_of(beam[2])};
}

void check_shape(const LightShape& shape) { checked_light(shape); }

}  // namespace penumbra::python
