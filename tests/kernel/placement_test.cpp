// SPDX-License-Identifier: MIT
#include "penumbra/kernel/placement.h"

#include <gtest/gtest.h>

#include "penumbra/kernel/kernel.h"
#include "penumbra/kernel/space-inl.h"
#include "tests/kernel/nasty_instances.h"

namespace penumbra {
namespace {

using nasty::Random;

constexpr ShapeKind kinds[] = {ShapeKind::sphere, ShapeKind::cone, ShapeKind::ring,
                               ShapeKind::triangle};

/// Groups of one kind each, and sometimes shapes beside them.
ShapeSet random_instances(const nasty::Place& place, Random& random) {
  ShapeSet shapes;
  if (random.one_in(2))
    shapes = nasty::random_shapes(kinds[random.below(4)], 1 + random.below(12), place, random);
  for (std::uint32_t i = 0, groups = 1 + random.below(3); i < groups; ++i) {
    ShapeSet group =
        nasty::random_shapes(kinds[random.below(4)], 1 + random.below(30), place, random);
    if (own_primitive_count(group) > 0) nasty::add_group(std::move(group), place, random, shapes);
  }
  return shapes;
}

std::vector<std::uint32_t> all_active(const LightSamples& rays) {
  std::vector<std::uint32_t> words((rays.count + 31) / 32, 0xffffffffu);
  words.back() >>= 32 * words.size() - rays.count;
  return words;
}

/// Calls f(kernel, brute, rays) for packets that aim at what is placed.
template <class F>
void for_random_packets(std::uint64_t seed, int scenes, F&& f) {
  Random random(seed);
  for (int scene = 0; scene < scenes; ++scene) {
    const nasty::Place place = nasty::random_place(random);
    const ShapeSet shapes = random_instances(place, random), flat = flattened(shapes);
    const std::vector<ShapeRef> refs = all_primitives(flat);
    if (refs.empty()) continue;
    const Kernel wide(shapes, {}), brute(shapes, {KernelKind::brute, {}});
    for (int packet = 0; packet < 100; ++packet)
      f(wide, brute, nasty::random_packet(flat, refs, place, 1 + random.below(70), random));
  }
}

/// Every box on the way to a record holds the record's own box, so that no walk that finds the
/// record in brute force can miss it in the tree.
int boxes_that_leak(const WideTree& tree, NodeRef ref, const Placement& placement, const Box& box) {
  if (ref.is_leaf()) {
    int leaks = 0;
    for (std::uint32_t i = 0; i < ref.count(); ++i)
      leaks += !box.contains(bounds(placed(tree.records[ref.first() + i], placement)));
    return leaks;
  }
  const WideNode& node = tree.nodes[ref.node()];
  WideNode world;
  HWY_NAMESPACE::place(node, placement, world);
  int leaks = 0;
  for (int child = 0; child < WideNode::width; ++child) {
    if (!(node.used >> child & 1)) continue;
    leaks += boxes_that_leak(tree, node.child[child], placement, box_of(world, child));
  }
  return leaks;
}

TEST(Placement, BoxesOfPlacedNodesHoldThePlacedRecords) {
  Random random(1);
  int placements = 0;
  for (int scene = 0; scene < 2000; ++scene) {
    const nasty::Place place = nasty::random_place(random);
    const Kernel kernel(random_instances(place, random), {});
    const WideTree& tree = kernel.tree();
    for (const Placement& placement : tree.placements) {
      const WideTree& group = tree.groups[placement.group];
      ASSERT_EQ(boxes_that_leak(group, NodeRef::inner(0), placement, {}), 0) << "scene " << scene;
      for (const Record& record : group.records)
        ASSERT_TRUE(placement.box.contains(bounds(placed(record, placement)))) << "scene " << scene;
      ++placements;
    }
  }
  EXPECT_GT(placements, 4000);
}

/// Groups in the plane x = 0 whose placed records leave it: a ring, turned by what a map is off a
/// similarity; a corner so far out that an entry counts that float has no number for.
TEST(Placement, BoxesHoldWhatRoundingTurnsOutOfTheirPlane) {
  ShapeSet turned, lost;
  turned.groups.resize(1), lost.groups.resize(1);
  turned.groups[0].rings.push_back({{}, {1, 0, 0}, 1, 0, 0});
  turned.instances = {{0, {{1, 0x1p-23, 0}, {0, 1, 0}, {0, 0, 1}, {}}}};
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {0, 1e15f, 0}, {0, 0, 1}}, mesh.triangles = {{0, 1, 2}};
  lost.groups[0].meshes = {mesh};
  lost.instances = {{0, {{1, 0, 0}, {1e-46, 1, 0}, {0, 0, 1}, {}}}};
  for (const ShapeSet& shapes : {turned, lost}) {
    const Kernel kernel(shapes, {});
    const Placement& placement = kernel.tree().placements[0];
    EXPECT_TRUE(placement.box.contains(bounds(kernel.records()[0])));
    WideNode root;
    HWY_NAMESPACE::place(kernel.tree().groups[0].nodes.front(), placement, root);
    EXPECT_TRUE(bounds(root).contains(bounds(kernel.records()[0])));
  }
}

TEST(Placement, HierarchyGivesWhatBruteForceGives) {
  std::uint64_t hits = 0, blocked = 0;
  for_random_packets(2, 250,
                     [&](const Kernel& wide, const Kernel& brute, const LightSamples& rays) {
                       const std::vector<std::uint32_t> active = all_active(rays);
                       std::vector<std::uint32_t> by_wide(active.size()), by_brute(active.size()),
                           singly(active.size());
                       wide.occluded(rays, active, by_wide);
                       brute.occluded(rays, active, by_brute);
                       RecentRecords recent;
                       wide.occluded_singly(rays, active, recent, singly);
                       ASSERT_EQ(by_wide, by_brute);
                       ASSERT_EQ(singly, by_brute);
                       const Ray one{rays.origin, {rays.x[0], rays.y[0], rays.z[0]}, 0, rays.t_max};
                       const auto found = wide.closest(one).hit, expected = brute.closest(one).hit;
                       ASSERT_EQ(found.has_value(), expected.has_value());
                       if (found) {
                         ASSERT_EQ(found->t, expected->t);
                         ASSERT_EQ(found->shape, expected->shape);
                       }
                       hits += found.has_value(), blocked += by_wide[0] != 0;
                     });
  EXPECT_GT(hits, 1000u);
  EXPECT_GT(blocked, 5000u);
}

/// A record that is asked for by its index is the one that a traversal met under it.
TEST(Placement, WhatBlocksIsTheRecordOfItsIndex) {
  for_random_packets(3, 60, [&](const Kernel& kernel, const Kernel&, const LightSamples& rays) {
    const std::vector<std::uint32_t> active = all_active(rays);
    std::vector<std::uint32_t> blocked(active.size()), by_one(active.size());
    const OccludedReport report = kernel.occluded(rays, active, blocked);
    if (report.blocker == no_record) return;
    occluded_among(kernel.records(), {&report.blocker, 1}, rays, active, by_one);
    EXPECT_NE(by_one, std::vector<std::uint32_t>(active.size()));
    for (std::size_t i = 0; i < active.size(); ++i) EXPECT_EQ(by_one[i] & ~blocked[i], 0u);
  });
}

/// Meshes that no map mirrors have the same corners in the same order, spheres the same numbers:
/// the same bits, whether they are instances or not.
TEST(Placement, InstancesAreHitAsTheShapesThatTheyAre) {
  Random random(4);
  std::uint64_t hits = 0;
  for (int scene = 0; scene < 100; ++scene) {
    const nasty::Place place = nasty::random_place(random);
    ShapeSet shapes;
    for (const ShapeKind kind : {ShapeKind::sphere, ShapeKind::triangle})
      nasty::add_group(nasty::random_shapes(kind, 1 + random.below(20), place, random), place,
                       random, shapes);
    for (Instance& instance : shapes.instances)
      if (determinant(instance.placement) < 0) {
        instance.placement = {};
        instance.placement.offset = Vec3d(random.in_cube() * place.scale);
      }
    const ShapeSet flat = flattened(shapes);
    const std::vector<ShapeRef> refs = all_primitives(flat);
    if (refs.empty()) continue;
    const Kernel placed(shapes, {}), plain(flat, {});
    EXPECT_EQ(placed.records().size(), plain.records().size());
    EXPECT_EQ(placed.bounds().lo, plain.bounds().lo);
    EXPECT_EQ(placed.bounds().hi, plain.bounds().hi);
    for (int packet = 0; packet < 100; ++packet) {
      const LightSamples rays = nasty::random_packet(flat, refs, place, 40, random);
      const std::vector<std::uint32_t> active = all_active(rays);
      std::vector<std::uint32_t> one(active.size()), other(active.size());
      placed.occluded(rays, active, one);
      plain.occluded(rays, active, other);
      ASSERT_EQ(one, other);
      const Ray ray{rays.origin, {rays.x[0], rays.y[0], rays.z[0]}};
      const auto found = placed.closest(ray).hit, expected = plain.closest(ray).hit;
      ASSERT_EQ(found.has_value(), expected.has_value());
      if (!found) continue;
      ASSERT_EQ(found->t, expected->t);
      EXPECT_NE(found->shape.instance, 0u);
      ++hits;
    }
  }
  EXPECT_GT(hits, 500u);
}

TEST(Placement, AGroupIsStoredOnce) {
  Random random(5);
  const nasty::Place place;
  ShapeSet shapes;
  shapes.groups.push_back(nasty::random_shapes(ShapeKind::triangle, 2000, place, random));
  for (int i = 0; i < 1000; ++i)
    shapes.instances.push_back({0, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {3.0 * i, 0, 0}}});
  const Kernel kernel(shapes, {});
  const std::size_t group = own_primitive_count(shapes.groups[0]);
  EXPECT_EQ(kernel.records().size(), 1000 * group);
  EXPECT_LT(kernel.memory_bytes(), 150 * group + 600 * 1000);
}

}  // namespace
}  // namespace penumbra
