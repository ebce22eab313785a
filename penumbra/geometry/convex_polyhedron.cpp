// SPDX-License-Identifier: MIT
#include "penumbra/geometry/convex_polyhedron.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace penumbra {
namespace {

constexpr std::uint32_t no_face = 0xffffffffu;
constexpr double longest_for_its_width = 1e4;
constexpr double shortest_edge = 1e-8, same_place = 1e-10;  // of the size

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

/// An edge as one of its faces has it; the lower face first.
struct HalfEdge {
  std::uint32_t low, high;
  Vec3d at_low, at_high;  // where it starts, going round the lower, or the higher, face
};

std::vector<HalfEdge> half_edges(std::span<const Polygon> polygons) {
  std::vector<HalfEdge> halves;
  for (std::uint32_t i = 0; i < polygons.size(); ++i)
    for (std::size_t k = 0; k < polygons[i].size(); ++k) {
      const Corner& from = polygons[i][k];
      const Vec3d to = polygons[i][(k + 1) % polygons[i].size()].at;
      if (i < from.face)
        halves.push_back({i, from.face, from.at, to});
      else
        halves.push_back({from.face, i, to, from.at});
    }
  std::sort(halves.begin(), halves.end(), [](const HalfEdge& a, const HalfEdge& b) {
    return std::tie(a.low, a.high) < std::tie(b.low, b.high);
  });
  return halves;
}

/// False unless each edge is there twice, at one place and not too short.
bool add_edges(std::span<const HalfEdge> halves, ConvexPolyhedron& result) {
  const double shortest = shortest_edge * result.outer, same = same_place * result.outer;
  if (halves.size() % 2 == 1) return false;
  for (std::size_t i = 0; i < halves.size(); i += 2) {
    const HalfEdge &a = halves[i], &b = halves[i + 1];
    const bool is_repeated = i > 0 && halves[i - 1].low == a.low && halves[i - 1].high == a.high;
    if (is_repeated || a.low != b.low || a.high != b.high) return false;
    if (!(length(a.at_low - b.at_low) < same && length(a.at_high - b.at_high) < same)) return false;
    if (!(length(a.at_high - a.at_low) > shortest)) return false;
    result.edges.push_back({a.at_low, a.at_high, {a.low, a.high}});
  }
  return true;
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
  if (!add_edges(half_edges(polygons), result)) return {};
  drop_unused_faces(planes, result);
  if (result.is_empty()) return {};
  result.inner = result.faces.front().offset;
  for (const HalfSpace& face : result.faces) result.inner = std::min(result.inner, face.offset);
  if (!(result.outer < longest_for_its_width * result.inner)) return {};
  return result;
}

}  // namespace penumbra
