// SPDX-License-Identifier: MIT
#include "lights.h"

#include <pybind11/stl.h>

#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "arguments.h"
#include "arrays.h"
#include "light_values.h"
#include "penumbra/scene/error.h"
#include "penumbra/scene_io/light_spec.h"
#include "penumbra/visibility/lights.h"

namespace penumbra::python {
namespace {

constexpr float degrees_of_half_radians = 360 / std::numbers::pi_v<float>;

template <class Shape>
Shape checked(Shape shape) {
  return std::get<Shape>(checked_light(std::move(shape)));
}

py::list tuples_of(const std::vector<Vec3f>& corners) {
  py::list list;
  for (const Vec3f corner : corners) list.append(tuple_of(corner));
  return list;
}

/// "Ball(center=(0.0, 9.0, 0.0), radius=1.0)"
std::string text_of(const char* name,
                    std::initializer_list<std::pair<const char*, py::object>> of) {
  std::string text = std::string(name) + "(";
  for (const auto& [member, value] : of)
    text +=
        (text.back() == '(' ? "" : ", ") + std::string(member) + "=" + std::string(py::repr(value));
  return text + ")";
}

void bind_round_lights(py::module_& m) {
  py::class_<PointLight> point(m, "Point", "A light without size: the visible fraction is 0 or 1.");
  point
      .def(py::init(
               [](py::object center) { return checked(PointLight{vector_of(center, "center")}); }),
           py::arg("center"))
      .def_property_readonly("center", [](const PointLight& l) { return tuple_of(l.center); })
      .def("__repr__", [](const PointLight& l) {
        return text_of("Point", {{"center", tuple_of(l.center)}});
      });
  bind_as_value(point);

  py::class_<BallLight> ball(m, "Ball", "A solid ball; radius above 0, in scene units.");
  ball.def(py::init([](py::object center, float radius) {
             return checked(BallLight{vector_of(center, "center"), radius});
           }),
           py::arg("center"), py::arg("radius"))
      .def_property_readonly("center", [](const BallLight& l) { return tuple_of(l.center); })
      .def_readonly("radius", &BallLight::radius)
      .def("__repr__", [](const BallLight& l) {
        return text_of("Ball", {{"center", tuple_of(l.center)}, {"radius", py::float_(l.radius)}});
      });
  bind_as_value(ball);

  py::class_<DiskLight> disk(m, "Disk", "A flat disk that shines both ways; any normal but 0.");
  disk.def(py::init([](py::object center, py::object normal, float radius) {
             return checked(
                 DiskLight{vector_of(center, "center"), vector_of(normal, "normal"), radius});
           }),
           py::arg("center"), py::arg("normal"), py::arg("radius"))
      .def_property_readonly("center", [](const DiskLight& l) { return tuple_of(l.center); })
      .def_property_readonly("normal", [](const DiskLight& l) { return tuple_of(l.normal); })
      .def_readonly("radius", &DiskLight::radius)
      .def("__repr__", [](const DiskLight& l) {
        return text_of("Disk", {{"center", tuple_of(l.center)},
                                {"normal", tuple_of(l.normal)},
                                {"radius", py::float_(l.radius)}});
      });
  bind_as_value(disk);
}

void bind_sun(py::module_& m) {
  py::class_<SunLight> sun(m, "Sun",
                           "A cone of directions, the same from everywhere: `towards` it, of any "
                           "length, and its angular diameter in degrees.");
  sun.def(py::init([](py::object towards, float diameter_deg) {
            return sun_light(vector_of(towards, "towards"), diameter_deg);
          }),
          py::arg("towards"), py::arg("diameter_deg") = 0.533f)
      .def_property_readonly("towards", [](const SunLight& l) { return tuple_of(l.direction); })
      .def_property_readonly(
          "diameter_deg",
          [](const SunLight& l) { return l.half_angle_rad * degrees_of_half_radians; })
      .def("__repr__", [](const SunLight& l) {
        return text_of("Sun",
                       {{"towards", tuple_of(l.direction)},
                        {"diameter_deg", py::float_(l.half_angle_rad * degrees_of_half_radians)}});
      });
  bind_as_value(sun);
}

void bind_straight_lights(py::module_& m) {
  py::class_<LineLight> line(m, "Line", "The segment from a to b, a row of points.");
  line.def(py::init([](py::object a, py::object b) {
             const Vec3d from = vector_of_doubles(a, "a"), to = vector_of_doubles(b, "b");
             return checked(LineLight{Vec3f((from + to) / 2.0), Vec3f((to - from) / 2.0)});
           }),
           py::arg("a"), py::arg("b"))
      .def_property_readonly("a", [](const LineLight& l) { return tuple_of(l.center - l.half); })
      .def_property_readonly("b", [](const LineLight& l) { return tuple_of(l.center + l.half); })
      .def("__repr__", [](const LineLight& l) {
        return text_of("Line",
                       {{"a", tuple_of(l.center - l.half)}, {"b", tuple_of(l.center + l.half)}});
      });
  bind_as_value(line);

  py::class_<ParallelogramLight> parallelogram(
      m, "Parallelogram",
      "center + a u + b v with a, b in [-1, 1]: u and v are half edges. Shines both ways.");
  parallelogram
      .def(py::init([](py::object center, py::object u, py::object v) {
             return checked(ParallelogramLight{vector_of(center, "center"), vector_of(u, "u"),
                                               vector_of(v, "v")});
           }),
           py::arg("center"), py::arg("u"), py::arg("v"))
      .def_property_readonly("center",
                             [](const ParallelogramLight& l) { return tuple_of(l.center); })
      .def_property_readonly("u", [](const ParallelogramLight& l) { return tuple_of(l.u); })
      .def_property_readonly("v", [](const ParallelogramLight& l) { return tuple_of(l.v); })
      .def("__repr__", [](const ParallelogramLight& l) {
        return text_of(
            "Parallelogram",
            {{"center", tuple_of(l.center)}, {"u", tuple_of(l.u)}, {"v", tuple_of(l.v)}});
      });
  bind_as_value(parallelogram);
}

void bind_cornered_lights(py::module_& m) {
  py::class_<PolygonLight> polygon(
      m, "Polygon", "A flat convex polygon, corners (n, 3) in order around it. Shines both ways.");
  polygon
      .def(py::init(
               [](py::object corners) { return polygon_light(vectors_of(corners, "corners")); }),
           py::arg("corners"))
      .def_property_readonly("center", [](const PolygonLight& l) { return tuple_of(l.center); })
      .def_property_readonly("corners", [](const PolygonLight& l) { return tuples_of(l.corners); })
      .def("__repr__", [](const PolygonLight& l) {
        return text_of("Polygon", {{"corners", tuples_of(l.corners)}});
      });
  bind_as_value(polygon);

  py::class_<MeshLight> hull(m, "Hull",
                             "The convex hull of points (n, 3), which enclose a volume.");
  hull.def(py::init([](py::object points) { return hull_light(vectors_of(points, "points")); }),
           py::arg("points"))
      .def_property_readonly("center", [](const MeshLight& l) { return tuple_of(l.center); })
      .def_property_readonly("points", [](const MeshLight& l) { return tuples_of(l.corners); })
      .def("__repr__", [](const MeshLight& l) {
        return text_of("Hull", {{"points", tuples_of(l.corners)}});
      });
  bind_as_value(hull);
}

const char* falloff_name(const Light& light) {
  return light.falloff == Falloff::none ? "none" : "inverse_square";
}

void bind_light(py::module_& m) {
  py::class_<Light> lamp(m, "Light",
                         "A light of a scene: its shape and its linear RGB intensity. `falloff` is "
                         "'none' (the intensity is an irradiance) or 'inverse_square'.");
  lamp.def(py::init([](py::object shape, py::object intensity, const std::string& falloff) {
             Light light = light_of(shape);
             if (!intensity.is_none()) light.intensity = vector_of(intensity, "intensity");
             if (falloff != "none" && falloff != "inverse_square")
               throw py::value_error("falloff is '" + falloff +
                                     "'; give 'none' or 'inverse_square'");
             if (falloff == "inverse_square") light.falloff = Falloff::inverse_square;
             return light;
           }),
           py::arg("shape"), py::arg("intensity") = py::none(), py::arg("falloff") = "none")
      .def_readonly("shape", &Light::shape)
      .def_property_readonly("intensity", [](const Light& l) { return tuple_of(l.intensity); })
      .def_property_readonly("falloff", &falloff_name)
      .def_property_readonly("words", &light_words, "The light as words, as `--light` takes them.")
      .def("__repr__", [](const Light& l) {
        return text_of("Light", {{"shape", py::cast(l.shape)},
                                 {"intensity", tuple_of(l.intensity)},
                                 {"falloff", py::str(falloff_name(l))}});
      });
  bind_as_value(lamp);
}

}  // namespace

Light light_of(py::handle object) {
  if (py::isinstance<py::str>(object))
    return parse_light(split_words(cast_named<std::string>(object, "light", "words in Unicode")));
  if (py::isinstance<Light>(object)) return py::cast<Light>(object);
  Light light;
  light.shape = light_shape_of(object);
  return light;
}

LightShape light_shape_of(py::handle object) {
  if (py::isinstance<py::str>(object) || py::isinstance<Light>(object))
    return light_of(object).shape;
  py::detail::make_caster<LightShape> caster;
  if (object.is_none() || !caster.load(object, false))
    throw py::type_error("a light is wanted, such as penumbra.Ball((0, 9, 0), 1), not " +
                         std::string(py::repr(py::type::handle_of(object))));
  return py::detail::cast_op<LightShape>(caster);
}

std::vector<Light> lights_of(py::handle sequence) {
  std::vector<Light> lights;
  for (const py::handle object : sequence) lights.push_back(light_of(object));
  return lights;
}

void bind_lights(py::module_& module) {
  bind_round_lights(module);
  bind_sun(module);
  bind_straight_lights(module);
  bind_cornered_lights(module);
  bind_light(module);
}

}  // namespace penumbra::python
