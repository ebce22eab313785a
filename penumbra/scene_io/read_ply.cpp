// SPDX-License-Identifier: MIT
// PLY: vertices with normals, colours and texture coordinates where it has them; faces and triangle
// strips. Properties may have any type and order; what is not known is skipped. The format does not
// say which way is up; scans, its home, mostly stand along y.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

#include "penumbra/scene/image.h"
#include "penumbra/scene_io/faces.h"
#include "penumbra/scene_io/numbers.h"
#include "penumbra/scene_io/ply.h"

namespace penumbra {
namespace {

/// What a vertex property means.
enum Role { x, y, z, normal_x, normal_y, normal_z, red, green, blue, u, v, roles };

struct RoleName {
  std::string_view name;
  Role role;
};

constexpr RoleName role_names[] = {{"x", x},
                                   {"y", y},
                                   {"z", z},
                                   {"nx", normal_x},
                                   {"ny", normal_y},
                                   {"nz", normal_z},
                                   {"normal_x", normal_x},
                                   {"normal_y", normal_y},
                                   {"normal_z", normal_z},
                                   {"red", red},
                                   {"green", green},
                                   {"blue", blue},
                                   {"r", red},
                                   {"g", green},
                                   {"b", blue},
                                   {"diffuse_red", red},
                                   {"diffuse_green", green},
                                   {"diffuse_blue", blue},
                                   {"u", u},
                                   {"v", v},
                                   {"s", u},
                                   {"t", v},
                                   {"texture_u", u},
                                   {"texture_v", v},
                                   {"texture_s", u},
                                   {"texture_t", v}};

/// The role of each property of the vertices, and which roles are filled.
struct Layout {
  std::vector<Role> role;
  std::array<bool, roles> has{};
  std::array<PlyType, roles> type{};

  bool has_all(Role first, int count) const {
    return std::all_of(has.begin() + first, has.begin() + first + count, [](bool b) { return b; });
  }
};

Layout layout_of(const PlyElement& vertices, const std::string& file) {
  Layout layout;
  for (const PlyProperty& property : vertices.properties) {
    Role role = roles;
    for (const RoleName& entry : role_names)
      if (entry.name == property.name && !property.count_type && !layout.has[entry.role])
        role = entry.role;
    layout.role.push_back(role);
    if (role == roles) continue;
    layout.has[role] = true;
    layout.type[role] = property.type;
  }
  if (!layout.has_all(x, 3))
    throw Error({file, vertices.line, {}}, "the vertices lack x, y or z", "give them all three");
  return layout;
}

/// Integers are display codes, floats are linear.
float linear_channel(double value, PlyType type) {
  if (!is_integer(type)) return value > 0 && std::isfinite(value) ? static_cast<float>(value) : 0;
  const int bits = static_cast<int>(8 * size_in_bytes(type));
  const bool is_signed = type == PlyType::int8 || type == PlyType::int16 || type == PlyType::int32;
  const double largest = std::ldexp(1.0, is_signed ? bits - 1 : bits) - 1;
  return linear_from_srgb(static_cast<float>(std::clamp(value / largest, 0.0, 1.0)));
}

void read_vertices(PlyBody& body, const PlyElement& element, const std::string& file, Mesh& mesh) {
  const Layout layout = layout_of(element, file);
  body.check_count(element);
  check_vertex_count({file, element.line, {}}, element.count);
  mesh.positions.reserve(element.count);
  const bool has_normals = layout.has_all(normal_x, 3), has_colors = layout.has_all(red, 3),
             has_uvs = layout.has_all(u, 2);
  if (has_normals) mesh.normals.reserve(element.count);
  if (has_colors) mesh.colors.reserve(element.count);
  if (has_uvs) mesh.uvs.reserve(element.count);
  std::array<double, roles> value{};
  for (std::uint64_t row = 0; row < element.count; ++row) {
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      const Role role = layout.role[i];
      if (role == roles) {
        body.skip_value(element.properties[i]);
        continue;
      }
      value[role] = body.real(element.properties[i].type);
      if (role <= z && !(std::abs(value[role]) <= std::numeric_limits<float>::max()))
        throw Error(body.place(),
                    "a coordinate of vertex " + std::to_string(row) + " is not finite",
                    "mend or remove the vertex");
    }
    mesh.positions.push_back(Vec3f(Vec3d(value[x], value[y], value[z])));
    if (has_normals)
      mesh.normals.push_back(Vec3f(Vec3d(value[normal_x], value[normal_y], value[normal_z])));
    if (has_colors)
      mesh.colors.push_back({linear_channel(value[red], layout.type[red]),
                             linear_channel(value[green], layout.type[green]),
                             linear_channel(value[blue], layout.type[blue])});
    if (has_uvs) mesh.uvs.push_back({static_cast<float>(value[u]), static_cast<float>(value[v])});
  }
}

/// Which property lists the corners: the one named so, else the only list of integers.
std::size_t corner_list(const PlyElement& element, const std::string& file) {
  std::size_t found = element.properties.size(), lists = 0;
  for (std::size_t i = 0; i < element.properties.size(); ++i) {
    const PlyProperty& property = element.properties[i];
    if (!property.count_type) continue;
    if (property.name.starts_with("vertex_ind")) return i;
    if (!is_integer(property.type)) continue;
    found = i;
    ++lists;
  }
  if (lists == 1) return found;
  throw Error({file, element.line, {}}, in_quotes(element.name) + " has no list of vertices",
              "name it vertex_indices");
}

class FaceReader {
 public:
  FaceReader(PlyBody& body, const PlyElement& element, const std::string& file, Mesh& mesh)
      : body_(body), element_(element), corners_at_(corner_list(element, file)), mesh_(mesh) {
    body.check_count(element);
  }

  void read_faces(Warnings& warnings) {
    // Once: a file may have any number of face elements.
    if (mesh_.triangles.empty()) mesh_.triangles.reserve(element_.count);
    for_each_row([&](std::size_t length) {
      corners_.clear();
      for (std::size_t i = 0; i < length; ++i) corners_.push_back(vertex(next()));
      if (length >= 3)
        append_face(mesh_, corners_);
      else
        warnings.add("a face of fewer than 3 corners is left out", body_.place().line.value_or(0));
    });
  }

  void read_strips() {
    for_each_row([&](std::size_t length) {
      std::uint32_t a = 0, b = 0;
      std::size_t in_strip = 0;
      for (std::size_t i = 0; i < length; ++i) {
        const std::int64_t index = next();
        if (index == -1 || index == std::numeric_limits<std::uint32_t>::max()) {
          in_strip = 0;
          continue;
        }
        const std::uint32_t c = vertex(index);
        const bool is_odd = in_strip % 2 == 1;
        // Corners that repeat only lead the strip elsewhere.
        if (in_strip >= 2 && a != b && b != c && a != c)
          mesh_.triangles.push_back(is_odd ? Triangle{b, a, c} : Triangle{a, b, c});
        a = b;
        b = c;
        ++in_strip;
      }
    });
  }

 private:
  template <std::invocable<std::size_t> ReadList>
  void for_each_row(ReadList read_list) {
    for (std::uint64_t row = 0; row < element_.count; ++row)
      for (std::size_t i = 0; i < element_.properties.size(); ++i) {
        const PlyProperty& property = element_.properties[i];
        if (i == corners_at_)
          read_list(body_.list_length(property));
        else
          body_.skip_value(property);
      }
  }

  std::int64_t next() { return body_.integer(element_.properties[corners_at_].type); }

  std::uint32_t vertex(std::int64_t index) const {
    if (index >= 0 && static_cast<std::uint64_t>(index) < mesh_.positions.size())
      return static_cast<std::uint32_t>(index);
    throw Error(body_.place(),
                "a face names vertex " + std::to_string(index) + ", but there are " +
                    std::to_string(mesh_.positions.size()),
                "number vertices from 0");
  }

  PlyBody& body_;
  const PlyElement& element_;
  std::size_t corners_at_;
  Mesh& mesh_;
  std::vector<std::uint32_t> corners_;
};

bool has_faces(const PlyElement& element) {
  return element.count > 0 && (element.name == "face" || element.name == "tristrips");
}

void read_corners(PlyBody& body, const PlyElement& element, const std::string& file, Mesh& mesh,
                  Warnings& warnings) {
  FaceReader reader(body, element, file, mesh);
  if (element.name == "face")
    reader.read_faces(warnings);
  else
    reader.read_strips();
}

/// Faces that stand before the vertices they name: read when those are known.
struct Postponed {
  PlyBody body;
  const PlyElement& element;
};

Mesh read_mesh(const Source& source, const PlyHeader& header, Warnings& warnings) {
  const std::string file = source.path.string();
  Mesh mesh;
  PlyBody body(source, header);
  bool has_vertices = false;
  std::vector<Postponed> postponed;
  for (const PlyElement& element : header.elements) {
    if (element.name == "vertex" && !has_vertices) {
      read_vertices(body, element, file, mesh);
      has_vertices = true;
    } else if (has_faces(element) && has_vertices) {
      read_corners(body, element, file, mesh, warnings);
    } else {
      if (has_faces(element)) postponed.push_back({body, element});
      body.skip(element);
    }
  }
  for (Postponed& p : postponed) read_corners(p.body, p.element, file, mesh, warnings);
  return mesh;
}

}  // namespace

Scene read_ply(const Source& source, Warnings& warnings) {
  const PlyHeader header = read_ply_header(source);
  Scene scene;
  scene.wants_ground = true;
  scene.up = header.up;
  Material material;
  Mesh mesh = read_mesh(source, header, warnings);
  if (mesh.triangles.empty())
    throw Error({source.path.string(), {}, {}},
                "has " + std::to_string(mesh.positions.size()) + " points, but no face",
                "points alone cannot be seen: make a surface of them");
  if (!mesh.colors.empty()) material.diffuse = {1, 1, 1};
  scene.materials.push_back(material);
  scene.shapes.meshes.push_back(std::move(mesh));
  return scene;
}

}  // namespace penumbra
