// SPDX-License-Identifier: MIT
// Private to the layer: a B-DNA duplex of any sequence, atom by atom (no hydrogens), from the
// published helix: S. Arnott and D. W. L. Hukins, Optimised parameters for A-DNA and B-DNA,
// Biochem. Biophys. Res. Commun. 47 (1972) 1504-1509.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "penumbra/geometry/vec.h"

namespace penumbra::detail {

enum class Element : std::uint8_t { carbon, nitrogen, oxygen, phosphorus };

struct Atom {
  std::string_view name;  ///< as in the Protein Data Bank
  Element element = Element::carbon;
  Vec3d position;  ///< in ångström, the helix axis along z
};

struct Bond {
  std::uint32_t first = 0, second = 0;  ///< indices of atoms
};

struct Duplex {
  std::vector<Atom> atoms;
  std::vector<Bond> bonds;           ///< covalent
  std::vector<Bond> hydrogen_bonds;  ///< between the two bases of a pair
};

/// `sequence` (of the letters A, C, G, T) is the first strand from 5' to 3', downwards in z; the
/// second strand is its complement. The 5' ends carry no phosphate.
Duplex b_dna(std::string_view sequence);

}  // namespace penumbra::detail
