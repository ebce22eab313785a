// SPDX-License-Identifier: MIT
// Molecules between file and picture.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "penumbra/scene_io/read_scene.h"
#include "penumbra/scene_io/source.h"

namespace penumbra {

struct Atom {
  Vec3f position;            ///< angstroms
  std::uint8_t element = 0;  ///< atomic number, see elements.h
  char altloc = 0;           ///< letter of the alternative location; 0: none
  std::string serial;        ///< as bond records name it
  std::string name;
  std::string residue;        ///< name of the residue
  std::string residue_place;  ///< chain, number and insertion code
};

/// Indices of two different atoms, the smaller one first.
using Bond = std::array<std::uint32_t, 2>;

/// A molecule as its file has it: of the first model, everything.
struct Molecule {
  std::vector<Atom> atoms;
  /// Pairs of serials that the file says are bonded (CONECT).
  std::vector<std::array<std::string, 2>> bonded_serials;
};

/// Columns of the PDB format, version 3.3 and older ones without element columns. Throws Error with
/// line.
Molecule read_pdb(const Source& source, Warnings& warnings);
/// The atom_site list of an mmCIF file, by gemmi. Throws Error with line.
Molecule read_mmcif(const Source& source, Warnings& warnings);

/// What is drawn: no waters unless asked for, and of the alternative locations of a residue the
/// first one that the file has; of atoms that are there twice the first.
std::vector<Atom> select_atoms(std::vector<Atom> atoms, const ReadOptions& options,
                               Warnings& warnings);

/// Pairs of atoms nearer than the sum of their covalent radii and 0.4 angstroms, farther than 0.4,
/// and not both hydrogen; none of ions. To these come those of `bonded_serials` that are shorter
/// than 4 angstroms. Sorted, each once. Cost: linear, for a density that matter can have.
std::vector<Bond> find_bonds(const std::vector<Atom>& atoms,
                             const std::vector<std::array<std::string, 2>>& bonded_serials,
                             Warnings& warnings);

}  // namespace penumbra
