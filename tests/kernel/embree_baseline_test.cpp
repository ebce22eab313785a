// SPDX-License-Identifier: MIT
// The competitor must answer the same questions: away from edges all its variants agree with us.
#include "penumbra/kernel/embree_baseline.h"

#include <gtest/gtest.h>

#include <bit>
#include <string>

#include "tests/kernel/nasty_shapes.h"

namespace penumbra {
namespace {

using nasty::Random;

/// Spheres, open and capped cones, rings and triangles in a cube of edge 2.
ShapeSet some_of_each(Random& random) {
  ShapeSet shapes;
  const auto radius = [&] { return random.uniform(0.01f, 0.2f); };
  for (int i = 0; i < 40; ++i) {
    shapes.spheres.push_back({random.in_cube(), radius(), 0});
    const Vec3f base = random.in_cube(), apex = base + random.in_cube() * 0.3f;
    const float apex_radius = i % 3 == 0 ? 0 : radius();
    shapes.cones.push_back(
        {base, apex, radius(), apex_radius, i % 2 == 0 ? Caps::capped : Caps::open, 0});
    const float outer = radius();
    shapes.rings.push_back(
        {random.in_cube(), normalize(random.in_cube()), outer, i % 2 == 0 ? 0 : outer / 2, 0});
  }
  Mesh mesh;
  for (std::uint32_t i = 0; i < 100; ++i) {
    const Vec3f corner = random.in_cube();
    for (int k = 0; k < 3; ++k) mesh.positions.push_back(corner + random.in_cube() * 0.2f);
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  shapes.meshes.push_back(mesh);
  return shapes;
}

LightSamples rays_through(std::uint32_t count, Random& random) {
  LightSamples rays;
  rays.resize(count);
  rays.origin = normalize(random.in_cube()) * 3.0f;
  for (std::size_t k = 0; k < rays.x.size(); ++k) {
    const Vec3f d = random.in_cube() * 1.2f - rays.origin;
    rays.x[k] = 2 * d.x, rays.y[k] = 2 * d.y, rays.z[k] = 2 * d.z;
  }
  return rays;
}

MixedRays mixed(const LightSamples& rays) {
  MixedRays copy;
  copy.resize(rays.count);
  copy.t_max = rays.t_max;
  for (std::uint32_t k = 0; k < rays.count; ++k)
    copy.set(k, rays.origin, {rays.x[k], rays.y[k], rays.z[k]});
  return copy;
}

int bits_of(const std::vector<std::uint32_t>& words) {
  int bits = 0;
  for (const std::uint32_t word : words) bits += std::popcount(word);
  return bits;
}

class EveryKindOfSpheres : public testing::TestWithParam<EmbreeSpheres> {};
INSTANTIATE_TEST_SUITE_P(EmbreeBaseline, EveryKindOfSpheres,
                         testing::Values(EmbreeSpheres::native, EmbreeSpheres::user));

TEST_P(EveryKindOfSpheres, BlocksWhatTheKernelBlocks) {
  Random random(5);
  const ShapeSet shapes = some_of_each(random);
  const Kernel kernel(shapes, {});
  const EmbreeBaseline embree(shapes, GetParam());
  int blocked = 0, different = 0;
  for (int i = 0; i < 3'000; ++i) {
    const LightSamples rays = rays_through(40, random);
    const MixedRays same = mixed(rays);
    const std::vector<std::uint32_t> active = {0xffff7fffu, 0xefu};
    std::vector<std::uint32_t> ours(2), theirs(2), of_mixed(2);
    kernel.occluded(rays, active, ours);
    blocked += bits_of(ours);
    for (const EmbreeVariant variant : embree.variants()) {
      embree.occluded(variant, rays, active, theirs);
      embree.occluded(variant, same, active, of_mixed);
      EXPECT_EQ(theirs, of_mixed) << name_of(variant);
      different += bits_of({ours[0] ^ theirs[0], ours[1] ^ theirs[1]});
    }
  }
  EXPECT_GT(blocked, 20'000);
  EXPECT_LE(different, 60);  // grazing rays, some for every variant
}

TEST(EmbreeBaseline, TellsItsMemory) {
  Random random(6);
  EXPECT_GT(EmbreeBaseline(some_of_each(random)).memory_bytes(), 10'000u);
}

}  // namespace
}  // namespace penumbra
