// SPDX-License-Identifier: MIT
// What a molecule's picture needs to know of the chemical elements. An element is its atomic
// number; 0 is an unknown one, deuterium is hydrogen.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "penumbra/scene/material.h"

namespace penumbra {

/// "Ca"; "X" for unknown ones.
std::string element_symbol(std::uint8_t element);

/// The element of a symbol in any case, space around it ignored; 0 where there is none.
std::uint8_t find_element(std::string_view symbol);

/// In angstroms. Bondi 1964 and Mantina et al. 2009, missing ones from cctbx, by gemmi's table.
float van_der_waals_radius(std::uint8_t element);

/// In angstroms. Cordero et al. 2008 by gemmi's table.
float covalent_radius(std::uint8_t element);

/// The colours that Jmol gives elements (CPK where that has one), linear.
Color element_color(std::uint8_t element);

/// Alkali and alkaline earth metals: they are met as ions, which have no bonds to draw.
bool is_ion_former(std::uint8_t element);

/// The element that an atom's name tells. `padded_name` is PDB's columns 13 to 16, where a symbol
/// of one letter stands in the second ("CA  " is calcium, " CA " a carbon). `residue`: amino and
/// nucleic acids have no elements of two letters, wherever their names stand.
std::uint8_t element_from_name(std::string_view padded_name, const std::string& residue);

}  // namespace penumbra
