// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "penumbra/scene_io/atoms.h"
#include "penumbra/scene_io/elements.h"
#include "tests/scene_io/text_source.h"

namespace penumbra {
namespace {

struct Read {
  Scene scene;
  std::vector<std::string> warnings;
};

Read read(const std::string& name, const std::string& text, const ReadOptions& options = {}) {
  const Source source = source_of(name, text);
  Warnings warnings(name);
  Scene scene = read_molecule(source, options, warnings);
  validate(scene);
  return {std::move(scene), warnings.lines()};
}

/// An atom's line: the name as it stands in columns 13 to 16, altloc and residue in 17 to 20.
std::string atom(int serial, const std::string& name, const std::string& residue, float x,
                 const std::string& element, const std::string& record = "ATOM  ", int number = 1) {
  return fmt::format(
      "{}{:>5} {:4}{:4} A{:>4}    {:8.3f}{:8.3f}{:8.3f}  1.00 10.00          {:>2}\n", record,
      serial, name, residue, number, x, 0.0, 0.0, element);
}

std::string symbol_of(const Scene& scene, std::size_t ball) {
  return scene.materials[scene.shapes.spheres[ball].surface].name;
}

TEST(ReadMolecule, two_atoms_and_their_bond) {
  const Scene scene =
      read("t.pdb", atom(1, " C1 ", " LIG", 0, "C") + atom(2, " O1 ", " LIG", 1.2f, "O")).scene;
  ASSERT_EQ(scene.shapes.spheres.size(), 2u);
  ASSERT_EQ(scene.shapes.cones.size(), 2u);  // half of it in each colour
  EXPECT_TRUE(scene.wants_ground);
  EXPECT_TRUE((scene.up == Vec3d{0, 0, 1}));
  EXPECT_EQ(symbol_of(scene, 0), "C");
  EXPECT_EQ(symbol_of(scene, 1), "O");
  EXPECT_EQ(scene.shapes.cones[0].apex, scene.shapes.cones[1].base);
}

TEST(ReadMolecule, open_ends_of_sticks_lie_inside_the_balls) {
  const Scene scene =
      read("t.pdb", atom(1, " C1 ", " LIG", 0, "C") + atom(2, " H1 ", " LIG", 1.1f, "H")).scene;
  const Sphere& ball = scene.shapes.spheres[0];
  const Cone& stick = scene.shapes.cones[0];
  const double along = length(Vec3d(stick.base - ball.center));
  EXPECT_LT(std::hypot(along, stick.base_radius), ball.radius);
}

TEST(ReadMolecule, space_filling_has_whole_radii_and_no_sticks) {
  const Scene scene =
      read("t.pdb", atom(1, " C1 ", " LIG", 0, "C") + atom(2, " O1 ", " LIG", 1.2f, "O"),
           {.style = MoleculeStyle::space_filling})
          .scene;
  EXPECT_TRUE(scene.shapes.cones.empty());
  EXPECT_FLOAT_EQ(scene.shapes.spheres[0].radius, 1.7f);
}

TEST(ReadMolecule, elements_come_from_names_where_columns_are_nonsense) {
  std::string text;
  for (const char* name : {" CA ", " N  ", " O  ", " SG "}) text += atom(1, name, " CYS", 0, "");
  text += atom(5, "CA  ", "  CA", 9, "");
  std::string old = text;
  for (std::size_t at = 0, line = 0; (at = old.find('\n', at)) != std::string::npos;
       ++line, at += 1)
    old.replace(at - 8, 8, fmt::format("1HPV{:>4}", 1980 + line));
  for (float x = 1; std::size_t at = old.find("   0.000   0.000   0.000"); ++x) {
    if (at == std::string::npos) break;
    old.replace(at, 8, fmt::format("{:8.3f}", 30 * x));
  }
  const Scene scene = read("t.pdb", old).scene;
  ASSERT_EQ(scene.shapes.spheres.size(), 5u);
  const char* const expected[] = {"C", "N", "O", "S", "Ca"};
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(symbol_of(scene, i), expected[i]);
}

TEST(ReadMolecule, letters_in_the_element_columns_must_fit_the_names) {
  std::string text;
  for (int i = 0; i < 10; ++i) text += atom(i, " CA ", " ALA", 5.0f * i, "PV", "ATOM  ", i);
  const Read result = read("t.pdb", text);
  EXPECT_EQ(symbol_of(result.scene, 3), "C");
  EXPECT_TRUE(holds(result.warnings.at(0), "columns 77 and 78 hold no elements"));
}

TEST(Elements, from_names) {
  EXPECT_EQ(element_from_name("CA  ", "CA"), 20);
  EXPECT_EQ(element_from_name(" CA ", "ALA"), 6);
  EXPECT_EQ(element_from_name("CA  ", "ALA"), 6);  // wrongly aligned
  EXPECT_EQ(element_from_name("HG11", "VAL"), 1);
  EXPECT_EQ(element_from_name("HG  ", "HG"), 80);
  EXPECT_EQ(element_from_name("1HB ", "ALA"), 1);
  EXPECT_EQ(element_from_name("C210", "LIG"), 6);
  EXPECT_EQ(element_from_name("CL1 ", "LIG"), 17);
  EXPECT_EQ(element_from_name("    ", "LIG"), 0);
  EXPECT_EQ(element_from_name("", "LIG"), 0);
}

TEST(Elements, symbols_radii_colours) {
  EXPECT_EQ(find_element(" c"), 6);
  EXPECT_EQ(find_element("cl"), 17);
  EXPECT_EQ(find_element("D"), 1);
  EXPECT_EQ(find_element("Qq"), 0);
  EXPECT_EQ(find_element("12"), 0);
  EXPECT_EQ(find_element(""), 0);
  for (int e = 0; e < 256; ++e) {
    const auto element = static_cast<std::uint8_t>(e);
    EXPECT_GT(van_der_waals_radius(element), 0.9f);
    EXPECT_GT(covalent_radius(element), 0.2f);
    EXPECT_TRUE(is_finite(element_color(element)));
  }
  EXPECT_EQ(element_color(1), (Color{1, 1, 1}));
  EXPECT_EQ(element_symbol(20), "Ca");
}

TEST(ReadMolecule, first_model_alone) {
  const std::string one = atom(1, " C1 ", " LIG", 0, "C"), two = atom(2, " C1 ", " LIG", 9, "C");
  const auto count = [](const std::string& text) {
    return read("t.pdb", text).scene.shapes.spheres.size();
  };
  EXPECT_EQ(count("MODEL 1\n" + one + "ENDMDL\nMODEL 2\n" + two + "ENDMDL\n"), 1u);
  EXPECT_EQ(count(one + "ENDMDL\n" + two + "ENDMDL\n"), 1u);
  EXPECT_EQ(count(one + "END\n" + two + "END\n"), 1u);
  // Nothing says that a second model begins.
  EXPECT_EQ(count("MODEL\n" + one + "ENDMDL\n" + two), 2u);
}

TEST(ReadMolecule, first_alternative_location_alone) {
  const std::string text = atom(1, " N  ", " SER", 0, "N") + atom(2, " CA ", "ASER", 5, "C") +
                           atom(3, " CA ", "BSER", 6, "C") + atom(4, " OG ", "BSER", 9, "O");
  EXPECT_EQ(read("t.pdb", text).scene.shapes.spheres.size(), 2u);
}

TEST(ReadMolecule, waters_on_demand) {
  const std::string text =
      atom(1, " C1 ", " LIG", 0, "C") + atom(2, " O  ", " HOH", 9, "O", "HETATM", 2);
  EXPECT_EQ(read("t.pdb", text).scene.shapes.spheres.size(), 1u);
  EXPECT_EQ(read("t.pdb", text, {.waters = true}).scene.shapes.spheres.size(), 2u);
  EXPECT_TRUE(holds(error_of([] { read("t.pdb", atom(1, " O  ", " HOH", 0, "O")); }), "water"));
}

TEST(ReadMolecule, numbers_that_overflow_shift_the_line) {
  std::string text = atom(1, " C1 ", " LIG", 1.5f, "C", "ATOM  ", 9999);
  text += atom(2, " O  ", " LIG", 7.25f, "O", "ATOM  ", 9999);
  text.insert(text.rfind("9999") + 4, "9");
  const Read result = read("t.pdb", text);
  EXPECT_EQ(result.scene.shapes.spheres[1].center, (Vec3f{7.25f, 0, 0}));
  EXPECT_EQ(symbol_of(result.scene, 1), "O");
  EXPECT_TRUE(holds(result.warnings.at(0), "t.pdb:2: a number overflows"));
}

TEST(ReadMolecule, bond_records_add_to_distances) {
  const std::string atoms = atom(1, "NA  ", "  NA", 0, "NA") + atom(2, " O1 ", " LIG", 2.3f, "O") +
                            atom(3, " O2 ", " LIG", 9, "O");
  EXPECT_EQ(read("t.pdb", atoms).scene.shapes.cones.size(), 0u);
  EXPECT_EQ(read("t.pdb", atoms + "CONECT    1    2\nCONECT    2    1\n").scene.shapes.cones.size(),
            2u);
  EXPECT_TRUE(
      holds(read("t.pdb", atoms + "CONECT    1    3\nCONECT    1   77    1\n").warnings.at(0),
            "more than 4 angstroms"));
}

TEST(FindBonds, equal_the_brute_ones) {
  std::vector<Atom> atoms;
  std::uint64_t state = 1;
  const auto random = [&] {
    state = state * 6364136223846793005u + 1442695040888963407u;
    return static_cast<float>(state >> 40) * 0x1p-24f;
  };
  const std::uint8_t elements[] = {1, 6, 7, 8, 16, 26};
  for (int i = 0; i < 2000; ++i) {
    Atom a;
    a.position = {25 * random() - 12, 25 * random(), 25 * random()};
    a.element = elements[static_cast<int>(6 * random())];
    atoms.push_back(a);
  }
  std::vector<Bond> brute;
  for (std::uint32_t a = 0; a < atoms.size(); ++a)
    for (std::uint32_t b = a + 1; b < atoms.size(); ++b) {
      const float d = length(atoms[a].position - atoms[b].position);
      const float reach =
          covalent_radius(atoms[a].element) + covalent_radius(atoms[b].element) + 0.4f;
      if (d > 0.4f && d < reach && !(atoms[a].element == 1 && atoms[b].element == 1))
        brute.push_back({a, b});
    }
  Warnings warnings("t");
  EXPECT_GT(brute.size(), 100u);
  EXPECT_EQ(find_bonds(atoms, {}, warnings), brute);
  EXPECT_TRUE(warnings.lines().empty());
}

TEST(FindBonds, heaps_of_atoms_end) {
  std::vector<Atom> atoms(30000);
  for (std::size_t i = 0; i < atoms.size(); ++i) {
    atoms[i].element = 6;
    atoms[i].position = {static_cast<float>(i) * 1e-5f, 0, 0};
  }
  Warnings warnings("t");
  find_bonds(atoms, {}, warnings);
  EXPECT_EQ(warnings.lines().size(), 1u);
}

TEST(ReadMolecule, errors_name_the_line) {
  const auto error = [](const std::string& text) { return error_of([&] { read("t.pdb", text); }); };
  const std::string good = atom(1, " C1 ", " LIG", 0, "C");
  EXPECT_TRUE(holds(error("HEADER    NOTHING\nEND\n"), "t.pdb: there are no atoms"));
  EXPECT_TRUE(holds(error(""), "no atoms"));
  EXPECT_TRUE(holds(error(good + good.substr(0, 50)), "t.pdb:2: the atom's line ends"));
  EXPECT_TRUE(holds(error(good + "ATOM"), "t.pdb:2: the atom's line ends"));
  std::string nan = good;
  nan.replace(30, 8, "     nan");
  EXPECT_TRUE(holds(error(good + nan), "t.pdb:2: the coordinate `nan`"));
  std::string blank = good;
  blank.replace(38, 8, "        ");
  EXPECT_TRUE(holds(error(blank), "t.pdb:1: the coordinate ``"));
}

const std::string cif_head =
    "data_T\nloop_\n_atom_site.type_symbol\n_atom_site.label_atom_id\n_atom_site.label_alt_id\n"
    "_atom_site.label_comp_id\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n"
    "_atom_site.auth_asym_id\n_atom_site.auth_seq_id\n_atom_site.pdbx_PDB_model_num\n";

TEST(ReadMolecule, mmcif) {
  const Scene scene = read("t.cif", cif_head +
                                        "C C1 . LIG 0 0 0 A 1 1\nO \"O1'\" A LIG 1.2 0 0 A 1 1\n"
                                        "O \"O1'\" B LIG 1.3 0 0 A 1 1\nC C1 . LIG 5 5 5 A 1 2\n"
                                        "O O . HOH 9 9 9 A 2 1\n")
                          .scene;
  EXPECT_EQ(scene.shapes.spheres.size(), 2u);
  EXPECT_EQ(scene.shapes.cones.size(), 2u);
  EXPECT_EQ(symbol_of(scene, 1), "O");
}

TEST(ReadMolecule, broken_mmcif_names_the_line) {
  const auto error = [](const std::string& text) { return error_of([&] { read("t.cif", text); }); };
  EXPECT_TRUE(holds(error(cif_head + "C C1 . LIG 0 0 0 A 1\n"),
                    "t.cif:2: broken mmCIF: Wrong number of values"));
  EXPECT_TRUE(holds(error(cif_head + "C C1 . LIG 0 nan 0 A 1 1\n"), "t.cif:2: atom 1 of the list"));
  EXPECT_TRUE(holds(error(cif_head + "C C1 . LIG 0 ? 0 A 1 1\n"), "t.cif:2: atom 1 of the list"));
  EXPECT_TRUE(holds(error("data_T\n_cell.length_a 3\n"), "t.cif: there are no atoms"));
  EXPECT_TRUE(holds(error("garbage"), "t.cif:1: broken mmCIF"));
  EXPECT_TRUE(holds(error("data_T\nloop_\n_a.b\n_a.b\n1 2\n"), "duplicate"));
}

}  // namespace
}  // namespace penumbra
