// SPDX-License-Identifier: MIT
// Indexed triangle meshes: data, cleaning, normals, and what is closed.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "penumbra/geometry/box.h"
#include "penumbra/geometry/vec.h"

namespace penumbra {

/// Three positions of a mesh, counter-clockwise seen from outside.
using Triangle = std::array<std::uint32_t, 3>;

/// Triangles over shared vertices. Every per-vertex array but `positions` is empty or as long as
/// it; indices are below positions.size() and positions are finite once `validate` has seen the
/// scene.
struct Mesh {
  std::vector<Vec3f> positions;     ///< world space, scene units
  std::vector<Vec3f> normals;       ///< unit, for shading only; empty: faceted
  std::vector<Vec2f> uvs;           ///< of the base colour texture
  std::vector<Vec3f> colors;        ///< linear RGB, multiplies the diffuse colour
  std::vector<Vec2f> lightmap_uvs;  ///< the file's second set, as it is: of textures made for it
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> surfaces;  ///< a surface a triangle; empty: all have `surface`
  std::uint32_t surface = 0;            ///< index of a material, not read by geometry or kernel
  bool is_backdrop = false;             ///< a floor or wall: not part of the objects' extent
  /// Of the object in the file; neighbours with one name are its parts. Empty: an object of its
  /// own.
  std::string name{};
};

/// Surface of one triangle.
inline std::uint32_t surface_of(const Mesh& mesh, std::size_t triangle) {
  return mesh.surfaces.empty() ? mesh.surface : mesh.surfaces[triangle];
}

// The functions below need indices below positions.size(); positions may be anything.

/// Whether two corners are equal (by index or position), or all lie on one line to double
/// precision.
bool is_degenerate(const Mesh& mesh, const Triangle& triangle);

/// Drops triangles that are. Vertices stay. Returns how many went. Cost: linear.
std::size_t drop_degenerate_triangles(Mesh& mesh);

/// Normals averaged over the triangles around each position, weighted by angle (Thuermer &
/// Wuethrich 1998), where adjacent triangles meet at less than `crease_angle_rad`; vertices are
/// split at creases and equal positions count as one vertex. Edges of more than 16 triangles are
/// creases. Replaces `normals`; vertices that no triangle uses get some unit vector.
/// Cost: O(n log n).
void add_smooth_normals(Mesh& mesh, float crease_angle_rad);

/// For each vertex the first vertex at the same position: itself, or one before it.
/// Cost: O(n log n).
std::vector<std::uint32_t> welded_vertices(const Mesh& mesh);

/// Which triangles enclose a volume. Positions that are equal count as one.
struct MeshTopology {
  std::vector<std::uint32_t> component;  ///< connected component of each triangle, by shared edges
  std::vector<bool>
      is_closed;  ///< a component: every edge is shared by an even number of triangles
  std::size_t boundary_edges = 0;     ///< edges of one triangle
  std::size_t nonmanifold_edges = 0;  ///< edges of three or more
};

/// Cost: O(n log n). Triangles must be free of degenerate ones.
MeshTopology topology(const Mesh& mesh);

/// Of all triangles together.
double area(const Mesh& mesh);

/// Smallest box of all corners that triangles use.
Box bounds(const Mesh& mesh);

}  // namespace penumbra
