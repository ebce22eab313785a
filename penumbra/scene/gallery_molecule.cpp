// SPDX-License-Identifier: MIT
// B-DNA as balls and sticks: 19 base pairs around the TATAAT of bacterial promoters, nearly two
// turns, in ångström. 1,685 objects: 773 atoms, 866 bonds, 44 hydrogen bonds, and a ground of two
// triangles.
#include <array>
#include <cmath>
#include <numbers>

#include "penumbra/scene/b_dna.h"
#include "penumbra/scene/gallery_scenes.h"
#include "penumbra/scene/image.h"

namespace penumbra::detail {

namespace {

constexpr std::string_view sequence = "TGCTATAATGATTCGATAC";

enum Surface : std::uint32_t { ground_surface, stick_surface, pairing_surface, first_element };

/// How an element looks: Jmol's colour, and a ball of 0.4 of the van der Waals radius (Bondi
/// 1964).
struct Look {
  const char* name;
  std::array<float, 3> srgb;
  double van_der_waals;
};
constexpr std::array<Look, 4> looks{{{"carbon", {144, 144, 144}, 1.70},
                                     {"nitrogen", {48, 80, 248}, 1.55},
                                     {"oxygen", {255, 13, 13}, 1.52},
                                     {"phosphorus", {255, 128, 0}, 1.80}}};

Material shiny(std::string name, Color diffuse) {
  Material material = matte(std::move(name), diffuse);
  material.highlight = {0.3f, 0.3f, 0.3f};
  material.shininess = 50;
  return material;
}

void add_materials(std::vector<Material>& materials) {
  materials.push_back(matte("ground", {0.62f, 0.62f, 0.61f}));
  materials.push_back(shiny("bond", {0.5f, 0.5f, 0.5f}));
  materials.push_back(shiny("hydrogen bond", {0.75f, 0.72f, 0.6f}));
  for (const Look& look : looks)
    materials.push_back(shiny(
        look.name, {linear_from_srgb(look.srgb[0] / 255), linear_from_srgb(look.srgb[1] / 255),
                    linear_from_srgb(look.srgb[2] / 255)}));
}

/// Lays the helix axis into the picture: rolled about itself, tilted up, and turned.
Vec3d placed(Vec3d p) {
  constexpr double degree = std::numbers::pi / 180;
  constexpr double roll = 40 * degree, tilt = 84 * degree, turn = 38 * degree;
  p = {p.x * std::cos(roll) - p.y * std::sin(roll), p.x * std::sin(roll) + p.y * std::cos(roll),
       p.z};
  p = {p.x * std::cos(tilt) + p.z * std::sin(tilt), p.y,
       p.z * std::cos(tilt) - p.x * std::sin(tilt)};
  return {p.x * std::cos(turn) - p.y * std::sin(turn), p.x * std::sin(turn) + p.y * std::cos(turn),
          p.z};
}

void add_sticks(ShapeSet& shapes, const std::vector<Bond>& bonds, float radius, Surface surface) {
  for (const Bond& bond : bonds)
    shapes.cones.push_back({shapes.spheres[bond.first].center, shapes.spheres[bond.second].center,
                            radius, radius, Caps::open, surface});
}

}  // namespace

Scene molecule_scene() {
  Scene scene;
  add_materials(scene.materials);
  ShapeSet& shapes = scene.shapes;
  const Duplex duplex = b_dna(sequence);
  for (const Atom& atom : duplex.atoms) {
    const auto element = static_cast<std::uint32_t>(atom.element);
    const auto radius = static_cast<float>(0.4 * looks[element].van_der_waals);
    shapes.spheres.push_back({Vec3f(placed(atom.position)), radius, first_element + element});
  }
  add_sticks(shapes, duplex.bonds, 0.24f, stick_surface);
  add_sticks(shapes, duplex.hydrogen_bonds, 0.1f, pairing_surface);

  const Box box = object_bounds(shapes);
  const Vec3f middle = box.center();
  const float ground = box.lo.z, wide = 1500;
  shapes.meshes.push_back(backdrop_quad(
      {middle.x - wide, middle.y - wide, ground}, {middle.x + wide, middle.y - wide, ground},
      {middle.x + wide, middle.y + wide, ground}, {middle.x - wide, middle.y + wide, ground},
      ground_surface));
  Camera camera;
  camera.at = Vec3d(middle) + Vec3d{-1.5, 0, -5};
  camera.from = camera.at + Vec3d{5, -92, 66};
  camera.fov_deg = 32;
  scene.camera = camera;
  scene.background = Color{0.62f, 0.68f, 0.76f};
  scene.ambient = {0.16f, 0.16f, 0.17f};
  scene.lights = {ball_light(middle + Vec3f{-90, -45, 95}, 9, 0.7f),
                  ball_light(middle + Vec3f{95, -60, 70}, 3, 0.22f)};
  return scene;
}

}  // namespace penumbra::detail
