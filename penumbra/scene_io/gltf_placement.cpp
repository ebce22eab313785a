// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/gltf_placement.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <optional>

#include "penumbra/scene_io/gltf_accessor.h"

namespace penumbra {
namespace {

Transform from_matrix(const std::vector<double>& m) {
  return {{m[0], m[1], m[2]}, {m[4], m[5], m[6]}, {m[8], m[9], m[10]}, {m[12], m[13], m[14]}};
}

using Quaternion = std::array<double, 4>;

Transform from_parts(Vec3d t, const Quaternion& q, Vec3d s) {
  const double norm = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
  const double k = norm > 0 && std::isfinite(norm) ? 2 / norm : 0;
  const double x = q[0], y = q[1], z = q[2], w = q[3];
  const Vec3d ax{1 - k * (y * y + z * z), k * (x * y + z * w), k * (x * z - y * w)};
  const Vec3d ay{k * (x * y - z * w), 1 - k * (x * x + z * z), k * (y * z + x * w)};
  const Vec3d az{k * (x * z + y * w), k * (y * z - x * w), 1 - k * (x * x + y * y)};
  return {ax * s.x, ay * s.y, az * s.z, t};
}

/// An attribute of copies, all of one length.
std::optional<GltfRows> rows_of(GltfDocument& gltf, const Json& attributes, const char* name,
                                std::size_t width, std::optional<std::size_t>& count) {
  const auto accessor = index_of(gltf, attributes, name);
  if (!accessor) return std::nullopt;
  GltfRows rows = read_rows(gltf, *accessor);
  if (rows.width != width || rows.count() != count.value_or(rows.count()))
    gltf.fail(fmt::format("{} of a node's copies (EXT_mesh_gpu_instancing) holds {} x {} numbers",
                          name, rows.count(), rows.width));
  count = rows.count();
  return rows;
}

Vec3d vector_at(const std::optional<GltfRows>& rows, std::size_t i, Vec3d otherwise) {
  if (!rows) return otherwise;
  const float* row = rows->row(i);
  return Vec3d(Vec3f{row[0], row[1], row[2]});
}

}  // namespace

Transform transform_of(const GltfDocument& gltf, const Json& node) {
  if (const auto matrix = numbers_of(gltf, node, "matrix", 16)) return from_matrix(*matrix);
  const auto vector_of = [&](const char* key, Vec3d otherwise) {
    const auto numbers = numbers_of(gltf, node, key, 3);
    return numbers ? Vec3d{(*numbers)[0], (*numbers)[1], (*numbers)[2]} : otherwise;
  };
  const auto q = numbers_of(gltf, node, "rotation", 4).value_or(std::vector{0.0, 0.0, 0.0, 1.0});
  return from_parts(vector_of("translation", {}), {q[0], q[1], q[2], q[3]},
                    vector_of("scale", {1, 1, 1}));
}

std::vector<Transform> copies_of(GltfDocument& gltf, const Json& node) {
  const Json* instancing = extension(node, "EXT_mesh_gpu_instancing");
  const Json* attributes = instancing ? member(*instancing, "attributes") : nullptr;
  if (!attributes) return {Transform{}};
  std::optional<std::size_t> count;
  const auto moves = rows_of(gltf, *attributes, "TRANSLATION", 3, count);
  const auto turns = rows_of(gltf, *attributes, "ROTATION", 4, count);
  const auto scales = rows_of(gltf, *attributes, "SCALE", 3, count);
  if (!count) return {Transform{}};
  std::vector<Transform> copies;
  copies.reserve(*count);
  for (std::size_t i = 0; i < *count; ++i) {
    Quaternion q{0, 0, 0, 1};
    if (turns)
      for (std::size_t k = 0; k < 4; ++k) q[k] = static_cast<double>(turns->row(i)[k]);
    copies.push_back(from_parts(vector_at(moves, i, {}), q, vector_at(scales, i, {1, 1, 1})));
  }
  return copies;
}

}  // namespace penumbra
