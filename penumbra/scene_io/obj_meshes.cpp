// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <limits>
#include <numbers>
#include <span>
#include <string_view>

#include <fmt/format.h>

#include "penumbra/geometry/polygon.h"
#include "penumbra/scene_io/obj_data.h"

namespace penumbra {

namespace {

/// Where triangles of a smoothing group meet more sharply than this they are not smoothed: many
/// exporters put everything into one group.
constexpr float crease_angle_rad = std::numbers::pi_v<float> / 3;
constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

/// A mesh in the making. Corners become one vertex where position, uv and normal are the same; the
/// vertices of one position form a list that begins at first[position].
struct Part {
  std::vector<std::uint32_t> first;
  std::vector<std::uint32_t> next;
  std::vector<ObjCorner> vertices;
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> surfaces;
};

std::uint32_t vertex_of(Part& part, const ObjCorner& corner, std::size_t position_count) {
  if (part.first.empty()) part.first.assign(position_count, none);
  std::uint32_t& first = part.first[static_cast<std::size_t>(corner.position)];
  for (std::uint32_t v = first; v != none; v = part.next[v])
    if (part.vertices[v].uv == corner.uv && part.vertices[v].normal == corner.normal) return v;
  const auto vertex = static_cast<std::uint32_t>(part.vertices.size());
  part.vertices.push_back(corner);
  part.next.push_back(first);
  first = vertex;
  return vertex;
}

void require_below(std::int64_t index, std::size_t size, std::string_view what,
                   const std::string& file, std::size_t line) {
  if (index >= static_cast<std::int64_t>(size))
    throw Error({file, line, {}},
                fmt::format("the face uses {} {}, but there are {}", what, index + 1, size),
                "was the file cut off?");
}

/// Where the face belongs: 0 with normals, 1 smoothed, 2 flat.
std::size_t part_of(const ObjFace& face, std::span<const ObjCorner> corners) {
  const bool has_normals =
      std::all_of(corners.begin(), corners.end(), [](const auto& c) { return c.normal >= 0; });
  return has_normals ? 0 : face.is_smooth ? 1 : 2;
}

Mesh to_mesh(const Part& part, const ObjData& data, bool has_normals) {
  Mesh mesh;
  mesh.triangles = part.triangles;
  mesh.surfaces = part.surfaces;
  mesh.positions.reserve(part.vertices.size());
  const bool has_uvs = std::any_of(part.vertices.begin(), part.vertices.end(),
                                   [](const ObjCorner& c) { return c.uv >= 0; });
  for (const ObjCorner& c : part.vertices) {
    const auto position = static_cast<std::size_t>(c.position);
    mesh.positions.push_back(data.positions[position]);
    if (!data.colors.empty()) mesh.colors.push_back(data.colors[position]);
    if (has_uvs) mesh.uvs.push_back(c.uv < 0 ? Vec2f{} : data.uvs[static_cast<std::size_t>(c.uv)]);
    if (has_normals) mesh.normals.push_back(data.normals[static_cast<std::size_t>(c.normal)]);
  }
  return mesh;
}

}  // namespace

std::vector<Mesh> obj_meshes(const ObjData& data, const std::string& file) {
  std::array<Part, 3> parts;
  std::vector<Vec3f> polygon;
  for (const ObjFace& face : data.faces) {
    const std::span corners = std::span(data.corners).subspan(face.first_corner, face.corner_count);
    polygon.clear();
    for (const ObjCorner& c : corners) {
      require_below(c.position, data.positions.size(), "vertex", file, face.line);
      require_below(c.uv, data.uvs.size(), "texture coordinate", file, face.line);
      require_below(c.normal, data.normals.size(), "normal", file, face.line);
      polygon.push_back(data.positions[static_cast<std::size_t>(c.position)]);
    }
    const std::size_t where = part_of(face, corners);
    Part& part = parts[where];
    const auto vertex = [&](std::uint32_t i) {
      ObjCorner corner = corners[i];
      if (where != 0) corner.normal = -1;
      return vertex_of(part, corner, data.positions.size());
    };
    const auto add = [&](const Triangle& t) {
      part.triangles.push_back({vertex(t[0]), vertex(t[1]), vertex(t[2])});
      part.surfaces.push_back(face.material);
    };
    if (corners.size() == 3) {
      add({0, 1, 2});
    } else {
      for (const Triangle& t : triangulate(polygon)) add(t);
    }
  }
  std::vector<Mesh> meshes;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i].triangles.empty()) continue;
    meshes.push_back(to_mesh(parts[i], data, i == 0));
    if (i == 1) add_smooth_normals(meshes.back(), crease_angle_rad);
  }
  return meshes;
}

}  // namespace penumbra
