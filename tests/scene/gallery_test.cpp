// SPDX-License-Identifier: MIT
#include "penumbra/scene/gallery.h"

#include <algorithm>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "penumbra/scene/b_dna.h"
#include "penumbra/scene/complete_scene.h"
#include "penumbra/scene/error.h"

namespace penumbra {
namespace {

const Scene& scene_named(const std::string& name) {
  static std::map<std::string, Scene> made;  // the bust takes most of a second
  if (!made.contains(name)) made[name] = gallery_scene(name).value();
  return made[name];
}

std::size_t objects(const std::string& name) { return primitive_count(scene_named(name).shapes); }

TEST(Gallery, CountsAreThoseOfThePaper) {
  EXPECT_EQ(objects("balls:3"), 822u);
  EXPECT_EQ(objects("balls:4"), 7383u);
  EXPECT_EQ(objects("balls"), 7383u);
  EXPECT_EQ(objects("rings"), 62u);
  EXPECT_EQ(objects("cylinders"), 11u);
  EXPECT_EQ(objects("molecule"), 1685u);
  EXPECT_NEAR(static_cast<double>(objects("bust")), 98506, 0.03 * 98506);
}

TEST(Gallery, CountsFollowTheClosedForms) {
  EXPECT_EQ(objects("balls:1"), 12u);
  EXPECT_EQ(objects("balls:5"), 66432u);
  EXPECT_EQ(objects("rings:1"), 62u);
  EXPECT_EQ(objects("rings:3"), 842u);
  EXPECT_EQ(objects("rings:7"), 8402u);
}

TEST(Gallery, BallsAgreeWithTheSpdFile) {
  const std::vector<Sphere> balls = scene_named("balls:1").shapes.spheres;
  EXPECT_EQ(balls[0].center, Vec3f{});
  EXPECT_EQ(balls[1].center, (Vec3f{0.272166f, 0.272166f, 0.544331f}));
  EXPECT_EQ(balls[1].radius, 0.166667f);
  // The SPD's rounding noise is part of its files.
  EXPECT_EQ(balls[2].center, (Vec3f{0.643951f, 0.172546f, 1.11022e-16f}));
  EXPECT_EQ(balls[9].center, (Vec3f{0.471405f, -0.471405f, 1.11022e-16f}));
  EXPECT_EQ(scene_named("balls:4").shapes.spheres[4].radius, 0.00617284f);
}

TEST(Gallery, BallsStandOnTheirFloor) {
  const Scene& scene = scene_named("balls:4");
  float lowest = 1;
  for (const Sphere& s : scene.shapes.spheres) lowest = std::min(lowest, s.center.z - s.radius);
  EXPECT_EQ(lowest, -0.5f);
  EXPECT_TRUE(scene.shapes.meshes[0].is_backdrop);
  EXPECT_EQ(scene.shapes.meshes[0].positions[0], (Vec3f{12, 12, -0.5f}));
}

TEST(Gallery, RingsAgreeWithTheSpdFile) {
  const Scene& scene = scene_named("rings");
  const Cone& first = scene.shapes.cones[0];
  EXPECT_EQ(first.base, (Vec3f{0.930995f, 2.61313f, 0}));
  EXPECT_EQ(first.apex, (Vec3f{0.287693f, 1.7277f, 0}));
  EXPECT_EQ(first.base_radius, 0.07412f);
  const std::vector<Vec3f>& wall = scene.shapes.meshes[0].positions;
  EXPECT_EQ(wall[0], (Vec3f{2.27965f, 5.22625f, 3.77965f}));
  EXPECT_EQ(wall[2], (Vec3f{-4.27965f, 5.22625f, -2.77965f}));
  EXPECT_EQ(scene.camera->from, (Vec3d{-1, -2.61313f, 0.5}));
}

TEST(Gallery, EverySceneIsCompleteAndSoft) {
  for (const char* name : {"balls:2", "rings", "cylinders", "molecule", "bust"}) {
    const Scene& scene = scene_named(name);
    EXPECT_EQ(scene.name, name);
    EXPECT_TRUE(scene.camera.has_value()) << name;
    EXPECT_TRUE(scene.background.has_value()) << name;
    EXPECT_FALSE(scene.wants_ground) << name;
    for (const Light& light : scene.lights)
      EXPECT_TRUE(std::holds_alternative<BallLight>(light.shape)) << name;
    EXPECT_EQ(complete_scene(scene, {}).lights.size(), scene.lights.size());
    const auto backdrops = std::count_if(scene.shapes.meshes.begin(), scene.shapes.meshes.end(),
                                         [](const Mesh& mesh) { return mesh.is_backdrop; });
    EXPECT_EQ(backdrops, 1) << name;
  }
  EXPECT_EQ(scene_named("cylinders").lights.size(), 2u);
  EXPECT_EQ(scene_named("molecule").lights.size(), 2u);
  EXPECT_EQ(scene_named("bust").lights.size(), 1u);
}

TEST(Gallery, OtherNamesAreNoScenes) {
  for (const char* name : {"", "ball", "bust:2", "cylinders:", "scene.nff", "ballsy:3"})
    EXPECT_FALSE(gallery_scene(name).has_value()) << name;
  for (const char* name : {"balls:0", "balls:7", "balls:", "balls:3x", "balls:-1", "rings:8",
                           "rings:99999999999999999999", "balls: 3"})
    EXPECT_THROW(gallery_scene(name), Error) << name;
}

TEST(Gallery, HelpNamesEveryScene) { EXPECT_EQ(gallery_help().size(), 5u); }

TEST(Gallery, BustIsOneClosedManifold) {
  const Scene& scene = scene_named("bust");
  const Mesh& bust = scene.shapes.meshes[0];
  ASSERT_FALSE(bust.is_backdrop);
  const MeshTopology shape = topology(bust);
  EXPECT_EQ(shape.is_closed, std::vector<bool>{true});
  EXPECT_EQ(shape.boundary_edges, 0u);
  EXPECT_EQ(shape.nonmanifold_edges, 0u);
  EXPECT_EQ(bust.normals.size(), bust.positions.size());
  double volume = 0;
  std::size_t agreeing = 0;
  for (const Triangle& t : bust.triangles) {
    const Vec3d a(bust.positions[t[0]]), b(bust.positions[t[1]]), c(bust.positions[t[2]]);
    volume += dot(a, cross(b, c)) / 6;
    agreeing += dot(cross(b - a, c - a), Vec3d(bust.normals[t[0]])) > 0;
  }
  EXPECT_GT(volume, 1);  // outside is outside
  EXPECT_GT(agreeing, bust.triangles.size() * 99 / 100);
}

TEST(Gallery, BustStandsOnTheGround) {
  const Scene& scene = scene_named("bust");
  EXPECT_NEAR(bounds(scene.shapes.meshes[0]).lo.z, scene.shapes.meshes[1].positions[0].z, 0.01);
}

TEST(BDna, HasTheAtomsAndBondsOfItsSequence) {
  const detail::Duplex duplex = detail::b_dna("TGCTATAATGATTCGATAC");
  EXPECT_EQ(duplex.atoms.size(), 19u * 41 - 6);
  EXPECT_EQ(duplex.bonds.size(), 19u * 46 - 8);
  EXPECT_EQ(duplex.hydrogen_bonds.size(), 13u * 2 + 6 * 3);
}

TEST(BDna, BondsHaveChemicalLengths) {
  const detail::Duplex duplex = detail::b_dna("ACGT");
  const auto distance = [&](detail::Bond bond) {
    return length(duplex.atoms[bond.first].position - duplex.atoms[bond.second].position);
  };
  for (detail::Bond bond : duplex.bonds) {
    EXPECT_GT(distance(bond), 1.15);
    EXPECT_LT(distance(bond), 1.7);
  }
  for (detail::Bond bond : duplex.hydrogen_bonds) {
    EXPECT_GT(distance(bond), 2.65);
    EXPECT_LT(distance(bond), 3.1);
  }
}

TEST(BDna, BothStrandsAreWhole) {
  const detail::Duplex duplex = detail::b_dna("GATTACA");
  std::vector<std::size_t> strand(duplex.atoms.size());
  for (std::size_t i = 0; i < strand.size(); ++i) strand[i] = i;
  for (std::size_t pass = 0; pass < strand.size(); ++pass) {
    bool has_changed = false;
    for (detail::Bond bond : duplex.bonds) {
      const std::size_t low = std::min(strand[bond.first], strand[bond.second]);
      has_changed |= strand[bond.first] != low || strand[bond.second] != low;
      strand[bond.first] = strand[bond.second] = low;
    }
    if (!has_changed) break;
  }
  EXPECT_EQ(std::set<std::size_t>(strand.begin(), strand.end()).size(), 2u);
}

}  // namespace
}  // namespace penumbra
