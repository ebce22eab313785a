// SPDX-License-Identifier: MIT
#include "penumbra/geometry/closed_surface.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "penumbra/geometry/hole_fill.h"
#include "penumbra/geometry/mesh_edges.h"

namespace penumbra {
namespace {

constexpr std::size_t most_fills = 512;
constexpr std::size_t fewest_triangles = 4;  // nothing smaller encloses anything

/// The shadow-casting triangles of all meshes over common vertices.
Mesh welded_casters(std::span<const Mesh> meshes, const std::vector<bool>& casts_no_shadow) {
  Mesh all;
  for (const Mesh& mesh : meshes) {
    const auto first = static_cast<std::uint32_t>(all.positions.size());
    all.positions.insert(all.positions.end(), mesh.positions.begin(), mesh.positions.end());
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      const std::uint32_t surface = surface_of(mesh, i);
      if (surface < casts_no_shadow.size() && casts_no_shadow[surface]) continue;
      const Triangle t = mesh.triangles[i];
      all.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    }
  }
  const std::vector<std::uint32_t> welded = welded_vertices(all);
  std::size_t kept = 0;
  for (Triangle t : all.triangles) {
    for (std::uint32_t& corner : t) corner = welded[corner];
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) all.triangles[kept++] = t;
  }
  all.triangles.resize(kept);
  return all;
}

/// Triangles of one component, as indices into all.
using Component = std::vector<std::uint32_t>;

std::vector<Component> components(const Mesh& mesh, std::span<const detail::MeshEdge> edges) {
  detail::TriangleSets sets(mesh.triangles.size());
  for (std::size_t i = 1; i < edges.size(); ++i)
    if (edges[i].joins(edges[i - 1])) sets.join(edges[i].triangle, edges[i - 1].triangle);
  std::vector<Component> result;
  std::vector<std::uint32_t> number(mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::uint32_t root = sets.find(t);
    if (root == t) {
      number[t] = static_cast<std::uint32_t>(result.size());
      result.emplace_back();
    }
    number[t] = number[root];
    result[number[t]].push_back(t);
  }
  return result;
}

/// One of each group of equal triangles if all groups are even; else all triangles.
std::vector<Triangle> distinct_triangles(const Mesh& mesh, const Component& component) {
  std::vector<Triangle> all, sorted, one_each;
  for (const std::uint32_t t : component) {
    all.push_back(mesh.triangles[t]);
    sorted.push_back(mesh.triangles[t]);
    std::sort(sorted.back().begin(), sorted.back().end());
  }
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t i = 0; i < sorted.size();) {
    std::size_t end = i + 1;
    while (end < sorted.size() && sorted[end] == sorted[i]) ++end;
    if ((end - i) % 2 == 1) return all;
    one_each.push_back(sorted[i]);
    i = end;
  }
  return one_each;
}

using OddEdges = std::vector<std::array<std::uint32_t, 2>>;

/// Vertices are renumbered, so that a small component costs little.
OddEdges odd_edges(std::vector<Triangle> triangles, std::vector<Vec3f>& positions,
                   const Mesh& mesh) {
  std::vector<std::uint32_t> vertices;
  for (const Triangle& t : triangles) vertices.insert(vertices.end(), t.begin(), t.end());
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  for (Triangle& t : triangles)
    for (std::uint32_t& v : t)
      v = static_cast<std::uint32_t>(std::lower_bound(vertices.begin(), vertices.end(), v) -
                                     vertices.begin());
  for (const std::uint32_t v : vertices) positions.push_back(mesh.positions[v]);

  const std::vector<detail::MeshEdge> edges = detail::sorted_edges(triangles, vertices.size());
  OddEdges odd;
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t end = i + 1;
    while (end < edges.size() && edges[end].joins(edges[i])) ++end;
    if ((end - i) % 2 == 1) odd.push_back({edges[i].low, edges[i].high});
    i = end;
  }
  return odd;
}

/// Empty where it is of no use.
ClosedSurface closed(const Mesh& mesh, const Component& component) {
  ClosedSurface surface;
  if (component.size() < fewest_triangles) return surface;
  const std::vector<Triangle> triangles = distinct_triangles(mesh, component);
  std::vector<Vec3f> positions;
  const OddEdges odd = odd_edges(triangles, positions, mesh);
  if (odd.size() > most_fills || odd.size() > triangles.size()) return surface;
  if (!std::all_of(positions.begin(), positions.end(), is_finite<float>)) return surface;
  for (const Triangle& t : triangles)
    surface.triangles.push_back({mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]});
  surface.first_fill = surface.triangles.size();
  const std::vector<FlatTriangle> fills = hole_fills(odd, positions);
  surface.triangles.insert(surface.triangles.end(), fills.begin(), fills.end());
  surface.box = bounds(surface.triangles);
  return surface;
}

}  // namespace

std::vector<ClosedSurface> closed_surfaces(std::span<const Mesh> meshes,
                                           const std::vector<bool>& casts_no_shadow) {
  const Mesh mesh = welded_casters(meshes, casts_no_shadow);
  const std::vector<detail::MeshEdge> edges =
      detail::sorted_edges(mesh.triangles, mesh.positions.size());
  std::vector<ClosedSurface> surfaces;
  for (const Component& component : components(mesh, edges)) {
    surfaces.push_back(closed(mesh, component));
    if (surfaces.back().triangles.empty()) surfaces.pop_back();
  }
  return surfaces;
}

}  // namespace penumbra
