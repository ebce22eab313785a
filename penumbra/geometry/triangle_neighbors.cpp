// SPDX-License-Identifier: MIT
#include "penumbra/geometry/triangle_neighbors.h"

#include "penumbra/geometry/mesh_edges.h"

namespace penumbra {
namespace {

/// Which edge of the triangle joins the two vertices.
std::size_t edge_between(const Triangle& triangle, std::uint32_t low, std::uint32_t high) {
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t a = triangle[k], b = triangle[(k + 1) % 3];
    if ((a == low && b == high) || (a == high && b == low)) return k;
  }
  return 0;
}

}  // namespace

std::vector<std::array<std::uint32_t, 3>> triangle_neighbors(const Mesh& mesh) {
  const std::vector<std::uint32_t> place = welded_vertices(mesh);
  std::vector<Triangle> welded = mesh.triangles;
  for (Triangle& triangle : welded)
    for (std::uint32_t& vertex : triangle) vertex = place[vertex];
  const std::vector<detail::MeshEdge> edges = detail::sorted_edges(welded, mesh.positions.size());
  std::vector<std::array<std::uint32_t, 3>> neighbors(welded.size(),
                                                      {no_triangle, no_triangle, no_triangle});
  for (std::size_t first = 0, last = 0; first < edges.size(); first = last) {
    while (last < edges.size() && edges[last].joins(edges[first])) ++last;
    const detail::MeshEdge &a = edges[first], &b = edges[last - 1];
    if (last - first != 2 || a.low == a.high || a.triangle == b.triangle) continue;
    neighbors[a.triangle][edge_between(welded[a.triangle], a.low, a.high)] = b.triangle;
    neighbors[b.triangle][edge_between(welded[b.triangle], a.low, a.high)] = a.triangle;
  }
  return neighbors;
}

}  // namespace penumbra
