// SPDX-License-Identifier: MIT
#include "penumbra/geometry/triangle_neighbors.h"

#include "penumbra/geometry/mesh_edges.h"

namespace penumbra {

std::vector<std::array<std::uint32_t, 3>> triangle_neighbors(const Mesh& mesh) {
  const std::vector<detail::MeshEdge> edges = detail::welded_edges(mesh);
  std::vector<std::array<std::uint32_t, 3>> neighbors(mesh.triangles.size(),
                                                      {no_triangle, no_triangle, no_triangle});
  for (std::size_t first = 0, last = 0; first < edges.size(); first = last) {
    while (last < edges.size() && edges[last].joins(edges[first])) ++last;
    const detail::MeshEdge &a = edges[first], &b = edges[last - 1];
    if (last - first != 2 || a.low == a.high || a.triangle == b.triangle) continue;
    neighbors[a.triangle][a.corner] = b.triangle;
    neighbors[b.triangle][b.corner] = a.triangle;
  }
  return neighbors;
}

}  // namespace penumbra
