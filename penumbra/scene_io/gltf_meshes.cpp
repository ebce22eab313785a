// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/gltf_meshes.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <optional>

#include <fmt/format.h>

#include "penumbra/scene_io/gltf_accessor.h"
#include "penumbra/scene_io/gltf_extensions.h"

namespace penumbra {

namespace {

enum class Mode : std::size_t { triangles = 4, strip = 5, fan = 6 };

std::vector<Triangle> to_triangles(Mode mode, const std::vector<std::uint32_t>& indices) {
  std::vector<Triangle> triangles;
  const std::size_t n = indices.size();
  switch (mode) {
    case Mode::triangles:
      triangles.reserve(n / 3);
      for (std::size_t i = 2; i < n; i += 3)
        triangles.push_back({indices[i - 2], indices[i - 1], indices[i]});
      break;
    case Mode::strip:
      for (std::size_t i = 2; i < n; ++i)  // every other triangle runs the other way round
        triangles.push_back(
            {indices[i - 2], indices[i % 2 == 0 ? i - 1 : i], indices[i % 2 == 0 ? i : i - 1]});
      break;
    case Mode::fan:
      for (std::size_t i = 2; i < n; ++i)
        triangles.push_back({indices[0], indices[i - 1], indices[i]});
      break;
  }
  return triangles;
}

/// An attribute that must have at least `width` numbers for each of `count` vertices; nothing where
/// the primitive has none.
std::optional<GltfRows> attribute(GltfDocument& gltf, const Json& attributes,
                                  const std::string& name, std::size_t width, std::size_t count) {
  const auto accessor = index_of(gltf, attributes, name.c_str());
  if (!accessor) return std::nullopt;
  GltfRows rows = read_rows(gltf, *accessor);
  if (rows.count() != count || rows.width < width)
    gltf.fail(fmt::format("{} holds {} x {} numbers, for {} positions", name, rows.count(),
                          rows.width, count));
  return rows;
}

Vec3f vector_at(const GltfRows& rows, std::size_t i) {
  const float* row = rows.row(i);
  return {row[0], row[1], row[2]};
}

void read_vertices(GltfDocument& gltf, const Json& attributes, const GltfRows& positions,
                   const GltfUvUse& use, Mesh& mesh) {
  const std::size_t count = positions.count();
  for (std::size_t i = 0; i < count; ++i) mesh.positions.push_back(vector_at(positions, i));
  if (const auto rows = attribute(gltf, attributes, "NORMAL", 3, count))
    for (std::size_t i = 0; i < count; ++i) mesh.normals.push_back(vector_at(*rows, i));
  if (const auto rows = attribute(gltf, attributes, fmt::format("TEXCOORD_{}", use.set), 2, count))
    for (std::size_t i = 0; i < count; ++i)
      mesh.uvs.push_back(to_uv(use, rows->row(i)[0], rows->row(i)[1]));
  // A material's own map of coordinates is of its texture alone.
  const char* own = member(attributes, "TEXCOORD_1") ? "TEXCOORD_1"
                    : use.is_moved()                 ? "TEXCOORD_0"
                                                     : nullptr;
  if (const auto rows = own ? attribute(gltf, attributes, own, 2, count) : std::nullopt)
    for (std::size_t i = 0; i < count; ++i)
      mesh.lightmap_uvs.push_back(to_uv({}, rows->row(i)[0], rows->row(i)[1]));
  if (const auto rows = attribute(gltf, attributes, "COLOR_0", 3, count))
    for (std::size_t i = 0; i < count; ++i)
      mesh.colors.push_back(max(vector_at(*rows, i), Vec3f{}));
}

std::optional<Mesh> read_primitive(GltfDocument& gltf, const Json& json,
                                   const std::vector<GltfUvUse>& uv_uses, Warnings& warnings) {
  if (extension(json, "KHR_draco_mesh_compression"))
    refuse_compression(gltf, "KHR_draco_mesh_compression");
  const std::size_t mode = index_of(gltf, json, "mode").value_or(4);
  if (mode > 6) gltf.fail(fmt::format("a mesh primitive has the unknown mode {}", mode));
  if (mode < 4) {
    warnings.add("points and lines are not drawn");
    return std::nullopt;
  }
  const Json* attributes = member(json, "attributes");
  const auto position = attributes ? index_of(gltf, *attributes, "POSITION") : std::nullopt;
  if (!position) {
    warnings.add("a mesh primitive without positions is not drawn");
    return std::nullopt;
  }
  if (member(json, "targets")) warnings.add("morph targets are not read");

  Mesh mesh;
  mesh.surface = static_cast<std::uint32_t>(
      std::min(index_of(gltf, json, "material").value_or(uv_uses.size() - 1), uv_uses.size()));
  if (mesh.surface == uv_uses.size()) gltf.fail("a mesh primitive's material does not exist");
  const GltfRows positions = read_rows(gltf, *position);
  if (positions.width != 3) gltf.fail("positions that are not three numbers each");
  read_vertices(gltf, *attributes, positions, uv_uses[mesh.surface], mesh);

  std::vector<std::uint32_t> indices;
  if (const auto accessor = index_of(gltf, json, "indices")) {
    indices = read_indices(gltf, *accessor);
    const auto bad = std::find_if(indices.begin(), indices.end(),
                                  [&](std::uint32_t i) { return i >= mesh.positions.size(); });
    if (bad != indices.end())
      gltf.fail(
          fmt::format("a triangle uses vertex {}, but there are {}", *bad, mesh.positions.size()),
          "is the file damaged?");
  } else {
    indices.resize(mesh.positions.size());
    std::iota(indices.begin(), indices.end(), 0u);
  }
  mesh.triangles = to_triangles(static_cast<Mode>(mode), indices);
  return mesh;
}

}  // namespace

std::vector<Mesh> read_meshes(GltfDocument& gltf, std::size_t mesh,
                              const std::vector<GltfUvUse>& uv_uses, Warnings& warnings) {
  const Json& json = element(gltf, "meshes", mesh);
  const Json* primitives = member(json, "primitives");
  if (!primitives || !primitives->is_array())
    gltf.fail(fmt::format("mesh {} has no list of primitives", mesh));
  std::string name = string_of(gltf, json, "name");
  if (name.empty()) name = fmt::format("mesh {}", mesh);
  std::vector<Mesh> meshes;
  for (const Json& primitive : *primitives)
    if (auto read = read_primitive(gltf, primitive, uv_uses, warnings))
      if (!read->triangles.empty()) meshes.push_back(std::move(*read)), meshes.back().name = name;
  return meshes;
}

}  // namespace penumbra
