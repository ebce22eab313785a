// SPDX-License-Identifier: MIT
// Components and what is closed: edges are sorted, so that those of one place lie side by side.
#include <algorithm>
#include <numeric>
#include <tuple>

#include "penumbra/geometry/mesh.h"

namespace penumbra {
namespace {

struct Edge {
  std::uint32_t low, high;  // welded vertices
  std::uint32_t triangle;
  bool joins(const Edge& e) const { return low == e.low && high == e.high; }
};

std::vector<Edge> sorted_edges(const Mesh& mesh) {
  const std::vector<std::uint32_t> welded = welded_vertices(mesh);
  std::vector<Edge> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t a = welded[mesh.triangles[t][k]];
      const std::uint32_t b = welded[mesh.triangles[t][(k + 1) % 3]];
      edges.push_back({std::min(a, b), std::max(a, b), t});
    }
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
    return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
  });
  return edges;
}

/// Disjoint sets of triangles; the smallest of a set stands for it.
struct TriangleSets {
  std::vector<std::uint32_t> parent;

  explicit TriangleSets(std::size_t count) : parent(count) {
    std::iota(parent.begin(), parent.end(), 0u);
  }
  std::uint32_t find(std::uint32_t t) {
    while (parent[t] != t) t = parent[t] = parent[parent[t]];
    return t;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = find(a), b = find(b);
    parent[std::max(a, b)] = std::min(a, b);
  }
};

}  // namespace

MeshTopology topology(const Mesh& mesh) {
  const std::vector<Edge> edges = sorted_edges(mesh);
  TriangleSets sets(mesh.triangles.size());
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
