// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/elements.h"

#include <array>

#include <gemmi/elem.hpp>
#include <gemmi/resinfo.hpp>

#include "penumbra/scene/image.h"

namespace penumbra {

namespace {

/// sRGB codes by atomic number: the table "Colors" of Jmol's documentation
/// (jmol.sourceforge.net/jscolors). The first is for unknown atoms.
constexpr std::array<std::uint32_t, 110> jmol_colors{
    0xFF1493, 0xFFFFFF, 0xD9FFFF, 0xCC80FF, 0xC2FF00, 0xFFB5B5, 0x909090, 0x3050F8, 0xFF0D0D,
    0x90E050, 0xB3E3F5, 0xAB5CF2, 0x8AFF00, 0xBFA6A6, 0xF0C8A0, 0xFF8000, 0xFFFF30, 0x1FF01F,
    0x80D1E3, 0x8F40D4, 0x3DFF00, 0xE6E6E6, 0xBFC2C7, 0xA6A6AB, 0x8A99C7, 0x9C7AC7, 0xE06633,
    0xF090A0, 0x50D050, 0xC88033, 0x7D80B0, 0xC28F8F, 0x668F8F, 0xBD80E3, 0xFFA100, 0xA62929,
    0x5CB8D1, 0x702EB0, 0x00FF00, 0x94FFFF, 0x94E0E0, 0x73C2C9, 0x54B5B5, 0x3B9E9E, 0x248F8F,
    0x0A7D8C, 0x006985, 0xC0C0C0, 0xFFD98F, 0xA67573, 0x668080, 0x9E63B5, 0xD47A00, 0x940094,
    0x429EB0, 0x57178F, 0x00C900, 0x70D4FF, 0xFFFFC7, 0xD9FFC7, 0xC7FFC7, 0xA3FFC7, 0x8FFFC7,
    0x61FFC7, 0x45FFC7, 0x30FFC7, 0x1FFFC7, 0x00FF9C, 0x00E675, 0x00D452, 0x00BF38, 0x00AB24,
    0x4DC2FF, 0x4DA6FF, 0x2194D6, 0x267DAB, 0x266696, 0x175487, 0xD0D0E0, 0xFFD123, 0xB8B8D0,
    0xA6544D, 0x575961, 0x9E4FB5, 0xAB5C00, 0x754F45, 0x428296, 0x420066, 0x007D00, 0x70ABFA,
    0x00BAFF, 0x00A1FF, 0x008FFF, 0x0080FF, 0x006BFF, 0x545CF2, 0x785CE3, 0x8A4FE3, 0xA136D4,
    0xB31FD4, 0xB31FBA, 0xB30DA6, 0xBD0D87, 0xC70066, 0xCC0059, 0xD1004F, 0xD90045, 0xE00038,
    0xE6002E, 0xEB0026};

gemmi::El to_gemmi(std::uint8_t element) { return gemmi::Element(element).elem; }

bool is_letter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }

bool is_polymer_residue(const std::string& name) {
  const gemmi::ResidueInfo info = gemmi::find_tabulated_residue(name);
  return info.is_standard() && (info.is_amino_acid() || info.is_nucleic_acid());
}

}  // namespace

std::string element_symbol(std::uint8_t element) { return gemmi::element_name(to_gemmi(element)); }

std::uint8_t find_element(std::string_view symbol) {
  while (!symbol.empty() && symbol.front() == ' ') symbol.remove_prefix(1);
  while (!symbol.empty() && symbol.back() == ' ') symbol.remove_suffix(1);
  if (symbol.empty() || symbol.size() > 2) return 0;
  for (char c : symbol)
    if (!is_letter(c)) return 0;
  const std::string text(symbol);
  return static_cast<std::uint8_t>(gemmi::Element(text.c_str()).atomic_number());
}

float van_der_waals_radius(std::uint8_t element) { return gemmi::vdw_radius(to_gemmi(element)); }

float covalent_radius(std::uint8_t element) { return gemmi::covalent_radius(to_gemmi(element)); }

Color element_color(std::uint8_t element) {
  const std::uint32_t code = jmol_colors[element < jmol_colors.size() ? element : 0];
  const auto linear = [&](int shift) {
    return linear_from_srgb(static_cast<float>(code >> shift & 0xFF) / 255);
  };
  return {linear(16), linear(8), linear(0)};
}

bool is_ion_former(std::uint8_t element) {
  switch (to_gemmi(element)) {
    case gemmi::El::Li:
    case gemmi::El::Na:
    case gemmi::El::K:
    case gemmi::El::Rb:
    case gemmi::El::Cs:
    case gemmi::El::Mg:
    case gemmi::El::Ca:
    case gemmi::El::Sr:
    case gemmi::El::Ba: return true;
    default: return false;
  }
}

std::uint8_t element_from_name(std::string_view padded_name, const std::string& residue) {
  std::string name(padded_name.substr(0, 4));
  name.resize(4, ' ');
  // Hydrogens with long names begin in the first column: "HG11" is no mercury; mercury's names are
  // short.
  const bool is_hydrogen = (name[0] == 'H' || name[0] == 'h') && name[3] != ' ';
  if (!is_hydrogen && is_letter(name[0]) && is_letter(name[1]) && !is_polymer_residue(residue))
    if (const std::uint8_t element = find_element(name.substr(0, 2))) return element;
  for (char c : name)
    if (is_letter(c)) return find_element(std::string_view(&c, 1));
  return 0;
}

}  // namespace penumbra
