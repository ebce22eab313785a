// SPDX-License-Identifier: MIT
#include "penumbra/scene/glowing_surface.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "penumbra/geometry/mesh_edges.h"
#include "penumbra/geometry/reduced_hull.h"
#include "penumbra/geometry/transform.h"

namespace penumbra {
namespace {

constexpr std::size_t most_triangles = 4'000'000;  ///< by placements

/// How triangles glow: red, green, blue, and 1 where from both sides.
using Glow = std::array<float, 4>;
using Glowing = std::map<Glow, std::vector<GlowingTriangle>>;

bool is_before(Vec3f a, Vec3f b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); }
bool comes_before(const GlowingTriangle& s, const GlowingTriangle& t) {
  return std::lexicographical_compare(s.begin(), s.end(), t.begin(), t.end(), is_before);
}

/// The same triangle, its first corner first; -0 is 0.
GlowingTriangle rotated(GlowingTriangle t) {
  for (Vec3f& p : t) p = p + Vec3f{0, 0, 0};
  std::rotate(t.begin(), std::min_element(t.begin(), t.end(), is_before), t.end());
  return t;
}

struct PositionHash {
  std::size_t operator()(Vec3f p) const {
    std::uint64_t h = 0;
    for (const float c : {p.x, p.y, p.z})
      h = (h ^ std::bit_cast<std::uint32_t>(c)) * 0x9E3779B97F4A7C15u, h ^= h >> 32;
    return h;
  }
};

using Numbers = std::unordered_map<Vec3f, std::uint32_t, PositionHash>;

void add_triangles(const Scene& scene, const Mesh& mesh, Glowing& glowing) {
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!mesh.surfaces.empty() && t >= mesh.surfaces.size()) break;
    const std::uint32_t surface = surface_of(mesh, t);
    if (surface >= scene.materials.size()) continue;
    const Material& material = scene.materials[surface];
    const Color c = material.emission;
    if (!(max_abs(c) > 0) || !is_finite(c) || std::min({c.x, c.y, c.z}) < 0) continue;
    const Triangle& corners = mesh.triangles[t];
    if (std::max({corners[0], corners[1], corners[2]}) >= mesh.positions.size()) continue;
    const GlowingTriangle triangle = rotated(
        {mesh.positions[corners[0]], mesh.positions[corners[1]], mesh.positions[corners[2]]});
    const double area = area_of(triangle);
    if (area > 0 && std::isfinite(area))
      glowing[{c.x, c.y, c.z, material.emits_from_back ? 1.0f : 0.0f}].push_back(triangle);
  }
}

/// In order, each once; of two-sided ones that differ in their turn alone one, too.
void clean(std::vector<GlowingTriangle>& triangles, bool is_two_sided) {
  std::sort(triangles.begin(), triangles.end(), comes_before);
  triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
  if (!is_two_sided) return;
  // (a, b, c) stays and (a, c, b) goes, where b is before c. Asked of all as they were: what is
  // being erased from is in no order.
  const std::vector<GlowingTriangle> all = triangles;
  std::erase_if(triangles, [&](const GlowingTriangle& t) {
    return is_before(t[2], t[1]) &&
           std::binary_search(all.begin(), all.end(), GlowingTriangle{t[0], t[2], t[1]},
                              comes_before);
  });
}

/// Sets is_closed and is_oriented.
void examine_edges(GlowingSurface& surface) {
  struct Edge {
    std::uint32_t low, high;
    int turn;  ///< 1 from low to high, -1 back
    bool operator<(const Edge& e) const { return std::tie(low, high) < std::tie(e.low, e.high); }
  };
  Numbers numbers;
  std::vector<Edge> edges;
  for (const GlowingTriangle& t : surface.triangles) {
    std::array<std::uint32_t, 3> corner;
    for (std::size_t i = 0; i < 3; ++i)
      corner[i] =
          numbers.try_emplace(t[i], static_cast<std::uint32_t>(numbers.size())).first->second;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = corner[i], b = corner[(i + 1) % 3];
      edges.push_back({std::min(a, b), std::max(a, b), a < b ? 1 : -1});
    }
  }
  std::sort(edges.begin(), edges.end());
  surface.is_closed = surface.is_oriented = true;
  for (std::size_t i = 0, end = 0; i < edges.size(); i = end) {
    int turns = 0;
    for (; end < edges.size() && !(edges[i] < edges[end]); ++end) turns += edges[end].turn;
    if ((end - i) % 2 != 0) surface.is_closed = false;
    if (turns != 0) surface.is_oriented = false;
  }
  surface.is_oriented = surface.is_oriented && surface.is_closed;
}

/// Connected sets, in the order of their first triangles.
void add_surfaces(const Glow& glow, std::vector<GlowingTriangle> kept,
                  std::vector<GlowingSurface>& surfaces) {
  const bool is_two_sided = glow[3] != 0;
  clean(kept, is_two_sided);
  Numbers first_at;
  detail::TriangleSets sets(kept.size());
  for (std::uint32_t i = 0; i < kept.size(); ++i)
    for (const Vec3f corner : kept[i]) {
      const auto [at, is_new] = first_at.try_emplace(corner, i);
      if (!is_new) sets.join(i, at->second);
    }
  std::unordered_map<std::uint32_t, std::size_t> of_root;
  for (std::uint32_t i = 0; i < kept.size(); ++i) {
    const auto [at, is_new] = of_root.try_emplace(sets.find(i), surfaces.size());
    if (is_new) surfaces.push_back({{}, {glow[0], glow[1], glow[2]}, is_two_sided, false, false});
    surfaces[at->second].triangles.push_back(kept[i]);
  }
}

std::vector<GlowingSurface> surfaces_of(const Scene& scene, const std::vector<Mesh>& meshes) {
  Glowing glowing;
  for (const Mesh& mesh : meshes) add_triangles(scene, mesh, glowing);
  std::vector<GlowingSurface> surfaces;
  for (auto& [glow, triangles] : glowing) add_surfaces(glow, std::move(triangles), surfaces);
  for (GlowingSurface& surface : surfaces) examine_edges(surface);
  return surfaces;
}

/// A few triangles in the place of all surfaces of a group, of the same power.
GlowingSurface simplified(std::span<const GlowingSurface> group) {
  constexpr std::size_t most_corners = 16;
  GlowingSurface simple;
  std::vector<Vec3f> points;
  Vec3d power;
  for (const GlowingSurface& surface : group)
    for (const GlowingTriangle& t : surface.triangles) {
      points.insert(points.end(), t.begin(), t.end());
      const double sides = surface.is_two_sided && !surface.is_closed ? 2 : 1;
      power += Vec3d(surface.radiance) * (sides * area_of(t));
    }
  if (const std::optional<MeshLight> hull = reduced_hull(points, most_corners)) {
    for (const Triangle& t : hull->triangles)
      simple.triangles.push_back(
          rotated({hull->corners[t[0]], hull->corners[t[1]], hull->corners[t[2]]}));
    simple.is_closed = simple.is_oriented = true;
    simple.radiance = Color(power / surface_area(*hull));
  } else {
    // Flat: its three most distant corners or so, from both sides.
    const std::vector<Vec3f> few = extreme_points(points, most_corners);
    for (std::size_t i = 2; i < few.size(); ++i)
      simple.triangles.push_back(rotated({few[0], few[i - 1], few[i]}));
    const double area = area_of(simple.triangles);
    simple.radiance = area > 0 ? Color(power / (2 * area)) : Color{};
  }
  clean(simple.triangles, true);
  return simple;
}

/// Nothing where the placement leaves no area.
void place(const GlowingSurface& surface, const Transform& placement,
           std::vector<GlowingSurface>& surfaces) {
  GlowingSurface placed = surface;
  placed.triangles.clear();
  const bool is_mirrored = determinant(placement) < 0;
  for (GlowingTriangle t : surface.triangles) {
    for (Vec3f& p : t) p = Vec3f(apply_point(placement, Vec3d(p)));
    if (is_mirrored) std::swap(t[1], t[2]);
    const double area = area_of(t);
    if (area > 0 && std::isfinite(area)) placed.triangles.push_back(rotated(t));
  }
  clean(placed.triangles, surface.is_two_sided);
  if (!placed.triangles.empty()) surfaces.push_back(std::move(placed));
}

void add_placed(const Scene& scene, std::vector<GlowingSurface>& surfaces) {
  std::vector<std::vector<GlowingSurface>> of_group;
  for (const ShapeSet& group : scene.shapes.groups)
    of_group.push_back(surfaces_of(scene, group.meshes));
  std::size_t triangles = 0;
  for (const Instance& instance : scene.shapes.instances)
    if (instance.group < of_group.size())
      for (const GlowingSurface& surface : of_group[instance.group])
        triangles += surface.triangles.size();
  if (triangles > most_triangles)
    for (std::vector<GlowingSurface>& group : of_group)
      if (!group.empty()) group = {simplified(group)};
  for (const Instance& instance : scene.shapes.instances)
    if (instance.group < of_group.size())
      for (const GlowingSurface& surface : of_group[instance.group])
        place(surface, instance.placement, surfaces);
}

}  // namespace

Vec3d normal_of(const GlowingTriangle& t) {
  return cross(Vec3d(t[1]) - Vec3d(t[0]), Vec3d(t[2]) - Vec3d(t[0]));
}

double area_of(const GlowingTriangle& t) { return 0.5 * length(normal_of(t)); }

double area_of(std::span<const GlowingTriangle> triangles) {
  double sum = 0;
  for (const GlowingTriangle& t : triangles) sum += area_of(t);
  return sum;
}

std::vector<GlowingSurface> glowing_surfaces(const Scene& scene) {
  std::vector<GlowingSurface> surfaces = surfaces_of(scene, scene.shapes.meshes);
  add_placed(scene, surfaces);
  std::sort(surfaces.begin(), surfaces.end(), [](const GlowingSurface& a, const GlowingSurface& b) {
    if (a.triangles != b.triangles)
      return std::lexicographical_compare(a.triangles.begin(), a.triangles.end(),
                                          b.triangles.begin(), b.triangles.end(), comes_before);
    return std::tuple(a.radiance.x, a.radiance.y, a.radiance.z, a.is_two_sided) <
           std::tuple(b.radiance.x, b.radiance.y, b.radiance.z, b.is_two_sided);
  });
  return surfaces;
}

}  // namespace penumbra
