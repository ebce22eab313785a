// SPDX-License-Identifier: MIT
#include "penumbra/kernel/kernel.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "penumbra/kernel/embree_baseline.h"
#include "penumbra/kernel/traverse.h"
#include "tests/kernel/nasty_shapes.h"

namespace penumbra {
namespace {

using nasty::Random;

std::vector<std::uint32_t> all_active(const LightSamples& rays) {
  std::vector<std::uint32_t> words((rays.count + 31) / 32, 0);
  for (std::uint32_t i = 0; i < rays.count; ++i) words[i / 32] |= 1u << i % 32;
  return words;
}

/// Rays and packets of one kind through both kernels; every answer must be the same, bit for bit.
struct Duel {
  std::uint64_t rays = 0, blocked = 0, hits = 0;
  std::uint64_t different_packets = 0, different_hits = 0;
};

void duel_once(const Kernel& wide, const Kernel& brute, const LightSamples& rays, Random& random,
               Duel& duel) {
  std::vector<std::uint32_t> active = all_active(rays);
  if (random.one_in(4))
    for (std::uint32_t& word : active)
      word &= static_cast<std::uint32_t>(random.below(0xffffffffu));
  std::vector<std::uint32_t> by_wide(active.size()), by_brute(active.size());
  wide.occluded(rays, active, by_wide);
  brute.occluded(rays, active, by_brute);
  duel.rays += rays.count;
  duel.different_packets += by_wide != by_brute;
  for (std::uint32_t word : by_brute)
    duel.blocked += static_cast<std::uint64_t>(__builtin_popcount(word));
  const Ray one{
      rays.origin, {rays.x[0], rays.y[0], rays.z[0]}, random.one_in(4) ? 0.25f : 0, rays.t_max};
  const auto near_wide = wide.closest(one).hit, near_brute = brute.closest(one).hit;
  duel.hits += near_brute.has_value();
  if (near_wide.has_value() != near_brute.has_value())
    ++duel.different_hits;
  else if (near_wide && (near_wide->t != near_brute->t || near_wide->shape != near_brute->shape))
    ++duel.different_hits;
}

Duel fight(ShapeKind kind, std::uint64_t rays, std::uint64_t seed) {
  Random random(seed);
  Duel duel;
  while (duel.rays < rays) {
    const nasty::Place place = nasty::random_place(random);
    const ShapeSet shapes = nasty::random_shapes(kind, 1 + random.below(24), place, random);
    const std::vector<ShapeRef> refs = all_primitives(shapes);
    if (refs.empty()) continue;
    const Kernel wide(shapes, {}), brute(shapes, {KernelKind::brute, {}});
    for (int packet = 0; packet < 200; ++packet)
      duel_once(wide, brute,
                nasty::random_packet(shapes, refs, place, 1 + random.below(70), random), random,
                duel);
  }
  return duel;
}

constexpr std::uint64_t fast_rays = 1'000'000, slow_rays = 20'000'000;

class KernelDuel : public testing::TestWithParam<ShapeKind> {};

TEST_P(KernelDuel, HierarchyGivesWhatBruteForceGives) {
  const Duel duel = fight(GetParam(), fast_rays, 1);
  EXPECT_EQ(duel.different_packets, 0u);
  EXPECT_EQ(duel.different_hits, 0u);
  EXPECT_GT(duel.blocked, duel.rays / 100);  // the rays do meet things
  EXPECT_LT(duel.blocked, duel.rays * 99 / 100);
  EXPECT_GT(duel.hits, 0u);
}

constexpr auto kinds = {ShapeKind::sphere, ShapeKind::cone, ShapeKind::ring, ShapeKind::triangle};
INSTANTIATE_TEST_SUITE_P(EachKind, KernelDuel, testing::ValuesIn(kinds));

class SlowKernelDuel : public testing::TestWithParam<ShapeKind> {};

TEST_P(SlowKernelDuel, HierarchyGivesWhatBruteForceGives) {
  const Duel duel = fight(GetParam(), slow_rays, 2);
  EXPECT_EQ(duel.different_packets, 0u);
  EXPECT_EQ(duel.different_hits, 0u);
}

INSTANTIATE_TEST_SUITE_P(Slow, SlowKernelDuel, testing::ValuesIn(kinds));

/// A closed mesh with a hole nowhere: a sphere of n x 2n quads, split.
Mesh ball_mesh(std::uint32_t n) {
  Mesh mesh;
  mesh.positions.push_back({0, 0, 1});
  for (std::uint32_t i = 1; i < n; ++i)
    for (std::uint32_t k = 0; k < 2 * n; ++k) {
      const float a = 3.14159265f * static_cast<float>(i) / static_cast<float>(n);
      const float b = 3.14159265f * static_cast<float>(k) / static_cast<float>(n);
      mesh.positions.push_back({std::sin(a) * std::cos(b), std::sin(a) * std::sin(b), std::cos(a)});
    }
  mesh.positions.push_back({0, 0, -1});
  const auto last = static_cast<std::uint32_t>(mesh.positions.size()) - 1;
  const auto at = [&](std::uint32_t i, std::uint32_t k) {
    return i == 0 ? 0 : i == n ? last : 1 + (i - 1) * 2 * n + k % (2 * n);
  };
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t k = 0; k < 2 * n; ++k) {
      if (i > 0) mesh.triangles.push_back({at(i, k), at(i + 1, k), at(i, k + 1)});
      if (i + 1 < n) mesh.triangles.push_back({at(i, k + 1), at(i + 1, k), at(i + 1, k + 1)});
    }
  return mesh;
}

TEST(Kernel, NoRayLeavesAClosedMeshThroughItsEdgesAndCorners) {
  ShapeSet shapes;
  shapes.meshes.push_back(ball_mesh(20));
  const Kernel kernel(shapes, {});
  const Mesh& mesh = shapes.meshes.front();
  Random random(3);
  for (int i = 0; i < 200'000; ++i) {
    const Vec3f origin = random.in_cube() * 0.5f;
    const Triangle& t =
        mesh.triangles[random.below(static_cast<std::uint32_t>(mesh.triangles.size()))];
    const Vec3f a = mesh.positions[t[0]], b = mesh.positions[t[1]];
    const Vec3f target = random.one_in(2) ? a : a + (b - a) * random.uniform(0, 1);
    ASSERT_TRUE(kernel.closest({origin, target - origin}).hit) << "ray " << i;
  }
}

TEST(Kernel, SurfacesThatCastNoShadowBlockNothingButAreSeen) {
  ShapeSet shapes;
  shapes.spheres = {{{0, 0, 0}, 1, 0}, {{5, 0, 0}, 1, 1}};
  const Kernel kernel(shapes, {KernelKind::wide, {true, false}});
  LightSamples rays;
  rays.resize(2);
  rays.origin = {0, 0, 4};
  rays.x = {0, 10}, rays.y = {0, 0}, rays.z = {-8, -8};
  rays.x.resize(16, 0), rays.y.resize(16, 0), rays.z.resize(16, 1);
  std::uint32_t active = 3, blocked = 0;
  kernel.occluded(rays, {&active, 1}, {&blocked, 1});
  EXPECT_EQ(blocked, 2u);
  EXPECT_TRUE(kernel.closest({{0, 0, 4}, {0, 0, -1}}).hit);
}

TEST(Kernel, SegmentsAreOpen) {
  ShapeSet shapes;
  shapes.rings.push_back({{0, 0, 0}, {0, 0, 1}, 1, 0, 0});
  const Kernel kernel(shapes, {});
  EXPECT_FALSE(kernel.closest({{0, 0, 1}, {0, 0, -1}, 0, 1}).hit);  // ends on the ring
  EXPECT_FALSE(kernel.closest({{0, 0, 0}, {0, 0, -1}, 0, 1}).hit);  // starts on it
  EXPECT_TRUE(kernel.closest({{0, 0, 1}, {0, 0, -1}, 0, 1.0001f}).hit);
}

TEST(Kernel, NothingToHitIsNoError) {
  const Kernel kernel(ShapeSet{}, {});
  EXPECT_FALSE(kernel.closest({{0, 0, 0}, {1, 0, 0}}).hit);
}

TEST(Kernel, RaysThatAreNotANumberHitNothingAndDoNotHang) {
  ShapeSet shapes;
  shapes.meshes.push_back(ball_mesh(8));
  const Kernel kernel(shapes, {});
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_FALSE(kernel.closest({{nan, 0, 0}, {1, 0, 0}}).hit);
  EXPECT_FALSE(kernel.closest({{0, 0, 0}, {nan, 1, 0}}).hit);
  EXPECT_FALSE(kernel.closest({{0, 0, 0}, {0, 0, 0}}).hit);
}

/// Embree's triangles and spheres are tested by other code than ours: away from edges both must
/// agree.
TEST(Kernel, AgreesWithEmbreeOnMeshesAndSpheres) {
  ShapeSet shapes;
  shapes.meshes.push_back(ball_mesh(30));
  Random random(4);
  for (int i = 0; i < 200; ++i)
    shapes.spheres.push_back({random.in_cube() * 3.0f, random.uniform(0.01f, 0.3f), 0});
  const Kernel kernel(shapes, {});
  const EmbreeBaseline embree(shapes);
  int different = 0, hits = 0;
  for (int i = 0; i < 100'000; ++i) {
    const Ray ray{random.in_cube() * 4.0f, random.in_cube()};
    const auto ours = kernel.closest(ray).hit, theirs = embree.closest(ray);
    hits += ours.has_value();
    if (ours.has_value() != theirs.has_value() ||
        (ours && std::abs(ours->t - theirs->t) > 1e-4f * (1 + theirs->t)))
      ++different;
  }
  EXPECT_GT(hits, 10'000);
  EXPECT_LE(different, 20);  // grazing rays
}

}  // namespace
}  // namespace penumbra
