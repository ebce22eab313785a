// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>

#include "penumbra/scene/image.h"
#include "penumbra/scene_io/ply.h"

namespace penumbra {
namespace {

static_assert(std::endian::native == std::endian::little, "values are written as they lie");

template <typename Value>
void append(std::string& out, Value value) {
  char bytes[sizeof value];
  std::memcpy(bytes, &value, sizeof value);
  out.append(bytes, sizeof value);
}

void append(std::string& out, Vec3f v) {
  append(out, v.x);
  append(out, v.y);
  append(out, v.z);
}

std::vector<const Mesh*> meshes_to_write(const Scene& scene) {
  std::vector<const Mesh*> objects, all;
  for (const Mesh& mesh : scene.shapes.meshes) {
    all.push_back(&mesh);
    if (!mesh.is_backdrop) objects.push_back(&mesh);
  }
  return objects.empty() ? all : objects;
}

struct Columns {
  bool normals = true, colors = true, uvs = true;
};

/// A column is written where every mesh has it.
Columns common_columns(const std::vector<const Mesh*>& meshes) {
  Columns columns;
  for (const Mesh* mesh : meshes) {
    columns.normals &= !mesh->normals.empty();
    columns.colors &= !mesh->colors.empty();
    columns.uvs &= !mesh->uvs.empty();
  }
  return columns;
}

std::string header_text(std::size_t vertices, std::size_t triangles, const Columns& columns,
                        Vec3f up) {
  std::string out = "ply\nformat binary_little_endian 1.0\ncomment written by penumbra\n";
  out += fmt::format("comment up {} {} {}\n", up.x, up.y, up.z);
  out += "element vertex " + std::to_string(vertices) + "\n";
  out += "property float x\nproperty float y\nproperty float z\n";
  if (columns.normals) out += "property float nx\nproperty float ny\nproperty float nz\n";
  if (columns.colors) out += "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  if (columns.uvs) out += "property float s\nproperty float t\n";
  out += "element face " + std::to_string(triangles) + "\n";
  return out + "property list uchar int vertex_indices\nend_header\n";
}

void append_vertices(std::string& out, const Mesh& mesh, const Columns& columns) {
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    append(out, mesh.positions[i]);
    if (columns.normals) append(out, mesh.normals[i]);
    if (columns.colors)
      for (int channel = 0; channel < 3; ++channel)
        append(out, srgb_from_linear(mesh.colors[i][channel]));
    if (columns.uvs) append(out, mesh.uvs[i].u), append(out, mesh.uvs[i].v);
  }
}

}  // namespace

std::string to_ply(const Scene& scene, const std::string& file) {
  const ShapeSet& shapes = scene.shapes;
  const std::size_t others = shapes.spheres.size() + shapes.cones.size() + shapes.rings.size();
  if (others > 0)
    throw Error({file, {}, {}},
                "PLY holds triangles only, and the scene has " + std::to_string(others) +
                    " spheres, cones and rings",
                "write .nff");
  const std::vector<const Mesh*> meshes = meshes_to_write(scene);
  const Columns columns = common_columns(meshes);
  std::size_t vertices = 0, triangles = 0;
  for (const Mesh* mesh : meshes) {
    vertices += mesh->positions.size();
    triangles += mesh->triangles.size();
  }
  if (triangles == 0) throw Error({file, {}, {}}, "the scene has no triangles", "write .nff");
  std::string out = header_text(vertices, triangles, columns, Vec3f(scene.up));
  for (const Mesh* mesh : meshes) append_vertices(out, *mesh, columns);
  std::uint32_t base = 0;
  for (const Mesh* mesh : meshes) {
    for (const Triangle& triangle : mesh->triangles) {
      append(out, std::uint8_t{3});
      for (const std::uint32_t corner : triangle) append(out, corner + base);
    }
    base += static_cast<std::uint32_t>(mesh->positions.size());
  }
  return out;
}

}  // namespace penumbra
