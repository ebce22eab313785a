// SPDX-License-Identifier: MIT
// Private to the layer: the edges of triangles side by side, and what they connect.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "penumbra/geometry/mesh.h"

namespace penumbra::detail {

struct MeshEdge {
  std::uint32_t low, high;  ///< vertices
  std::uint32_t triangle;
  std::uint32_t corner;  ///< of the triangle, from which the edge goes to the next
  bool joins(const MeshEdge& e) const { return low == e.low && high == e.high; }
};

/// Three a triangle, sorted by low, high and triangle. Vertices below vertex_count; those of one
/// place must be one (see `welded_vertices`). Cost: linear, unless many triangles share a vertex.
std::vector<MeshEdge> sorted_edges(std::span<const Triangle> triangles, std::size_t vertex_count);

/// Those of a mesh, given positions that are equal as one vertex.
std::vector<MeshEdge> welded_edges(const Mesh& mesh);

/// Disjoint sets of triangles; the smallest of a set stands for it.
class TriangleSets {
 public:
  explicit TriangleSets(std::size_t count);
  std::uint32_t find(std::uint32_t t);
  void join(std::uint32_t a, std::uint32_t b);

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace penumbra::detail
