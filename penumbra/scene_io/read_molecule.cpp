// SPDX-License-Identifier: MIT
// PDB and mmCIF: atoms as balls, bonds as sticks.
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "penumbra/scene_io/atoms.h"
#include "penumbra/scene_io/elements.h"
#include "penumbra/scene_io/source.h"
#include "penumbra/scene_io/text_lines.h"

namespace penumbra {

namespace {

constexpr float ball_scale = 0.25f;    ///< of the van der Waals radius
constexpr float stick_radius = 0.15f;  ///< angstroms; below the smallest ball's 0.25

/// One material an element, made when the first atom of it is met.
class Materials {
 public:
  explicit Materials(Scene& scene) : scene_(scene) {}

  std::uint32_t of(std::uint8_t element) {
    auto& index = known_[element];
    if (index) return *index;
    Material material;
    material.name = element_symbol(element);
    material.diffuse = element_color(element);
    material.highlight = {0.25f, 0.25f, 0.25f};
    material.shininess = 50;
    index = static_cast<std::uint32_t>(scene_.materials.size());
    scene_.materials.push_back(std::move(material));
    return *index;
  }

 private:
  Scene& scene_;
  std::array<std::optional<std::uint32_t>, 256> known_;
};

/// How far from an atom's centre its sticks begin: inside the ball with their whole open end.
float stick_start(float ball_radius) {
  return 0.9f * std::sqrt(ball_radius * ball_radius - stick_radius * stick_radius);
}

void add_stick(Scene& scene, const Sphere& a, const Sphere& b) {
  const Vec3f axis = normalize(b.center - a.center);
  const Vec3f from = a.center + axis * stick_start(a.radius);
  const Vec3f to = b.center - axis * stick_start(b.radius);
  if (!(dot(to - from, axis) > 0)) return;  // the balls hide all of it
  const auto add = [&](Vec3f base, Vec3f apex, std::uint32_t surface) {
    scene.shapes.cones.push_back({base, apex, stick_radius, stick_radius, Caps::open, surface});
  };
  if (a.surface == b.surface) return add(from, to, a.surface);
  const Vec3f middle = (from + to) * 0.5f;
  add(from, middle, a.surface);
  add(middle, to, b.surface);
}

bool is_mmcif(const Source& source) {
  if (source.extension == "cif" || source.extension == "mmcif") return true;
  return trimmed(std::string_view(source.bytes).substr(0, 4096)).starts_with("data_");
}

}  // namespace

Scene read_molecule(const Source& source, const ReadOptions& options, Warnings& warnings) {
  Molecule molecule = is_mmcif(source) ? read_mmcif(source, warnings) : read_pdb(source, warnings);
  Scene scene;
  scene.name = source.path.string();
  if (molecule.atoms.empty())
    throw Error({scene.name, {}, {}}, "there are no atoms in the file",
                "is this a PDB or mmCIF file?");
  const std::vector<Atom> atoms = select_atoms(std::move(molecule.atoms), options, warnings);
  if (atoms.empty())
    throw Error({scene.name, {}, {}}, "there is nothing but water in the file",
                "ask for the waters too");

  const bool has_sticks = options.style == MoleculeStyle::ball_and_stick;
  Materials materials(scene);
  std::vector<Sphere>& balls = scene.shapes.spheres;
  for (const Atom& atom : atoms) {
    if (atom.element == 0)
      warnings.add("an atom of unknown element is drawn pink, with the radius 1");
    const float radius = van_der_waals_radius(atom.element);
    balls.push_back(
        {atom.position, has_sticks ? ball_scale * radius : radius, materials.of(atom.element)});
  }
  if (has_sticks)
    for (const Bond& bond : find_bonds(atoms, molecule.bonded_serials, warnings))
      add_stick(scene, balls[bond[0]], balls[bond[1]]);
  scene.wants_ground = true;
  return scene;
}

}  // namespace penumbra
