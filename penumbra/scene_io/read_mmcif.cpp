// SPDX-License-Identifier: MIT
// Alone in its file: gemmi's grammar takes long to compile.
#include <array>
#include <cmath>
#include <string>

#include <fmt/format.h>
#include <gemmi/cif.hpp>
#include <gemmi/numb.hpp>

#include "penumbra/scene_io/atoms.h"
#include "penumbra/scene_io/elements.h"

namespace penumbra {

namespace {

namespace cif = gemmi::cif;

cif::Document parse(const Source& source) {
  const std::string file = source.path.string();
  try {
    return cif::read_memory(source.bytes.data(), source.bytes.size(), file.c_str());
  } catch (const tao::pegtl::parse_error& error) {
    throw Error({file, error.positions().front().line, {}},
                fmt::format("broken mmCIF: {:.200}", error.message()),
                "is the file damaged or cut off?");
  } catch (const std::exception& error) {
    throw Error({file, {}, {}}, fmt::format("broken mmCIF: {:.200}", error.what()),
                "is the file damaged?");
  }
}

/// The columns we use; those marked '?' may be missing.
enum Column : std::size_t {
  column_x,
  column_y,
  column_z,
  column_symbol,
  column_name,
  column_altloc,
  column_residue,
  column_chain,
  column_number,
  column_insertion,
  column_model
};
const std::vector<std::string> tags{"Cartn_x",
                                    "Cartn_y",
                                    "Cartn_z",
                                    "?type_symbol",
                                    "?label_atom_id",
                                    "?label_alt_id",
                                    "?label_comp_id",
                                    "?auth_asym_id",
                                    "?auth_seq_id",
                                    "?pdbx_PDB_ins_code",
                                    "?pdbx_PDB_model_num"};

std::string text_of(cif::Table::Row& row, Column column) {
  return row.has2(column) ? cif::as_string(row[column]) : std::string();
}

float coordinate(cif::Table::Row& row, Column column, const Error::Place& list, std::size_t atom) {
  const auto value = static_cast<float>(cif::as_number(row[column]));
  if (!std::isfinite(value))
    throw Error(list,
                fmt::format("atom {} of the list that starts here has the coordinate '{:.40}', "
                            "which is not a finite number",
                            atom + 1, row[column]),
                "mend it");
  return value;
}

std::size_t line_of(cif::Block& block) {
  for (const cif::Item& item : block.items)
    if (item.type == cif::ItemType::Loop && item.loop.find_tag("_atom_site.Cartn_x") >= 0)
      return static_cast<std::size_t>(item.line_number);
  return 1;
}

}  // namespace

Molecule read_mmcif(const Source& source, Warnings&) {
  cif::Document document = parse(source);
  Molecule molecule;
  for (cif::Block& block : document.blocks) {
    cif::Table table = block.find("_atom_site.", tags);
    if (!table.ok()) continue;
    const Error::Place list{source.path.string(), line_of(block), {}};
    std::string first_model;
    for (cif::Table::Row row : table) {
      const std::string model_number = text_of(row, column_model);
      if (molecule.atoms.empty()) first_model = model_number;
      if (model_number != first_model) continue;
      const std::size_t i = molecule.atoms.size();
      Atom atom;
      atom.position = {coordinate(row, column_x, list, i), coordinate(row, column_y, list, i),
                       coordinate(row, column_z, list, i)};
      atom.name = text_of(row, column_name);
      atom.residue = text_of(row, column_residue);
      atom.residue_place = text_of(row, column_chain) + ' ' + text_of(row, column_number) +
                           text_of(row, column_insertion);
      const std::string letter = text_of(row, column_altloc);
      atom.altloc = letter.empty() ? '\0' : letter[0];
      atom.element = find_element(text_of(row, column_symbol));
      if (atom.element == 0) atom.element = element_from_name(' ' + atom.name, atom.residue);
      molecule.atoms.push_back(std::move(atom));
    }
    break;
  }
  return molecule;
}

}  // namespace penumbra
