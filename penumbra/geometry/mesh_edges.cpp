// SPDX-License-Identifier: MIT
#include "penumbra/geometry/mesh_edges.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace penumbra::detail {

std::vector<MeshEdge> sorted_edges(std::span<const Triangle> triangles, std::size_t vertex_count) {
  // Counted into buckets by the lower vertex, which hold a handful each.
  std::vector<std::size_t> first(vertex_count + 1, 0);
  for (const Triangle& t : triangles)
    for (int k = 0; k < 3; ++k) ++first[std::min(t[k], t[(k + 1) % 3]) + 1];
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<MeshEdge> edges(3 * triangles.size());
  std::vector<std::size_t> next(first.begin(), first.end() - 1);
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t a = triangles[t][k], b = triangles[t][(k + 1) % 3];
      edges[next[std::min(a, b)]++] = {std::min(a, b), std::max(a, b), t, k};
    }
  const auto before = [](const MeshEdge& a, const MeshEdge& b) {
    return std::tie(a.high, a.triangle) < std::tie(b.high, b.triangle);
  };
  for (std::size_t v = 0; v < vertex_count; ++v)
    std::sort(edges.begin() + static_cast<std::ptrdiff_t>(first[v]),
              edges.begin() + static_cast<std::ptrdiff_t>(first[v + 1]), before);
  return edges;
}

std::vector<MeshEdge> welded_edges(const Mesh& mesh) {
  const std::vector<std::uint32_t> welded = welded_vertices(mesh);
  std::vector<Triangle> triangles = mesh.triangles;
  for (Triangle& triangle : triangles)
    for (std::uint32_t& vertex : triangle) vertex = welded[vertex];
  return sorted_edges(triangles, mesh.positions.size());
}

TriangleSets::TriangleSets(std::size_t count) : parent_(count) {
  std::iota(parent_.begin(), parent_.end(), 0u);
}

std::uint32_t TriangleSets::find(std::uint32_t t) {
  while (parent_[t] != t) t = parent_[t] = parent_[parent_[t]];
  return t;
}

void TriangleSets::join(std::uint32_t a, std::uint32_t b) {
  a = find(a), b = find(b);
  parent_[std::max(a, b)] = std::min(a, b);
}

}  // namespace penumbra::detail
