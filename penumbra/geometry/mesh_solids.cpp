// SPDX-License-Identifier: MIT
#include "penumbra/geometry/mesh_solids.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "penumbra/geometry/surface_parity.h"

namespace penumbra {
namespace {

constexpr double most_lines = 32, fewest_lines = 5;
constexpr double line_budget = 4 * most_lines * most_lines * most_lines;
constexpr double ranking_slack = 0.1;  // seeds need not be ranked exactly
constexpr double thinnest = 1e-4;      // of a solid's size: less room is none
constexpr double smallest = 0.03;      // of the radius of a solid's largest volume

double size_of(const Box& box) { return length(Vec3d(box.hi) - Vec3d(box.lo)); }

/// How many lines go through each solid, in proportion to their sizes as far as the budget allows.
std::vector<std::size_t> shared_lines(std::span<const ClosedSurface> surfaces) {
  double largest = 0;
  for (const ClosedSurface& surface : surfaces) largest = std::max(largest, size_of(surface.box));
  const auto lines = [&](const ClosedSurface& surface, double factor) {
    return std::clamp(factor * size_of(surface.box) / largest, fewest_lines, most_lines);
  };
  const auto fits = [&](double factor) {
    double sum = 0;
    for (const ClosedSurface& surface : surfaces) sum += std::pow(lines(surface, factor), 3);
    return sum <= line_budget;
  };
  double factor = 1;
  while (factor < 1e3 * most_lines && fits(2 * factor)) factor *= 2;
  std::vector<std::size_t> result;
  for (const ClosedSurface& surface : surfaces)
    result.push_back(static_cast<std::size_t>(lines(surface, factor)));
  return result;
}

/// A place where a volume may grow.
struct Seed {
  Vec3d point;
  double room;
  std::uint32_t solid;
};

void add_seeds(const ClosedSurface& surface, const TriangleTree& tree, std::size_t lines,
               std::uint32_t solid, std::vector<Seed>& seeds) {
  const double size = size_of(surface.box);
  for (const Vec3d p : inside_points(surface.triangles, lines)) {
    const double room = clearance(tree, p, size, ranking_slack);
    if (room > thinnest * size) seeds.push_back({p, room, solid});
  }
}

bool holds(const InnerVolume& volume, Vec3d p) {
  const Vec3d x = p - volume.center;
  return length_squared(x) <= volume.radius * volume.radius || volume.body.holds(x);
}

/// Adds the volume that grows from a seed, unless the solid has that place already.
void grow(const Seed& seed, const TriangleTree& tree, MeshSolid& solid) {
  const auto has = [&](Vec3d p) {
    return std::any_of(solid.volumes.begin(), solid.volumes.end(),
                       [&](const InnerVolume& volume) { return holds(volume, p); });
  };
  if (has(seed.point)) return;
  const Vec3d center = roomier_center(tree, seed.point, size_of(solid.surface.box));
  solid.volumes.push_back(inner_volume(tree, center, solid.surface.box));
  // Where the climb has led into a volume that is there, the place itself is still free.
  if (!holds(solid.volumes.back(), seed.point))
    solid.volumes.push_back(inner_volume(tree, seed.point, solid.surface.box));
}

void keep_largest(std::vector<ClosedSurface>& surfaces, std::size_t most) {
  std::stable_sort(surfaces.begin(), surfaces.end(),
                   [](const ClosedSurface& a, const ClosedSurface& b) {
                     return size_of(a.box) > size_of(b.box);
                   });
  if (surfaces.size() > most) surfaces.resize(most);
}

}  // namespace

std::vector<MeshSolid> mesh_solids(std::span<const Mesh> meshes,
                                   const std::vector<bool>& casts_no_shadow,
                                   const MeshSolidOptions& options) {
  std::vector<ClosedSurface> surfaces = closed_surfaces(meshes, casts_no_shadow);
  keep_largest(surfaces, options.most_solids);
  const std::vector<std::size_t> lines = shared_lines(surfaces);
  std::vector<MeshSolid> solids;
  std::vector<TriangleTree> trees;
  std::vector<Seed> seeds;
  for (std::uint32_t i = 0; i < surfaces.size(); ++i) {
    trees.emplace_back(surfaces[i].triangles);
    add_seeds(surfaces[i], trees[i], lines[i], i, seeds);
    solids.push_back({std::move(surfaces[i]), {}});
  }
  std::stable_sort(seeds.begin(), seeds.end(),
                   [](const Seed& a, const Seed& b) { return a.room > b.room; });
  std::size_t grown = 0;
  for (const Seed& seed : seeds) {
    MeshSolid& solid = solids[seed.solid];
    const std::size_t before = solid.volumes.size();
    if (before > 0 &&
        (grown >= options.most_volumes || seed.room < smallest * solid.volumes.front().radius))
      continue;
    grow(seed, trees[seed.solid], solid);
    if (before > 0) grown += solid.volumes.size() - before;
  }
  std::erase_if(solids, [](const MeshSolid& solid) { return solid.volumes.empty(); });
  return solids;
}

}  // namespace penumbra
