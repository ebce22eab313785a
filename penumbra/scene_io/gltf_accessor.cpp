// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/gltf_accessor.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include <fmt/format.h>

namespace penumbra {

namespace {

enum class Component { i8 = 5120, u8 = 5121, i16 = 5122, u16 = 5123, u32 = 5125, f32 = 5126 };

/// An array in some buffer view: element i begins at bytes[i * stride].
struct Elements {
  GltfView view;
  Component component = Component::f32;
  bool is_normalized = false;
  std::size_t count = 0, width = 1, stride = 0, offset = 0;
};

std::size_t size_of(Component component) {
  switch (component) {
    case Component::i8:
    case Component::u8: return 1;
    case Component::i16:
    case Component::u16: return 2;
    case Component::u32:
    case Component::f32: return 4;
  }
  return 0;
}

Component component_of(const GltfDocument& gltf, const Json& json) {
  const std::size_t code = index_of(gltf, json, "componentType").value_or(0);
  if (code < 5120 || code > 5126 || code == 5124)
    gltf.fail(fmt::format("component type {} is unknown", code));
  return static_cast<Component>(code);
}

std::size_t width_of(const GltfDocument& gltf, const Json& json) {
  const std::string type = string_of(gltf, json, "type");
  if (type == "SCALAR") return 1;
  if (type == "VEC2") return 2;
  if (type == "VEC3") return 3;
  if (type == "VEC4") return 4;
  gltf.fail(fmt::format("an accessor of type '{:.20}' is not read", type));
}

/// Throws unless all elements lie in the view.
void place(const GltfDocument& gltf, Elements& e, std::size_t view, std::size_t offset) {
  e.view = buffer_view(gltf, view);
  e.offset = offset;
  const std::size_t size = e.width * size_of(e.component);
  e.stride = e.view.stride == 0 ? size : e.view.stride;
  const std::size_t available = e.view.bytes.size();
  if (e.count == 0) return;
  if (offset > available || size > available - offset ||
      (e.count - 1) > (available - offset - size) / e.stride)
    gltf.fail(fmt::format("an accessor of {} elements is larger than its buffer view of {} bytes",
                          e.count, available),
              "is the file damaged or cut off?");
}

template <typename Number>
float component_at(const char* bytes, bool is_normalized) {
  Number value;  // glTF is little endian, as are all machines this is built for
  std::memcpy(&value, bytes, sizeof value);
  if constexpr (std::is_floating_point_v<Number>) return value;
  const auto number = static_cast<float>(value);
  if (!is_normalized) return number;
  return std::max(number / static_cast<float>(std::numeric_limits<Number>::max()), -1.0f);
}

float component_at(Component component, const char* bytes, bool is_normalized) {
  switch (component) {
    case Component::i8: return component_at<std::int8_t>(bytes, is_normalized);
    case Component::u8: return component_at<std::uint8_t>(bytes, is_normalized);
    case Component::i16: return component_at<std::int16_t>(bytes, is_normalized);
    case Component::u16: return component_at<std::uint16_t>(bytes, is_normalized);
    case Component::u32: return component_at<std::uint32_t>(bytes, is_normalized);
    case Component::f32: return component_at<float>(bytes, false);
  }
  return 0;
}

void read_element(const GltfDocument& gltf, const Elements& e, std::size_t i, float* row) {
  const std::size_t at = e.offset + i * e.stride;
  for (std::size_t c = 0; c < e.width; ++c) {
    const std::size_t byte = at + c * size_of(e.component);
    row[c] = component_at(e.component, e.view.bytes.data() + byte, e.is_normalized);
    if (std::isfinite(row[c])) continue;
    const GltfBuffer& buffer = gltf.buffers[e.view.buffer];
    throw Error({buffer.file, {}, buffer.offset_in_file + e.view.offset + byte},
                "a number that is not finite", "export the file again");
  }
}

std::uint32_t index_at(const GltfDocument& gltf, const Elements& e, std::size_t i) {
  const char* bytes = e.view.bytes.data() + e.offset + i * e.stride;
  switch (e.component) {
    case Component::u8: return static_cast<unsigned char>(*bytes);
    case Component::u16: {
      std::uint16_t value;
      std::memcpy(&value, bytes, sizeof value);
      return value;
    }
    case Component::u32: {
      std::uint32_t value;
      std::memcpy(&value, bytes, sizeof value);
      return value;
    }
    case Component::i8:
    case Component::i16:
    case Component::f32: break;
  }
  gltf.fail("indices that are not unsigned whole numbers");
}

void spend(GltfDocument& gltf, std::size_t count, std::size_t width) {
  if (count > gltf.numbers_left / width)
    gltf.fail("its meshes read far more numbers than there are in the file",
              "let primitives share arrays less often, or split the scene");
  gltf.numbers_left -= count * width;
}

void apply_sparse(const GltfDocument& gltf, const Json& sparse, const Elements& base,
                  GltfRows& rows) {
  const Json* where = member(sparse, "indices");
  const Json* what = member(sparse, "values");
  if (!where || !what) gltf.fail("a sparse accessor without indices or values");
  Elements places, values = base;
  places.component = component_of(gltf, *where);
  places.count = values.count = index_of(gltf, sparse, "count").value_or(0);
  const auto view_of = [&](const Json& json) {
    return index_of(gltf, json, "bufferView").value_or(std::numeric_limits<std::size_t>::max());
  };
  place(gltf, places, view_of(*where), index_of(gltf, *where, "byteOffset").value_or(0));
  place(gltf, values, view_of(*what), index_of(gltf, *what, "byteOffset").value_or(0));
  for (std::size_t i = 0; i < places.count; ++i) {
    const std::uint32_t row = index_at(gltf, places, i);
    if (row >= rows.count()) gltf.fail("a sparse accessor's index is out of range");
    read_element(gltf, values, i, rows.values.data() + row * rows.width);
  }
}

}  // namespace

GltfRows read_rows(GltfDocument& gltf, std::size_t accessor) {
  const Json& json = element(gltf, "accessors", accessor);
  Elements e;
  e.component = component_of(gltf, json);
  e.width = width_of(gltf, json);
  e.count = index_of(gltf, json, "count").value_or(0);
  const Json* normalized = member(json, "normalized");
  e.is_normalized = normalized && *normalized == true;
  const auto view = index_of(gltf, json, "bufferView");
  const Json* sparse = member(json, "sparse");
  if (view) {
    place(gltf, e, *view, index_of(gltf, json, "byteOffset").value_or(0));
  } else if (e.count > gltf.source.bytes.size() + (std::size_t{1} << 20)) {
    // Zeros need no bytes in the file, so nothing else bounds their number.
    gltf.fail(fmt::format("an accessor of {} elements without a buffer view", e.count));
  }
  spend(gltf, e.count, e.width);
  GltfRows rows{e.width, std::vector<float>(e.count * e.width)};
  if (view)
    for (std::size_t i = 0; i < e.count; ++i)
      read_element(gltf, e, i, rows.values.data() + i * e.width);
  if (sparse) apply_sparse(gltf, *sparse, e, rows);
  return rows;
}

std::vector<std::uint32_t> read_indices(GltfDocument& gltf, std::size_t accessor) {
  const Json& json = element(gltf, "accessors", accessor);
  const auto view = index_of(gltf, json, "bufferView");
  if (!view || member(json, "sparse")) gltf.fail("indices without a buffer view are not read");
  Elements e;
  e.component = component_of(gltf, json);
  e.count = index_of(gltf, json, "count").value_or(0);
  place(gltf, e, *view, index_of(gltf, json, "byteOffset").value_or(0));
  spend(gltf, e.count, 1);
  std::vector<std::uint32_t> indices(e.count);
  for (std::size_t i = 0; i < e.count; ++i) indices[i] = index_at(gltf, e, i);
  return indices;
}

}  // namespace penumbra
