// SPDX-License-Identifier: MIT
#include "penumbra/geometry/mesh_solids.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <optional>
#include <utility>

#include "penumbra/geometry/surface_parity.h"
#include "penumbra/geometry/volume_choice.h"

namespace penumbra {
namespace {

constexpr double most_lines = 32, fewest_lines = 5;
constexpr double line_budget = 4 * most_lines * most_lines * most_lines;
constexpr double ranking_slack = 0.1;     // seeds need not be ranked exactly
constexpr double thinnest = 1e-4;         // of a solid's size: less room is none
constexpr std::size_t grown_for_one = 2;  // volumes grow and the most useful of them stay
constexpr double least_use = 4e-4;        // share of a solid's seeds that a volume must add
constexpr double smallest = 0.03;         // of the radius of a solid's largest volume

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
  std::vector<InnerVolume>& volumes = solid.volumes;
  const auto holds_seed = [&](const InnerVolume& volume) { return holds(volume, seed.point); };
  if (std::any_of(volumes.begin(), volumes.end(), holds_seed)) return;
  const Box& box = solid.surface.box;
  const Vec3d center = roomier_center(tree, seed.point, size_of(box));
  std::optional<InnerVolume> volume = inner_volume(tree, center, box);
  const bool is_held = volume && holds_seed(*volume);
  if (volume) volumes.push_back(*std::move(volume));
  if (is_held) return;
  // The climb has led away: the place itself is still free.
  if ((volume = inner_volume(tree, seed.point, box))) volumes.push_back(*std::move(volume));
}

void keep_largest(std::vector<ClosedSurface>& surfaces, std::size_t most) {
  std::stable_sort(surfaces.begin(), surfaces.end(),
                   [](const ClosedSurface& a, const ClosedSurface& b) {
                     return size_of(a.box) > size_of(b.box);
                   });
  if (surfaces.size() > most) surfaces.resize(most);
}

/// More volumes than are wanted, from the roomiest seeds on.
void grow_all(std::span<const Seed> seeds, std::span<const TriangleTree> trees, std::size_t most,
              std::span<MeshSolid> solids) {
  std::size_t grown = 0;
  for (const Seed& seed : seeds) {
    MeshSolid& solid = solids[seed.solid];
    const std::size_t before = solid.volumes.size();
    if (before > 0 && (grown >= most || seed.room < smallest * solid.volumes.front().radius))
      continue;
    grow(seed, trees[seed.solid], solid);
    if (before > 0) grown += solid.volumes.size() - before;
  }
}

/// Keeps the volumes that hold the most seeds. A solid weighs as much as its surface.
void keep_most_useful(std::span<const Seed> seeds, std::size_t most, std::span<MeshSolid> solids) {
  std::vector<detail::Group> groups(solids.size());
  std::vector<detail::PointSet> sets;
  std::vector<std::vector<Vec3d>> points(solids.size());
  for (const Seed& seed : seeds) points[seed.solid].push_back(seed.point);
  for (std::uint32_t i = 0; i < solids.size(); ++i) {
    const double size = size_of(solids[i].surface.box);
    groups[i] = {points[i].size(), size * size};
    for (const InnerVolume& volume : solids[i].volumes) {
      sets.push_back({std::vector<std::uint64_t>((points[i].size() + 63) / 64, 0), i});
      for (std::size_t k = 0; k < points[i].size(); ++k)
        if (holds(volume, points[i][k])) sets.back().bits[k / 64] |= std::uint64_t{1} << k % 64;
    }
  }
  std::vector<InnerVolume> all;
  for (MeshSolid& solid : solids) {
    std::move(solid.volumes.begin(), solid.volumes.end(), std::back_inserter(all));
    solid.volumes.clear();
  }
  for (const std::uint32_t i : detail::most_useful(sets, groups, most, least_use))
    solids[sets[i].group].volumes.push_back(std::move(all[i]));
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
  grow_all(seeds, trees, grown_for_one * options.most_volumes, solids);
  keep_most_useful(seeds, options.most_volumes, solids);
  std::erase_if(solids, [](const MeshSolid& solid) { return solid.volumes.empty(); });
  return solids;
}

}  // namespace penumbra
