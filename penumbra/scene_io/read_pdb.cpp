// SPDX-License-Identifier: MIT
// Read here, by columns, rather than by gemmi, which takes broken coordinates for 0, skips CONECT,
// and refuses files whose columns 73 to 80 hold what they held before 1996.
#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "penumbra/scene_io/atoms.h"
#include "penumbra/scene_io/elements.h"
#include "penumbra/scene_io/numbers.h"
#include "penumbra/scene_io/text_lines.h"

namespace penumbra {

namespace {

/// Records that draw nothing (format versions 2.1 to 3.3, and REFMAC's).
constexpr std::array<std::string_view, 58> silent{
    "HEADER", "OBSLTE", "TITLE",  "SPLIT",  "CAVEAT", "COMPND", "SOURCE", "KEYWDS", "EXPDTA",
    "NUMMDL", "MDLTYP", "AUTHOR", "REVDAT", "SPRSDE", "JRNL",   "REMARK", "DBREF",  "DBREF1",
    "DBREF2", "SEQADV", "SEQRES", "MODRES", "HET",    "HETNAM", "HETSYN", "FORMUL", "HELIX",
    "SHEET",  "TURN",   "SSBOND", "LINK",   "LINKR",  "CISPEP", "SITE",   "CRYST1", "ORIGX1",
    "ORIGX2", "ORIGX3", "SCALE1", "SCALE2", "SCALE3", "MTRIX1", "MTRIX2", "MTRIX3", "TVECT",
    "ANISOU", "SIGATM", "SIGUIJ", "TER",    "MASTER", "FTNOTE", "USER",   "SLTBRG", "HYDBND",
    "LINKRN", "NUMRES", "PRTCNT", ""};

/// An atom's element as its columns say and as its name says, until we know whom to trust.
struct ElementClaims {
  std::uint8_t by_column = 0, by_name = 0;
  bool has_column = false, is_plausible = false;
};

struct Reader {
  std::string file;
  Warnings& warnings;
  std::size_t line = 0;
  Molecule molecule;
  std::vector<ElementClaims> claims;
  bool has_model_record = false, is_model_over = false;

  [[noreturn]] void fail(std::string what) const {
    throw Error({file, line, {}}, std::move(what), "is the file damaged or cut off?");
  }
};

/// Columns first to last, counted from 1 as the format does, as far as the line has them.
std::string_view columns(std::string_view line, std::size_t first, std::size_t last) {
  if (line.size() < first) return {};
  return line.substr(first - 1, last - first + 1);
}

std::string word(std::string_view line, std::size_t first, std::size_t last) {
  return std::string(trimmed(columns(line, first, last)));
}

float coordinate(const Reader& reader, std::string_view line, std::size_t first) {
  const std::string_view text = trimmed(columns(line, first, first + 7));
  const auto value = parse_float(text);
  if (!value || !std::isfinite(*value))
    reader.fail(fmt::format("the coordinate {} in columns {} to {} is not a finite number",
                            in_quotes(text), first, first + 7));
  return *value;
}

char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

/// Old files have other things in the element's columns, letters among them.
bool is_plausible(std::uint8_t element, std::string_view symbol, std::string_view name) {
  const char first = upper(trimmed(symbol)[0]);
  return element != 0 && std::any_of(name.begin(), name.end(), [&](char c) {
           return upper(c) == first || (element == 1 && (upper(c) == 'H' || upper(c) == 'D'));
         });
}

/// How many columns to the right of their place the coordinates stand: numbers of atoms and
/// residues that overflow their columns push away all that follows. Coordinates have their points
/// in the columns 35, 43 and 51.
std::size_t overflow_of(std::string_view line) {
  for (std::size_t shift = 0; shift <= 4; ++shift)
    if (columns(line, 35 + shift, 35 + shift) == "." &&
        columns(line, 43 + shift, 43 + shift) == "." &&
        columns(line, 51 + shift, 51 + shift) == ".")
      return shift;
  return 0;
}

void read_atom(Reader& reader, std::string_view line) {
  const std::size_t shift = overflow_of(line);
  // A digit in the empty column 12 belongs to a serial number of six.
  const bool is_serial_long = shift > 0 && line[11] >= '0' && line[11] <= '9';
  const std::size_t name_shift = is_serial_long ? 1 : 0;
  if (shift > 0)
    reader.warnings.add("a number overflows its columns; what follows is read shifted",
                        reader.line);
  if (line.size() < 54 + shift) reader.fail("the atom's line ends before its coordinates do");
  Atom atom;
  atom.position = {coordinate(reader, line, 31 + shift), coordinate(reader, line, 39 + shift),
                   coordinate(reader, line, 47 + shift)};
  atom.serial = word(line, 7, 11 + name_shift);
  const std::string_view padded_name = columns(line, 13 + name_shift, 16 + name_shift);
  atom.name = trimmed(padded_name);
  const char altloc = line[16 + name_shift];
  atom.altloc = altloc == ' ' ? '\0' : altloc;
  atom.residue = word(line, 18 + name_shift, 21 + name_shift);
  atom.residue_place = columns(line, 21 + name_shift, 27 + shift);

  ElementClaims claims;
  const std::string_view symbol = columns(line, 77 + shift, 78 + shift);
  claims.has_column = !trimmed(symbol).empty();
  claims.by_column = find_element(symbol);
  claims.by_name = element_from_name(padded_name, word(line, 18 + name_shift, 20 + name_shift));
  claims.is_plausible = claims.has_column && is_plausible(claims.by_column, symbol, padded_name);
  reader.claims.push_back(claims);
  reader.molecule.atoms.push_back(std::move(atom));
}

void read_bonds(Reader& reader, std::string_view line) {
  const std::string from = word(line, 7, 11);
  for (std::size_t first : {12, 17, 22, 27})
    if (std::string to = word(line, first, first + 4); !to.empty())
      reader.molecule.bonded_serials.push_back({from, std::move(to)});
}

/// The columns are trusted unless more than a tenth of what stands there makes no sense.
void settle_elements(Reader& reader) {
  std::size_t filled = 0, nonsense = 0;
  for (const ElementClaims& c : reader.claims) {
    filled += c.has_column;
    nonsense += c.has_column && !c.is_plausible;
  }
  const bool are_columns_good = nonsense * 10 <= filled;
  if (!are_columns_good)
    reader.warnings.add("columns 77 and 78 hold no elements; they are taken from the atoms' names");
  for (std::size_t i = 0; i < reader.claims.size(); ++i) {
    const ElementClaims& c = reader.claims[i];
    const bool by_column = are_columns_good && c.by_column != 0;
    reader.molecule.atoms[i].element = by_column ? c.by_column : c.by_name;
  }
}

void read_record(Reader& reader, std::string_view line) {
  std::string record = word(line, 1, 6);
  std::transform(record.begin(), record.end(), record.begin(), upper);
  const bool has_atoms = !reader.molecule.atoms.empty();
  if (record == "ATOM" || record == "HETATM") {
    if (!reader.is_model_over) read_atom(reader, line);
  } else if (record == "CONECT") {
    read_bonds(reader, line);
  } else if (record == "MODEL") {
    reader.has_model_record = true;
    reader.is_model_over |= has_atoms;
  } else if (record == "ENDMDL" || record == "END") {
    // Trajectories end each frame so without beginning it. Where models do begin, atoms between
    // them belong to the first.
    reader.is_model_over |= has_atoms && !reader.has_model_record;
  } else if (std::find(silent.begin(), silent.end(), record) == silent.end()) {
    reader.warnings.add("records that the format does not have are skipped", reader.line);
  }
}

}  // namespace

Molecule read_pdb(const Source& source, Warnings& warnings) {
  Reader reader{source.path.string(), warnings, 0, {}, {}};
  TextLines lines(source.bytes, LineJoints::none);
  while (const auto line = lines.next()) {
    reader.line = lines.number();
    read_record(reader, *line);
  }
  settle_elements(reader);
  return std::move(reader.molecule);
}

}  // namespace penumbra
