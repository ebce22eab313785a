// SPDX-License-Identifier: MIT
#include "penumbra/scene/b_dna.h"

#include <array>
#include <cmath>
#include <numbers>
#include <span>

namespace penumbra::detail {

namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double twist_deg = 36, rise = 3.38;  // from one base pair to the next

/// Cylindrical coordinates as published: ångström and degrees.
struct TableAtom {
  std::string_view name;
  double radius, angle_deg, height;
};

// O3' is printed with the phosphate it binds; here it stands with its own sugar, one step below.
constexpr std::array<TableAtom, 11> backbone{{{"P", 8.91, 95.2, 2.08},
                                              {"OP1", 10.20, 91.1, 1.86},
                                              {"OP2", 8.82, 103.3, 1.29},
                                              {"O5'", 7.73, 88.0, 1.83},
                                              {"C5'", 7.70, 79.8, 2.77},
                                              {"C4'", 7.59, 69.9, 2.04},
                                              {"O4'", 6.22, 66.0, 1.83},
                                              {"C3'", 8.20, 69.9, 0.64},
                                              {"O3'", 8.75, 97.4 - twist_deg, 3.63 - rise},
                                              {"C2'", 7.04, 73.2, -0.24},
                                              {"C1'", 5.86, 67.4, 0.47}}};
constexpr std::size_t phosphate_atoms = 3;

constexpr std::array<TableAtom, 10> adenine{{{"N9", 4.63, 76.6, 0.42},
                                             {"C8", 4.84, 93.0, 0.50},
                                             {"N7", 3.95, 105.4, 0.43},
                                             {"C5", 2.74, 94.0, 0.28},
                                             {"N6", 1.83, 154.0, 0.14},
                                             {"C6", 1.41, 107.2, 0.15},
                                             {"N1", 0.86, 40.1, 0.03},
                                             {"C2", 2.17, 30.6, 0.04},
                                             {"N3", 3.24, 47.0, 0.16},
                                             {"C4", 3.33, 70.5, 0.28}}};
constexpr std::array<TableAtom, 11> guanine{{{"N9", 4.63, 76.6, 0.42},
                                             {"C8", 4.82, 93.2, 0.50},
                                             {"N7", 3.92, 105.7, 0.42},
                                             {"C5", 2.70, 94.0, 0.28},
                                             {"O6", 1.71, 154.6, 0.13},
                                             {"C6", 1.39, 109.3, 0.15},
                                             {"N1", 0.92, 37.9, 0.03},
                                             {"N2", 3.01, 4.2, -0.10},
                                             {"C2", 2.28, 28.7, 0.03},
                                             {"N3", 3.29, 46.7, 0.16},
                                             {"C4", 3.33, 70.3, 0.28}}};
constexpr std::array<TableAtom, 8> cytosine{{{"N1", 4.63, 76.6, 0.42},
                                             {"C6", 4.99, 92.2, 0.52},
                                             {"C5", 4.35, 107.0, 0.47},
                                             {"N4", 2.76, 136.6, 0.27},
                                             {"C4", 2.94, 110.0, 0.32},
                                             {"N3", 2.31, 83.9, 0.22},
                                             {"O2", 3.69, 47.9, 0.18},
                                             {"C2", 3.40, 67.4, 0.27}}};
constexpr std::array<TableAtom, 9> thymine{{{"N1", 4.63, 76.6, 0.42},
                                            {"C6", 5.01, 92.3, 0.52},
                                            {"C7", 5.40, 119.8, 0.58},
                                            {"C5", 4.38, 106.9, 0.47},
                                            {"O4", 2.82, 136.3, 0.27},
                                            {"C4", 2.98, 111.9, 0.32},
                                            {"N3", 2.36, 85.2, 0.23},
                                            {"O2", 3.64, 47.8, 0.18},
                                            {"C2", 3.42, 67.3, 0.27}}};

std::span<const TableAtom> base_atoms(char base) {
  switch (base) {
    case 'A': return adenine;
    case 'G': return guanine;
    case 'C': return cytosine;
    default: return thymine;
  }
}

char complement(char base) {
  switch (base) {
    case 'A': return 'T';
    case 'G': return 'C';
    case 'C': return 'G';
    default: return 'A';
  }
}

Element element_of(std::string_view name) {
  switch (name.front()) {
    case 'N': return Element::nitrogen;
    case 'O': return Element::oxygen;
    case 'P': return Element::phosphorus;
    default: return Element::carbon;
  }
}

/// Single-bond radii (Cordero et al., Covalent radii revisited, Dalton Trans. 2008, 2832).
double covalent_radius(Element element) {
  switch (element) {
    case Element::carbon: return 0.76;
    case Element::nitrogen: return 0.71;
    case Element::oxygen: return 0.66;
    case Element::phosphorus: break;
  }
  return 1.07;
}

/// Which of the two strands: the second is the first turned by the helix' two-fold axes across it.
enum class Strand { first, second };

void add_atoms(Duplex& duplex, std::span<const TableAtom> table, Strand strand, int level) {
  const double sense = strand == Strand::first ? 1 : -1;
  for (const TableAtom& atom : table) {
    const double angle = (sense * atom.angle_deg - twist_deg * level) * degree;
    const double z = sense * atom.height - rise * level;
    duplex.atoms.push_back({atom.name,
                            element_of(atom.name),
                            {atom.radius * std::cos(angle), atom.radius * std::sin(angle), z}});
  }
}

/// Atoms that lie within their covalent radii and a little of each other.
void find_bonds(Duplex& duplex) {
  constexpr double tolerance = 0.2;
  for (std::uint32_t i = 0; i < duplex.atoms.size(); ++i)
    for (std::uint32_t j = i + 1; j < duplex.atoms.size(); ++j) {
      const Atom &a = duplex.atoms[i], &b = duplex.atoms[j];
      const double reach = covalent_radius(a.element) + covalent_radius(b.element) + tolerance;
      if (length_squared(a.position - b.position) < reach * reach) duplex.bonds.push_back({i, j});
    }
}

/// The first atom of that name from `begin` on.
std::uint32_t atom_named(const Duplex& duplex, std::uint32_t begin, std::string_view name) {
  std::uint32_t i = begin;
  while (i < duplex.atoms.size() && duplex.atoms[i].name != name) ++i;
  return i;
}

/// Watson and Crick's pairs; the bases' atoms begin at these indices.
void add_hydrogen_bonds(Duplex& duplex, char base, std::uint32_t first, std::uint32_t second) {
  const bool is_purine = base == 'A' || base == 'G';
  const std::uint32_t purine = is_purine ? first : second, pyrimidine = is_purine ? second : first;
  const auto join = [&](std::string_view of_purine, std::string_view of_pyrimidine) {
    duplex.hydrogen_bonds.push_back(
        {atom_named(duplex, purine, of_purine), atom_named(duplex, pyrimidine, of_pyrimidine)});
  };
  join("N1", "N3");
  if (base == 'A' || base == 'T') {
    join("N6", "O4");
  } else {
    join("O6", "N4");
    join("N2", "O2");
  }
}

}  // namespace

Duplex b_dna(std::string_view sequence) {
  Duplex duplex;
  const int pairs = static_cast<int>(sequence.size());
  for (int level = 0; level < pairs; ++level) {
    const char base = sequence[level];
    const std::span<const TableAtom> all(backbone);
    add_atoms(duplex, level == 0 ? all.subspan(phosphate_atoms) : all, Strand::first, level);
    const auto first_base = static_cast<std::uint32_t>(duplex.atoms.size());
    add_atoms(duplex, base_atoms(base), Strand::first, level);
    const bool is_last = level == pairs - 1;
    add_atoms(duplex, is_last ? all.subspan(phosphate_atoms) : all, Strand::second, level);
    const auto second_base = static_cast<std::uint32_t>(duplex.atoms.size());
    add_atoms(duplex, base_atoms(complement(base)), Strand::second, level);
    add_hydrogen_bonds(duplex, base, first_base, second_base);
  }
  find_bonds(duplex);
  return duplex;
}

}  // namespace penumbra::detail
