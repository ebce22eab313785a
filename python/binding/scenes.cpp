// SPDX-License-Identifier: MIT
#include "scenes.h"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "arguments.h"
#include "arrays.h"
#include "calls.h"
#include "kept_occluders.h"
#include "lights.h"
#include "occluders.h"
#include "penumbra/render.h"
#include "penumbra/visibility/scene_occluders.h"
#include "text.h"

namespace penumbra::python {
namespace {

/// A complete scene; its renderer is made when the first picture is drawn, and kept for the next.
struct DrawnScene {
  Scene scene;
  std::vector<std::string> warnings;
  std::mutex mutex;
  std::shared_ptr<const Renderer> renderer;
};

template <class Value>
Value value_in(const py::dict& options, const char* name) {
  return cast_named<Value>(options[name], name);
}

std::optional<Vec3d> vector_in(const py::dict& options, const char* name) {
  const py::object value = options[name];
  if (value.is_none()) return {};
  return vector_of_doubles(value, name);
}

std::optional<Color> color_in(const py::dict& options, const char* name) {
  const std::optional<Vec3d> value = vector_in(options, name);
  return value ? std::optional<Color>(Color(*value)) : std::nullopt;
}

/// A number, or "5%" of the objects' extent.
std::optional<LightRadius> light_radius_of(py::handle given) {
  if (given.is_none()) return {};
  LightRadius radius;
  if (py::isinstance<py::str>(given)) {
    auto text = cast_named<std::string>(given, "light_radius");
    radius.is_percent = text.ends_with('%');
    if (radius.is_percent) text.pop_back();
    const auto number = py::reinterpret_steal<py::object>(PyFloat_FromString(py::str(text).ptr()));
    if (!number) PyErr_Clear();  // a radius of 0, which is refused
    radius.value = number ? py::cast<float>(number) : 0;
  } else {
    radius.value = cast_named<float>(given, "light_radius", "a number, or such as '10%'");
  }
  if (!(radius.value > 0 && radius.value <= 1e15f))
    throw py::value_error("light_radius must be above 0, a number or such as '10%'");
  return radius;
}

std::variant<GroundChoice, double> ground_of(py::handle given) {
  if (given.is_none()) return GroundChoice::none;
  constexpr const char* wanted = "'auto', None or a height";
  if (!py::isinstance<py::str>(given)) return cast_named<double>(given, "ground", wanted);
  if (!given.equal(py::str("auto"))) refuse("ground", "other text", wanted);
  return GroundChoice::automatic;
}

SceneOptions scene_options_of(const py::dict& options) {
  SceneOptions scene;
  scene.from = vector_in(options, "camera_from");
  scene.at = vector_in(options, "camera_at");
  scene.up = vector_in(options, "camera_up");
  scene.fov_deg = optional_named<double>(options["fov_deg"], "fov_deg");
  scene.lights = lights_of(options["lights"]);
  scene.light_radius = light_radius_of(options["light_radius"]);
  scene.ground = ground_of(options["ground"]);
  scene.background = color_in(options, "background");
  scene.ambient = color_in(options, "ambient");
  scene.clear_glass = value_in<bool>(options, "clear_glass");
  return scene;
}

ReadOptions read_options_of(const py::dict& options) {
  ReadOptions read;
  const std::string style = value_in<std::string>(options, "style");
  if (style != "ball-and-stick" && style != "space-filling")
    throw py::value_error("style is '" + style + "'; give 'ball-and-stick' or 'space-filling'");
  if (style == "space-filling") read.style = MoleculeStyle::space_filling;
  read.waters = value_in<bool>(options, "waters");
  return read;
}

std::unique_ptr<DrawnScene> read_scene_of(const std::filesystem::path& path,
                                          const py::dict& options) {
  const ReadOptions read = read_options_of(options);
  const SceneOptions complete = scene_options_of(options);
  const py::gil_scoped_release unlocked;
  SceneFile file = find_scene(path.string(), read);
  auto drawn = std::make_unique<DrawnScene>();
  drawn->scene = complete_scene(std::move(file.scene), complete);
  drawn->warnings = std::move(file.warnings);
  return drawn;
}

Aov aov_of(const std::string& name) {
  constexpr std::pair<const char*, Aov> names[] = {{"class", Aov::light_class},
                                                   {"visibility", Aov::visibility},
                                                   {"depth", Aov::depth},
                                                   {"normal", Aov::normal},
                                                   {"samples", Aov::samples}};
  for (const auto& [known, aov] : names)
    if (name == known) return aov;
  throw py::value_error("there is no layer '" + name +
                        "'; there are class, visibility, depth, normal and samples");
}

std::shared_ptr<const Renderer> renderer_of(DrawnScene& drawn, Method method) {
  const std::lock_guard lock(drawn.mutex);
  if (!drawn.renderer || drawn.renderer->method() != method) {
    drawn.renderer.reset();  // two would need twice the memory
    drawn.renderer = std::make_shared<const Renderer>(drawn.scene, method);
  }
  return drawn.renderer;
}

/// Planes as one array (height, width, planes).
py::array_t<float> interleaved(const Image& image, std::size_t first, std::size_t count) {
  py::array_t<float> array({static_cast<py::ssize_t>(image.height),
                            static_cast<py::ssize_t>(image.width),
                            static_cast<py::ssize_t>(count)});
  float* to = array.mutable_data();
  const std::size_t pixels = std::size_t{image.width} * image.height;
  const py::gil_scoped_release unlocked;
  for (std::size_t k = 0; k < count; ++k)
    for (std::size_t i = 0; i < pixels; ++i)
      to[i * count + k] = image.channels[first + k].values[i];
  return array;
}

/// "color" and each layer by its name.
py::dict layers_of(const Image& image) {
  py::dict layers;
  const auto layer = [&image](std::size_t i) {
    const std::string& name = image.channels[i].name;
    return i < 3 ? std::string("color") : name.substr(0, name.find('.'));
  };
  for (std::size_t first = 0; first < image.channels.size();) {
    std::size_t end = first + 1;
    while (end < image.channels.size() && layer(end) == layer(first)) ++end;
    layers[py::str(layer(first))] = interleaved(image, first, end - first);
    first = end;
  }
  return layers;
}

struct Size {
  std::uint32_t width, height;
};

Size size_of(py::handle given, const Camera& camera) {
  if (given.is_none()) return {camera.width, camera.height};
  constexpr const char* wanted = "(width, height) in pixels";
  if (!py::isinstance<py::sequence>(given) || py::isinstance<py::str>(given))
    refuse_type(given, "size", wanted);
  const auto sides = py::reinterpret_borrow<py::sequence>(given);
  if (sides.size() != 2) refuse("size", "of " + std::to_string(sides.size()) + " numbers", wanted);
  const auto side = [&](std::size_t i) {
    return cast_named<std::uint32_t>(py::object(sides[i]), "size", wanted);
  };
  return {side(0), side(1)};
}

py::dict render_scene(DrawnScene& drawn, const py::dict& options) {
  const auto count = [&options](const char* name) {
    return value_in<std::uint32_t>(options, name);
  };
  const Size size = size_of(options["size"], *drawn.scene.camera);
  RenderOptions render{.shadow_samples = count("shadow_samples"),
                       .width = size.width,
                       .height = size.height,
                       .samples_per_pixel = count("samples_per_pixel"),
                       .depth = count("depth"),
                       .seed = value_in<std::uint64_t>(options, "seed"),
                       .threads = count("threads")};
  for (const py::handle name : options["layers"]) {
    const Aov aov = aov_of(cast_named<std::string>(name, "layers", "names of layers"));
    if (std::ranges::find(render.aovs, aov) == render.aovs.end()) render.aovs.push_back(aov);
  }
  check(render);
  const Method method = method_of(value_in<std::string>(options, "method"));
  Watch watch(options["progress"]);
  render.progress = [&watch](double share) {
    if (!watch.goes_on(share)) throw Cancelled();
  };
  const Picture picture = watch.run([&] { return renderer_of(drawn, method)->render(render); });
  return layers_of(picture.image);
}

py::dict camera_of(const DrawnScene& drawn) {
  const Camera& camera = *drawn.scene.camera;
  py::dict facts;
  facts["from"] = tuple_of(camera.from);
  facts["at"] = tuple_of(camera.at);
  facts["up"] = tuple_of(camera.up);
  facts["fov_deg"] =
      camera.parallel_height > 0 ? py::object(py::none()) : py::object(py::float_(camera.fov_deg));
  facts["size"] = py::make_tuple(camera.width, camera.height);
  return facts;
}

py::tuple tuple_of_box(const Box& box) {
  return py::make_tuple(tuple_of(box.lo), tuple_of(box.hi));
}

}  // namespace

void bind_scenes(py::module_& m) {
  py::class_<DrawnScene>(m, "Scene")
      .def("name", [](const DrawnScene& s) { return text_of(s.scene.name); })
      .def("warnings",
           [](const DrawnScene& s) {
             py::list texts;
             for (const std::string& warning : s.warnings) texts.append(text_of(warning));
             return texts;
           })
      .def("lights", [](const DrawnScene& s) { return s.scene.lights; })
      .def("up", [](const DrawnScene& s) { return tuple_of(s.scene.up); })
      .def("camera", &camera_of)
      .def("bounds", [](const DrawnScene& s) { return tuple_of_box(bounds(s.scene.shapes)); })
      .def("object_bounds",
           [](const DrawnScene& s) { return tuple_of_box(object_bounds(s.scene.shapes)); })
      .def("primitives", [](const DrawnScene& s) { return primitive_count(s.scene.shapes); })
      .def("occluders",
           [](const DrawnScene& s) {
             std::optional<Occluders> occluders;
             {
               const py::gil_scoped_release unlocked;
               occluders.emplace(occluders_of(s.scene));
             }
             return std::make_unique<KeptOccluders>(*std::move(occluders));
           })
      .def("render", &render_scene);
  m.def("read", &read_scene_of);
}

}  // namespace penumbra::python
