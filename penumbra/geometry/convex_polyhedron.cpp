// SPDX-License-Identifier: MIT
#include "penumbra/geometry/convex_polyhedron.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace penumbra {
namespace {

constexpr std::uint32_t no_face = 0xffffffffu;
constexpr double longest_for_its_width = 1e4;
constexpr double shortest_edge = 1e-12;

/// A corner of a face, and the other face along the edge that starts there.
struct Corner {
  Vec3d at;
  std::uint32_t face;
};
using Polygon = std::vector<Corner>;

Polygon square_on(const HalfSpace& plane, double half) {
  const Frame<double> frame = frame_around(plane.normal);
  const Vec3d middle = plane.normal * plane.offset, u = frame.u * half, v = frame.v * half;
  return {{middle + u + v, no_face},
          {middle - u + v, no_face},
          {middle - u - v, no_face},
          {middle + u - v, no_face}};
}

/// What of the polygon lies in a half-space (Sutherland, Hodgman 1974).
Polygon clipped(const Polygon& polygon, const HalfSpace& by, std::uint32_t face) {
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Corner &from = polygon[i], &to = polygon[(i + 1) % polygon.size()];
    const double a = dot(by.normal, from.at) - by.offset, b = dot(by.normal, to.at) - by.offset;
    if (a <= 0) kept.push_back(from);
    if ((a <= 0) == (b <= 0)) continue;
    const Vec3d between = from.at + (to.at - from.at) * (a / (a - b));
    kept.push_back({between, a <= 0 ? face : from.face});
  }
  return kept;
}

using Faces = std::pair<std::uint32_t, std::uint32_t>;  // the lower first

/// The polygon's edges, unless another face gave them already.
void add_edges(const Polygon& polygon, std::uint32_t face, double shortest,
               std::map<Faces, ConvexPolyhedron::Edge>& edges) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Corner &from = polygon[i], &to = polygon[(i + 1) % polygon.size()];
    if (!(length(to.at - from.at) > shortest)) continue;
    const Faces key = std::minmax(face, from.face);
    edges.try_emplace(key, ConvexPolyhedron::Edge{from.at, to.at, {key.first, key.second}});
  }
}

std::vector<Polygon> face_polygons(std::span<const HalfSpace> planes, double bound) {
  std::vector<Polygon> polygons;
  for (std::uint32_t i = 0; i < planes.size(); ++i) {
    polygons.push_back(square_on(planes[i], 4 * bound));
    for (std::uint32_t j = 0; j < planes.size() && !polygons.back().empty(); ++j)
      if (j != i) polygons.back() = clipped(polygons.back(), planes[j], j);
  }
  return polygons;
}

/// Numbers only the faces that an edge lies on.
void drop_unused_faces(std::span<const HalfSpace> planes, ConvexPolyhedron& result) {
  std::vector<std::uint32_t> number(planes.size(), no_face);
  for (const ConvexPolyhedron::Edge& edge : result.edges)
    for (const std::uint32_t face : edge.face) number[face] = 0;
  for (std::uint32_t i = 0; i < planes.size(); ++i) {
    if (number[i] == no_face) continue;
    number[i] = static_cast<std::uint32_t>(result.faces.size());
    result.faces.push_back(planes[i]);
  }
  for (ConvexPolyhedron::Edge& edge : result.edges)
    for (std::uint32_t& face : edge.face) face = number[face];
}

}  // namespace

bool ConvexPolyhedron::holds(Vec3d x) const {
  return !is_empty() && std::all_of(faces.begin(), faces.end(), [&](const HalfSpace& face) {
    return dot(face.normal, x) <= face.offset;
  });
}

ConvexPolyhedron intersection(std::span<const HalfSpace> planes, double bound) {
  for (const HalfSpace& plane : planes)
    if (!(plane.offset > 0)) return {};
  const std::vector<Polygon> polygons = face_polygons(planes, bound);
  ConvexPolyhedron result;
  for (const Polygon& polygon : polygons)
    for (const Corner& corner : polygon) {
      if (corner.face == no_face || !(max_abs(corner.at) < bound)) return {};
      result.outer = std::max(result.outer, length(corner.at));
    }
  std::map<Faces, ConvexPolyhedron::Edge> edges;
  for (std::uint32_t i = 0; i < planes.size(); ++i)
    add_edges(polygons[i], i, shortest_edge * result.outer, edges);
  for (const auto& [faces, edge] : edges) result.edges.push_back(edge);
  drop_unused_faces(planes, result);
  if (result.is_empty()) return {};
  result.inner = result.faces.front().offset;
  for (const HalfSpace& face : result.faces) result.inner = std::min(result.inner, face.offset);
  if (!(result.outer < longest_for_its_width * result.inner)) return {};
  return result;
}

}  // namespace penumbra
