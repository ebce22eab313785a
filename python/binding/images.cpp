// SPDX-License-Identifier: MIT
// Pictures as arrays: to codes, and to files.
#include <pybind11/numpy.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "arrays.h"
#include "penumbra/scene/image.h"
#include "penumbra/scene_io/image_io.h"
#include "scenes.h"

namespace penumbra::python {
namespace {

using Floats = py::array_t<float, py::array::c_style | py::array::forcecast>;

Floats floats_of(py::handle object, const char* name) {
  refuse_mask(object, name);
  Floats array = Floats::ensure(py::reinterpret_borrow<py::object>(object));
  if (!array) throw py::value_error(std::string(name) + " is no array of numbers");
  return array;
}

py::array_t<std::uint8_t> to_srgb(py::object linear, float exposure) {
  const Floats from = floats_of(linear, "image");
  py::array_t<std::uint8_t> codes(
      std::vector<py::ssize_t>(from.shape(), from.shape() + from.ndim()));
  const float* values = from.data();
  std::uint8_t* to = codes.mutable_data();
  const py::ssize_t count = from.size();
  const py::gil_scoped_release unlocked;
  const float scale = std::exp2(exposure);
  for (py::ssize_t i = 0; i < count; ++i) to[i] = srgb_from_linear(values[i] * scale);
  return codes;
}

/// Adds the planes of an array (height, width) or (height, width, names).
void add_planes(Image& image, const Floats& array, const std::vector<std::string>& names) {
  const std::size_t pixels = std::size_t{image.width} * image.height;
  for (std::size_t k = 0; k < names.size(); ++k) {
    Channel channel{names[k], std::vector<float>(pixels)};
    for (std::size_t i = 0; i < pixels; ++i) channel.values[i] = array.data()[i * names.size() + k];
    image.channels.push_back(std::move(channel));
  }
}

std::vector<std::string> names_of_layer(const std::string& name, std::size_t planes) {
  if (name == "normal" && planes == 3) return {"normal.X", "normal.Y", "normal.Z"};
  if (name == "depth" && planes == 1) return {"depth.Z"};
  if (name == "samples" && planes == 1) return {"samples.count"};
  std::vector<std::string> names;
  for (std::size_t i = 0; i < planes; ++i) names.push_back(name + ".light" + std::to_string(i));
  return names;
}

void write(const std::filesystem::path& path, py::object color, float exposure,
           const std::map<std::string, py::object>& layers) {
  const Floats colors = floats_of(color, "image");
  constexpr py::ssize_t largest_side = 65536;
  if (colors.ndim() != 3 || colors.shape(2) != 3 || colors.size() == 0 ||
      colors.shape(0) > largest_side || colors.shape(1) > largest_side)
    throw py::value_error("image must be an array of shape (height, width, 3), up to 65536 a side");
  Image image{static_cast<std::uint32_t>(colors.shape(1)),
              static_cast<std::uint32_t>(colors.shape(0)),
              {},
              {}};
  add_planes(image, colors, {"R", "G", "B"});
  for (const auto& [name, object] : layers) {
    const Floats layer = floats_of(object, name.c_str());
    if (layer.ndim() < 2 || layer.ndim() > 3 || layer.shape(0) != colors.shape(0) ||
        layer.shape(1) != colors.shape(1))
      throw py::value_error("layer '" + name + "' must have the image's height and width");
    const std::size_t planes = layer.ndim() == 2 ? 1 : static_cast<std::size_t>(layer.shape(2));
    add_planes(image, layer, names_of_layer(name, planes));
  }
  const py::gil_scoped_release unlocked;
  write_image(path, image, exposure);
}

}  // namespace

void bind_images(py::module_& m) {
  m.def("to_srgb", &to_srgb);
  m.def("write_image", &write);
}

}  // namespace penumbra::python
