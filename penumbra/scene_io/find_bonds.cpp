// SPDX-License-Identifier: MIT
// Bonds by distance: the rule, with its tolerance of 0.4 angstroms, is that of the Cambridge
// Structural Database (Allen et al., Acta Cryst. B35, 1979).
#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <string_view>
#include <unordered_map>

#include "penumbra/scene_io/atoms.h"
#include "penumbra/scene_io/elements.h"

namespace penumbra {

namespace {

constexpr float tolerance = 0.4f, shortest = 0.4f, longest_given = 4;
/// Ten times what even the largest atoms' neighbourhoods hold; bounds the work where atoms are
/// heaped up as matter cannot be.
constexpr std::size_t most_candidates = 5000;

using Cell = std::array<std::int64_t, 3>;

/// Atoms in the order of the cells of a grid that they lie in.
struct Grid {
  double cell_size = 1;
  std::vector<std::uint32_t> order;
  std::vector<Cell> cells;  ///< of order[i]

  Cell cell_of(Vec3f p) const {
    const auto index = [&](float c) {  // within what fits, wherever a damaged file puts an atom
      const double cell = std::floor(static_cast<double>(c) / cell_size);
      return static_cast<std::int64_t>(std::clamp(cell, -1e15, 1e15));
    };
    return {index(p.x), index(p.y), index(p.z)};
  }
};

Grid make_grid(const std::vector<Atom>& atoms, double cell_size) {
  Grid grid{cell_size, std::vector<std::uint32_t>(atoms.size()), {}};
  std::vector<Cell> cells;
  for (const Atom& atom : atoms) cells.push_back(grid.cell_of(atom.position));
  std::iota(grid.order.begin(), grid.order.end(), 0u);
  std::stable_sort(grid.order.begin(), grid.order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return cells[a] < cells[b]; });
  for (std::uint32_t i : grid.order) grid.cells.push_back(cells[i]);
  return grid;
}

bool are_bonded(const Atom& a, const Atom& b) {
  if (a.element == 1 && b.element == 1) return false;
  if (is_ion_former(a.element) || is_ion_former(b.element)) return false;
  const float reach = covalent_radius(a.element) + covalent_radius(b.element) + tolerance;
  const float distance_squared = length_squared(a.position - b.position);
  return distance_squared > shortest * shortest && distance_squared < reach * reach;
}

void add_bonds_by_distance(const std::vector<Atom>& atoms, std::vector<Bond>& bonds,
                           Warnings& warnings) {
  float largest = 0;
  for (const Atom& atom : atoms) largest = std::max(largest, covalent_radius(atom.element));
  const Grid grid = make_grid(atoms, static_cast<double>(2 * largest + tolerance));
  for (std::uint32_t a = 0; a < atoms.size(); ++a) {
    const Cell cell = grid.cell_of(atoms[a].position);
    std::size_t candidates = 0;
    for (std::int64_t x = cell[0] - 1; x <= cell[0] + 1; ++x)
      for (std::int64_t y = cell[1] - 1; y <= cell[1] + 1; ++y) {
        const Cell last{x, y, cell[2] + 1};  // the row of three cells along z lies together
        auto at = std::lower_bound(grid.cells.begin(), grid.cells.end(), Cell{x, y, cell[2] - 1});
        for (; at != grid.cells.end() && *at <= last && candidates < most_candidates; ++at) {
          ++candidates;
          const std::uint32_t b = grid.order[static_cast<std::size_t>(at - grid.cells.begin())];
          if (a < b && are_bonded(atoms[a], atoms[b])) bonds.push_back({a, b});
        }
      }
    if (candidates == most_candidates)
      warnings.add("atoms lie closer together than in any matter; some bonds may be missing");
  }
}

void add_given_bonds(const std::vector<Atom>& atoms,
                     const std::vector<std::array<std::string, 2>>& bonded_serials,
                     std::vector<Bond>& bonds, Warnings& warnings) {
  // Serials that overflowed their columns stand for several atoms: they say nothing.
  std::unordered_map<std::string_view, std::optional<std::uint32_t>> by_serial;
  for (std::uint32_t i = 0; i < atoms.size(); ++i) {
    const auto [at, is_new] = by_serial.try_emplace(atoms[i].serial, i);
    if (!is_new) at->second.reset();
  }
  const auto find = [&](const std::string& serial) -> std::optional<std::uint32_t> {
    const auto at = by_serial.find(serial);
    return at == by_serial.end() ? std::nullopt : at->second;
  };
  for (const auto& [from, to] : bonded_serials) {
    const auto a = find(from), b = find(to);
    if (!a || !b || *a == *b) continue;
    if (length(atoms[*a].position - atoms[*b].position) < longest_given)
      bonds.push_back({std::min(*a, *b), std::max(*a, *b)});
    else
      warnings.add("a bond of more than 4 angstroms is not drawn");
  }
}

}  // namespace

std::vector<Bond> find_bonds(const std::vector<Atom>& atoms,
                             const std::vector<std::array<std::string, 2>>& bonded_serials,
                             Warnings& warnings) {
  std::vector<Bond> bonds;
  add_bonds_by_distance(atoms, bonds, warnings);
  add_given_bonds(atoms, bonded_serials, bonds, warnings);
  std::sort(bonds.begin(), bonds.end());
  bonds.erase(std::unique(bonds.begin(), bonds.end()), bonds.end());
  return bonds;
}

}  // namespace penumbra
