// SPDX-License-Identifier: MIT
// Smooth normals, weighted by the angle of each triangle at the vertex: G. Thuermer, C. A.
// Wuethrich, Computing Vertex Normals from Polygonal Facets, Journal of Graphics Tools 1998.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <span>

#include "penumbra/geometry/mesh.h"

namespace penumbra {
namespace {

/// Corner k of triangle t is number 3 t + k.
using Corner = std::uint32_t;

struct CornerNormals {
  std::vector<Vec3d> face;     // a triangle
  std::vector<double> weight;  // a corner: the triangle's angle there
};

CornerNormals corner_normals(const Mesh& mesh) {
  CornerNormals result;
  for (const Triangle& triangle : mesh.triangles) {
    std::array<Vec3d, 3> p;
    for (int k = 0; k < 3; ++k) p[k] = Vec3d(mesh.positions[triangle[k]]);
    const Vec3d normal = cross(p[1] - p[0], p[2] - p[0]);
    result.face.push_back(normalize(normal));
    for (int k = 0; k < 3; ++k) {
      const Vec3d a = p[(k + 1) % 3] - p[k], b = p[(k + 2) % 3] - p[k];
      result.weight.push_back(std::atan2(length(normal), dot(a, b)));
    }
  }
  return result;
}

/// The corners at each welded vertex: those of vertex v are [start[v], start[v + 1]).
struct CornersByVertex {
  std::vector<std::uint32_t> start;
  std::vector<Corner> corners;
};

CornersByVertex corners_by_vertex(const Mesh& mesh, const std::vector<std::uint32_t>& welded) {
  CornersByVertex result;
  result.start.assign(mesh.positions.size() + 1, 0);
  for (const Triangle& triangle : mesh.triangles)
    for (std::uint32_t vertex : triangle) ++result.start[welded[vertex] + 1];
  std::partial_sum(result.start.begin(), result.start.end(), result.start.begin());
  std::vector<std::uint32_t> next(result.start.begin(), result.start.end() - 1);
  result.corners.resize(3 * mesh.triangles.size());
  for (Corner c = 0; c < result.corners.size(); ++c)
    result.corners[next[welded[mesh.triangles[c / 3][c % 3]]]++] = c;
  return result;
}

/// Splits the corners around one vertex into groups that are smooth, by walking over edges.
class SmoothGroups {
 public:
  SmoothGroups(std::span<const Triangle> triangles, std::span<const std::uint32_t> welded,
               const CornerNormals& normals, double crease_angle_rad)
      : triangles_(triangles), welded_(welded), normals_(normals) {
    crease_cos_ = crease_angle_rad >= std::numbers::pi ? -2 : std::cos(crease_angle_rad);
  }

  /// For each of the corners the position in `corners` of its group's first one.
  const std::vector<std::uint32_t>& find(std::span<const Corner> corners) {
    group_.resize(corners.size());
    std::iota(group_.begin(), group_.end(), 0u);
    spokes_.clear();
    for (std::uint32_t i = 0; i < corners.size(); ++i)
      for (int turn = 1; turn <= 2; ++turn) {
        const Corner c = corners[i];
        spokes_.push_back({welded_[triangles_[c / 3][(c % 3 + turn) % 3]], i});
      }
    std::sort(spokes_.begin(), spokes_.end());
    for (std::size_t begin = 0; begin < spokes_.size();) {
      std::size_t end = begin + 1;
      while (end < spokes_.size() && spokes_[end][0] == spokes_[begin][0]) ++end;
      join_over_edge(corners, begin, end);
      begin = end;
    }
    for (std::uint32_t i = 0; i < group_.size(); ++i) group_[i] = root(i);
    return group_;
  }

 private:
  /// More triangles than this at one edge are no surface: a crease, which also bounds the cost.
  static constexpr std::size_t most_at_an_edge = 16;

  void join_over_edge(std::span<const Corner> corners, std::size_t begin, std::size_t end) {
    if (end - begin > most_at_an_edge) return;
    for (std::size_t i = begin; i < end; ++i)
      for (std::size_t j = i + 1; j < end; ++j) {
        const std::uint32_t a = spokes_[i][1], b = spokes_[j][1];
        if (!(dot(normals_.face[corners[a] / 3], normals_.face[corners[b] / 3]) > crease_cos_))
          continue;
        const std::uint32_t root_a = root(a), root_b = root(b);
        group_[std::max(root_a, root_b)] = std::min(root_a, root_b);
      }
  }

  std::uint32_t root(std::uint32_t i) {
    while (group_[i] != i) i = group_[i] = group_[group_[i]];
    return i;
  }

  std::span<const Triangle> triangles_;
  std::span<const std::uint32_t> welded_;
  const CornerNormals& normals_;
  double crease_cos_;
  std::vector<std::uint32_t> group_;
  std::vector<std::array<std::uint32_t, 2>> spokes_;  // {vertex at the edge's other end, corner}
};

/// A copy of a vertex and everything it carries, at the end of the arrays.
std::uint32_t duplicate_vertex(Mesh& mesh, std::uint32_t vertex) {
  const auto repeat = [&](auto& values) {
    if (values.empty()) return;
    const auto value = values[vertex];
    values.push_back(value);
  };
  repeat(mesh.positions);
  repeat(mesh.normals);
  repeat(mesh.uvs);
  repeat(mesh.colors);
  repeat(mesh.lightmap_uvs);
  return static_cast<std::uint32_t>(mesh.positions.size() - 1);
}

}  // namespace

void add_smooth_normals(Mesh& mesh, float crease_angle_rad) {
  const std::vector<std::uint32_t> welded = welded_vertices(mesh);
  const CornerNormals normals = corner_normals(mesh);
  const CornersByVertex around = corners_by_vertex(mesh, welded);
  const std::vector<Triangle> old_triangles = mesh.triangles;
  const std::size_t old_vertices = mesh.positions.size();
  // Corners of one vertex and one group share it; the first group to come keeps the old one.
  constexpr Vec3f unused{0, 0, 1};
  mesh.normals.assign(old_vertices, unused);
  std::vector<bool> is_taken(old_vertices, false);
  SmoothGroups groups(old_triangles, welded, normals, crease_angle_rad);
  std::vector<Vec3d> sums;
  std::map<std::array<std::uint32_t, 2>, std::uint32_t> vertex_of;  // {old vertex, group}

  for (std::size_t v = 0; v < old_vertices; ++v) {
    const std::span<const Corner> corners(around.corners.data() + around.start[v],
                                          around.start[v + 1] - around.start[v]);
    const std::vector<std::uint32_t>& group = groups.find(corners);
    sums.assign(corners.size(), Vec3d{});
    for (std::size_t i = 0; i < corners.size(); ++i)
      sums[group[i]] += normals.face[corners[i] / 3] * normals.weight[corners[i]];
    vertex_of.clear();
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vec3d sum = normalize(sums[group[i]]);
      const Vec3f normal(sum == Vec3d{} ? normals.face[corners[i] / 3] : sum);
      std::uint32_t& corner = mesh.triangles[corners[i] / 3][corners[i] % 3];
      const auto [place, is_new] = vertex_of.try_emplace({corner, group[i]}, corner);
      if (is_new) {
        if (is_taken[corner])
          place->second = duplicate_vertex(mesh, corner);
        else
          is_taken[corner] = true;
        mesh.normals[place->second] = normal;
      }
      corner = place->second;
    }
  }
}

}  // namespace penumbra
