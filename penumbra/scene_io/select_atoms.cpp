// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <bit>
#include <string_view>
#include <unordered_map>
#include <unordered_set>

#include <fmt/format.h>

#include "penumbra/scene_io/atoms.h"

namespace penumbra {

namespace {

/// Names that crystallographers and simulation programs give water.
constexpr std::array<std::string_view, 14> waters{"HOH", "WAT",  "DOD",  "H2O",  "OH2",
                                                  "TIP", "TIP3", "TIP4", "TIP5", "TP3",
                                                  "TP4", "SOL",  "SPC",  "SPCE"};

bool is_water(const Atom& atom) {
  return std::find(waters.begin(), waters.end(), atom.residue) != waters.end();
}

struct PlaceHash {
  std::size_t operator()(const Vec3f& p) const {
    std::uint64_t h = 0;
    for (float c : {p.x, p.y, p.z})  // + 0 makes -0 equal to 0, as == has it
      h = (h ^ std::bit_cast<std::uint32_t>(c + 0.0f)) * 0x9E3779B97F4A7C15u, h ^= h >> 32;
    return h;
  }
};

}  // namespace

std::vector<Atom> select_atoms(std::vector<Atom> atoms, const ReadOptions& options,
                               Warnings& warnings) {
  if (!options.waters) std::erase_if(atoms, is_water);

  std::unordered_map<std::string_view, char> letters;  // of the residue's first location
  for (const Atom& atom : atoms)
    if (atom.altloc) letters.try_emplace(atom.residue_place, atom.altloc);
  std::vector<bool> is_kept(atoms.size());
  for (std::size_t i = 0; i < atoms.size(); ++i)
    is_kept[i] = !atoms[i].altloc || letters.at(atoms[i].residue_place) == atoms[i].altloc;

  std::unordered_set<Vec3f, PlaceHash> places;
  std::vector<Atom> kept;
  for (std::size_t i = 0; i < atoms.size(); ++i) {
    if (!is_kept[i]) continue;
    if (places.insert(atoms[i].position).second)
      kept.push_back(std::move(atoms[i]));
    else
      warnings.add("an atom in the very place of another is left out");
  }
  return kept;
}

}  // namespace penumbra
