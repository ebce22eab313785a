// SPDX-License-Identifier: MIT
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "arguments.h"
#include "arrays.h"
#include "calls.h"
#include "lights.h"
#include "occluders.h"

namespace penumbra::python {
namespace {

/// Points, the arrays that they lie in, and the shape of one answer each.
struct HeldPoints {
  Points points;
  Arrays arrays;
  std::vector<py::ssize_t> shape;
};

struct PointArguments {
  py::object positions, normals, offset, keys, first_key;
};

HeldPoints points_of(const PointArguments& given) {
  HeldPoints held;
  const auto positions = vector_rows(given.positions, "positions");
  held.points.positions = positions.rows;
  held.shape = leading_shape(py::array::ensure(given.positions));
  held.arrays.push_back(positions.array);
  const std::size_t count = positions.rows.size();
  if (!given.normals.is_none()) {
    const auto normals = vector_rows(given.normals, "normals");
    held.points.normals = normals.rows;
    // One for all: (3,).
    if (normals.rows.size() == 1 && count != 1)
      held.points.normals = VectorRows(normals.array.data(), count, 0);
    held.arrays.push_back(normals.array);
  }
  held.points.offset = optional_named<float>(given.offset, "offset");
  held.points.first_key = cast_named<std::uint64_t>(given.first_key, "first_key");
  if (!given.keys.is_none()) {
    const auto keys = key_rows(given.keys, "keys", count);
    held.points.keys = keys.rows;
    held.arrays.push_back(keys.array);
  }
  return held;
}

/// What every question takes beside points and light, in this order.
struct Asking {
  py::object shadow_samples, method, light_index, threads, progress, out, counters;
};

AskOptions options_of(const Asking& asking) {
  return {
      .shadow_samples = cast_named<std::uint32_t>(asking.shadow_samples, "shadow_samples"),
      .method = method_of(cast_named<std::string>(asking.method, "method")),
      .light_index = optional_named<std::uint32_t>(asking.light_index, "light_index"),
      .threads = cast_named<std::uint32_t>(asking.threads, "threads"),
  };
}

/// Words of a point's bits; of numbers of samples that will be refused, some.
py::ssize_t words_of(std::uint32_t samples) { return (std::clamp(samples, 1u, 65536u) + 31) / 32; }

/// One answer a point, or a row of bits.
enum class Answers { values, bits };

/// Puts answers into `out` or a new array.
template <Answers answers, class Value, class Question>
py::array ask(const PointArguments& given, const Asking& asking, const py::dtype& type,
              Question question) {
  HeldPoints held = points_of(given);
  AskOptions options = options_of(asking);
  auto* counters = cast_named<ShadowCounters*>(asking.counters, "counters", "penumbra.Counters()");
  if (answers == Answers::bits) held.shape.push_back(words_of(options.shadow_samples));
  py::array array = answer_array(asking.out, type, held.shape);
  Watch watch(asking.progress);
  options.progress = [&watch](double share) { return watch.goes_on(share); };
  const std::span<Value> values = values_of<Value>(array);
  const ShadowCounters cost = watch.run([&] { return question(held.points, values, options); });
  if (counters) counters->add(cost);
  return array;
}

py::dtype visibility_type() {
  py::list names, formats, offsets;
  const auto add = [&](const char* name, const char* format, std::size_t offset) {
    names.append(name), formats.append(format), offsets.append(offset);
  };
  add("cosine_weighted", "f4", offsetof(Visibility, cosine_weighted));
  add("fraction", "f4", offsetof(Visibility, fraction));
  add("shadow_class", "u1", offsetof(Visibility, shadow_class));
  add("rays", "u4", offsetof(Visibility, rays));
  return py::dtype(std::move(names), std::move(formats), std::move(offsets), sizeof(Visibility));
}

py::array primitives_of(const Blockers& blockers) {
  py::array_t<std::uint32_t> array(
      {static_cast<py::ssize_t>(blockers.primitives.size()), py::ssize_t(3)});
  auto row = array.mutable_unchecked<2>();
  for (py::ssize_t i = 0; i < row.shape(0); ++i) {
    const PrimitiveId& id = blockers.primitives[static_cast<std::size_t>(i)];
    row(i, 0) = id.geometry, row(i, 1) = id.primitive, row(i, 2) = id.instance;
  }
  return array;
}

/// (class, primitives)
template <class Question>
py::tuple blockers_of(Question question) {
  Blockers blockers;
  {
    const py::gil_scoped_release unlocked;
    blockers = question();
  }
  return py::make_tuple(static_cast<int>(blockers.shadow_class), primitives_of(blockers));
}

using Object = py::object;

template <class Value, Answers answers = Answers::values, class Question>
auto question_of(py::dtype type, Question question) {
  return [type, question](const KeptOccluders& o, Object positions, Object light, Object normals,
                          Object offset, Object keys, Object first_key, Object samples,
                          Object method, Object light_index, Object threads, Object progress,
                          Object out, Object counters) {
    const LightShape shape = light_shape_of(light);
    return ask<answers, Value>(
        {positions, normals, offset, keys, first_key},
        {samples, method, light_index, threads, progress, out, counters}, type,
        [&](const Points& points, std::span<Value> values, const AskOptions& options) {
          return question(o.asked(), points, shape, values, options);
        });
  };
}

void bind_counters(py::module_& m) {
  py::class_<ShadowCounters>(m, "Counters",
                             "Exact integers that calls add to: questions by class, and what "
                             "their answers took.")
      .def(py::init<>())
      .def_readonly("lit", &ShadowCounters::lit)
      .def_readonly("penumbra", &ShadowCounters::penumbra)
      .def_readonly("umbra", &ShadowCounters::umbra)
      .def_readonly("rays", &ShadowCounters::rays)
      .def_readonly("tests", &ShadowCounters::tests)
      .def_readonly("cache_decided", &ShadowCounters::cache_decided)
      .def_readonly("set_rays", &ShadowCounters::set_rays)
      .def_readonly("set_tests", &ShadowCounters::set_tests)
      .def("__repr__", [](const ShadowCounters& c) {
        return "<Counters lit=" + std::to_string(c.lit) +
               " penumbra=" + std::to_string(c.penumbra) + " umbra=" + std::to_string(c.umbra) +
               " rays=" + std::to_string(c.rays) + ">";
      });
}

void bind_arrays_of_answers(OccludersClass& c) {
  const auto number_type = py::dtype::of<std::uint32_t>();
  c.def("classify",
        question_of<ShadowClass>(
            py::dtype::of<std::uint8_t>(),
            [](const Occluders& o, const Points& p, const LightShape& l, std::span<ShadowClass> out,
               const AskOptions& a) { return o.classify(p, l, out, a); }))
      .def("visible_fraction",
           question_of<float>(
               py::dtype::of<float>(),
               [](const Occluders& o, const Points& p, const LightShape& l, std::span<float> out,
                  const AskOptions& a) { return o.visible_fraction(p, l, out, a); }))
      .def("visible_samples",
           question_of<std::uint32_t, Answers::bits>(
               number_type, [](const Occluders& o, const Points& p, const LightShape& l,
                               std::span<std::uint32_t> out,
                               const AskOptions& a) { return o.visible_samples(p, l, out, a); }))
      .def("visibility",
           question_of<Visibility>(visibility_type(),
                                   [](const Occluders& o, const Points& p, const LightShape& l,
                                      std::span<Visibility> out,
                                      const AskOptions& a) { return o.visibility(p, l, out, a); }));
}

py::array light_sample_array(Object light, Object position, Object key, Object samples,
                             Object light_index) {
  const std::vector<Vec3f> ways = light_samples(
      light_shape_of(light), vector_of(position, "position"), cast_named<std::uint64_t>(key, "key"),
      cast_named<std::uint32_t>(samples, "shadow_samples"),
      optional_named<std::uint32_t>(light_index, "light_index"));
  py::array_t<float> array({static_cast<py::ssize_t>(ways.size()), py::ssize_t(3)});
  auto row = array.mutable_unchecked<2>();
  for (py::ssize_t i = 0; i < row.shape(0); ++i)
    for (int axis = 0; axis < 3; ++axis) row(i, axis) = ways[static_cast<std::size_t>(i)][axis];
  return array;
}

}  // namespace

void bind_questions(py::module_& m, OccludersClass& c) {
  bind_counters(m);
  bind_arrays_of_answers(c);
  c.def("blockers", [](const KeptOccluders& o, Object position, Object light, Object normal) {
     const LightShape shape = light_shape_of(light);
     const Vec3f p = vector_of(position, "position");
     const Vec3f n = normal.is_none() ? Vec3f{} : vector_of(normal, "normal");
     return blockers_of([&] { return o.asked().blockers(p, n, shape); });
   }).def("shaft", [](const KeptOccluders& o, Object lo, Object hi, Object light) {
    const LightShape shape = light_shape_of(light);
    const Box box{vector_of(lo, "lo"), vector_of(hi, "hi")};
    return blockers_of([&] { return o.asked().shaft(box, shape); });
  });
  m.def("light_samples", &light_sample_array);
}

}  // namespace penumbra::python
