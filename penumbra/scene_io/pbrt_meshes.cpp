// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "penumbra/scene_io/numbers.h"
#include "penumbra/scene_io/pbrt_shapes.h"
#include "penumbra/scene_io/texture_io.h"

namespace penumbra {
namespace {

/// Positions, and what the file gives for each of them.
Mesh read_vertices(PbrtScene& pbrt, const PbrtParams& params) {
  Mesh mesh;
  mesh.positions = params.points("P");
  mesh.normals = params.points("N");
  mesh.uvs = params.pairs(params.has("uv") ? "uv" : "st");
  if (mesh.positions.empty())
    throw Error(params.place(), "a mesh without vertices", "give it \"point3 P\"");
  // As pbrt does.
  const auto check = [&](auto& values, const char* what) {
    if (values.empty() || values.size() == mesh.positions.size()) return;
    values.clear();
    pbrt.warnings.add(fmt::format("{} that are not one a vertex are left out", what),
                      params.place());
  };
  check(mesh.normals, "normals");
  check(mesh.uvs, "texture coordinates");
  return mesh;
}

/// `group` vertices a face; where the file has no list, the only face is all vertices.
std::vector<std::uint32_t> read_indices(const PbrtParams& params, std::size_t vertices,
                                        std::size_t group) {
  std::vector<std::uint32_t> indices = params.indices("indices", vertices);
  if (!params.has("indices")) {
    if (vertices != group)
      throw Error(params.place(), "a mesh without a list of vertices",
                  "give it \"integer indices\"");
    for (std::uint32_t i = 0; i < group; ++i) indices.push_back(i);
  }
  if (indices.size() % group != 0)
    throw Error(params.place(), fmt::format("{} indices do not come in {}s", indices.size(), group),
                "the list may be cut off");
  return indices;
}

Mesh read_triangles(PbrtScene& pbrt, const PbrtParams& params) {
  Mesh mesh = read_vertices(pbrt, params);
  const std::vector<std::uint32_t> indices = read_indices(params, mesh.positions.size(), 3);
  for (std::size_t i = 0; i < indices.size(); i += 3)
    mesh.triangles.push_back({indices[i], indices[i + 1], indices[i + 2]});
  return mesh;
}

/// Four corners of a bilinear patch, (u, v) = (0, 0), (1, 0), (0, 1), (1, 1).
struct Patch {
  std::array<Vec3d, 4> p;

  Vec3d at(double u, double v) const {
    return (p[0] * (1 - u) + p[1] * u) * (1 - v) + (p[2] * (1 - u) + p[3] * u) * v;
  }
  Vec3d normal(double u, double v) const {
    return normalize(cross((p[1] - p[0]) * (1 - v) + (p[3] - p[2]) * v,
                           (p[2] - p[0]) * (1 - u) + (p[3] - p[1]) * u));
  }
  bool is_flat() const {
    const Vec3d a = p[1] - p[0], b = p[2] - p[0], c = p[3] - p[0];
    const double size = std::max({length(a), length(b), length(c)});
    return std::abs(dot(normalize(cross(a, b)), c)) <= 1e-5 * size;
  }
};

/// A patch that is not flat, as a grid; returns how many vertices it took.
void add_grid(Mesh& mesh, const Patch& patch, const std::array<Vec2f, 4>& uv, std::uint32_t steps) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (std::uint32_t j = 0; j <= steps; ++j)
    for (std::uint32_t i = 0; i <= steps; ++i) {
      const double u = double(i) / steps, v = double(j) / steps;
      const auto mixed = [&](float a, float b, float c, float d) {
        return static_cast<float>((double(a) * (1 - u) + double(b) * u) * (1 - v) +
                                  (double(c) * (1 - u) + double(d) * u) * v);
      };
      mesh.positions.push_back(Vec3f(patch.at(u, v)));
      mesh.normals.push_back(Vec3f(patch.normal(u, v)));
      mesh.uvs.push_back(
          {mixed(uv[0].u, uv[1].u, uv[2].u, uv[3].u), mixed(uv[0].v, uv[1].v, uv[2].v, uv[3].v)});
    }
  for (std::uint32_t j = 0; j < steps; ++j)
    for (std::uint32_t i = 0; i < steps; ++i) {
      const std::uint32_t a = first + j * (steps + 1) + i, b = a + 1, c = a + steps + 1, d = c + 1;
      mesh.triangles.push_back({a, b, d});
      mesh.triangles.push_back({a, d, c});
    }
}

}  // namespace

void add_pbrt_triangles(PbrtScene& pbrt, const PbrtParams& params) {
  add_pbrt_mesh(pbrt, read_triangles(pbrt, params), PbrtMeshOrigin::file, params.place());
}

void add_pbrt_loop(PbrtScene& pbrt, const PbrtParams& params) {
  Mesh mesh = read_triangles(pbrt, params);
  params.has("levels");
  params.has("scheme");
  pbrt.warnings.add("a loopsubdiv surface is drawn as its base mesh, not divided", params.place());
  if (mesh.normals.empty()) add_smooth_normals(mesh, std::numbers::pi_v<float>);
  add_pbrt_mesh(pbrt, std::move(mesh), PbrtMeshOrigin::file, params.place());
}

void add_pbrt_ply(PbrtScene& pbrt, const PbrtParams& params) {
  const PbrtParameter* file = params.find("filename");
  const std::string name = params.text("filename", "");
  const PbrtPlace place = file ? file->place : params.place();
  const auto path = find_beside(pbrt.source.path, name);
  if (!path)
    throw Error(place, "there is no mesh file " + in_quotes(name),
                "put it beside the scene's main file");
  Warnings warnings(path->string());
  Scene ply = read_ply(load(*path), warnings);
  for (const std::string& line : warnings.lines()) pbrt.warnings.add(line, place);
  const bool is_repeated = !pbrt.mesh_files.insert(file_key(*path)).second;
  for (Mesh& mesh : ply.shapes.meshes) {
    const std::size_t cost = mesh.positions.size() + mesh.triangles.size();
    if (is_repeated && cost > pbrt.repeated_left)
      throw Error(place, "the same mesh files are read again and again",
                  "use ObjectBegin and ObjectInstance");
    if (is_repeated) pbrt.repeated_left -= cost;
    mesh.colors.clear();  // pbrt does not know them
    add_pbrt_mesh(pbrt, std::move(mesh), PbrtMeshOrigin::file, place);
  }
}

void add_pbrt_patches(PbrtScene& pbrt, const PbrtParams& params) {
  constexpr std::uint32_t grid_steps = 8;
  const Mesh corners = read_vertices(pbrt, params);
  const std::vector<std::uint32_t> indices = read_indices(params, corners.positions.size(), 4);
  if (params.has("emissionfilename"))
    pbrt.warnings.add("a glowing bilinear mesh's picture is not read", params.place());
  Mesh flat = corners, curved;
  for (std::size_t i = 0; i < indices.size(); i += 4) {
    const std::array<std::uint32_t, 4> at{indices[i], indices[i + 1], indices[i + 2],
                                          indices[i + 3]};
    Patch patch;
    std::array<Vec2f, 4> uv{{{0, 0}, {1, 0}, {0, 1}, {1, 1}}};
    for (std::size_t k = 0; k < 4; ++k) {
      patch.p[k] = Vec3d(corners.positions[at[k]]);
      if (!corners.uvs.empty()) uv[k] = corners.uvs[at[k]];
    }
    if (patch.is_flat()) {
      flat.triangles.push_back({at[0], at[1], at[3]});
      flat.triangles.push_back({at[0], at[3], at[2]});
    } else {
      if (curved.triangles.size() > pbrt.made_left)
        throw Error(params.place(), "more patches than fit into memory", "split the scene");
      add_grid(curved, patch, uv, grid_steps);
    }
  }
  if (corners.uvs.empty() && indices.size() == 4 && corners.positions.size() == 4) {
    flat.uvs.resize(4);
    constexpr Vec2f square[] = {{0, 0}, {1, 0}, {0, 1}, {1, 1}};
    for (std::size_t k = 0; k < 4; ++k) flat.uvs[indices[k]] = square[k];
  }
  const std::size_t flat_patches = flat.triangles.size() / 2,
                    curved_patches = curved.triangles.size() / (2 * grid_steps * grid_steps);
  if (flat_patches > 0)
    add_pbrt_mesh(pbrt, std::move(flat), PbrtMeshOrigin::file, params.place(), flat_patches);
  if (curved_patches > 0)
    add_pbrt_mesh(pbrt, std::move(curved), PbrtMeshOrigin::made, params.place(), curved_patches);
}

}  // namespace penumbra
