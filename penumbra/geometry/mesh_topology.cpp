// SPDX-License-Identifier: MIT
// Components and what is closed: edges are sorted, so that those of one place lie side by side.
#include "penumbra/geometry/mesh.h"
#include "penumbra/geometry/mesh_edges.h"

namespace penumbra {

MeshTopology topology(const Mesh& mesh) {
  const std::vector<detail::MeshEdge> edges = detail::welded_edges(mesh);
  detail::TriangleSets sets(mesh.triangles.size());
  std::vector<std::uint32_t> with_odd_edge;
  MeshTopology result;
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t end = i + 1;
    for (; end < edges.size() && edges[end].joins(edges[i]); ++end)
      sets.join(edges[i].triangle, edges[end].triangle);
    const std::size_t sharing = end - i;
    if (sharing % 2 == 1) with_odd_edge.push_back(edges[i].triangle);
    if (sharing == 1) ++result.boundary_edges;
    if (sharing > 2) ++result.nonmanifold_edges;
    i = end;
  }

  result.component.resize(mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::uint32_t root = sets.find(t);
    if (root == t) {
      result.component[t] = static_cast<std::uint32_t>(result.is_closed.size());
      result.is_closed.push_back(true);
    } else {
      result.component[t] = result.component[root];
    }
  }
  for (std::uint32_t t : with_odd_edge) result.is_closed[result.component[t]] = false;
  return result;
}

}  // namespace penumbra
