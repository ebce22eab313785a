// SPDX-License-Identifier: MIT
// Triangles that a ray passes by, by their edge planes, are none that it hits, on every instruction
// set.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "tests/geometry/instruction_sets.h"
#include "tests/kernel/nasty_shapes.h"

// Highway compiles the rest once for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/kernel/edge_planes_test.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

#include "penumbra/kernel/edge_planes-inl.h"
#include "penumbra/kernel/intersect-inl.h"

HWY_BEFORE_NAMESPACE();
namespace penumbra::HWY_NAMESPACE {

/// Everything times a power of two, so that nothing is lost but what under- or overflows.
inline void scale(Record& record, LightSamples& rays, nasty::Random& random) {
  const int power = static_cast<int>(random.below(240)) - 120;
  for (float& number : record.number) number = std::ldexp(number, power);
  for (int axis = 0; axis < 3; ++axis) rays.origin[axis] = std::ldexp(rays.origin[axis], power);
  const int longer = static_cast<int>(random.below(240)) - 120;
  for (auto* direction : {&rays.x, &rays.y, &rays.z})
    for (float& number : *direction) number = std::ldexp(number, longer);
}

/// (ray, triangle) pairs: all, those whose line meets the triangle, those where the ray passes by,
/// and those of which both is said.
std::array<std::uint64_t, 4> Count(std::uint64_t pairs, std::uint64_t seed, bool extreme) {
  const hn::CappedTag<float, 16> d;
  nasty::Random random(seed);
  std::array<std::uint64_t, 4> counts{};
  while (counts[0] < pairs) {
    const nasty::Place place = nasty::random_place(random);
    const ShapeSet shapes = nasty::random_shapes(ShapeKind::triangle, 4, place, random);
    LightSamples rays = nasty::random_packet(shapes, all_primitives(shapes), place, 64, random);
    for (const ShapeRef ref : all_primitives(shapes)) {
      Record record = make_record(shapes, ref, 0);
      LightSamples scaled = rays;
      if (extreme) scale(record, scaled, random);
      const EdgePlanes planes = edge_planes(record, scaled.origin);
      for (std::uint32_t i = 0; i < scaled.count; i += hn::Lanes(d)) {
        const auto x = hn::LoadU(d, &scaled.x[i]), y = hn::LoadU(d, &scaled.y[i]),
                   z = hn::LoadU(d, &scaled.z[i]);
        const auto ray = make_ray_lanes(d, x, y, z);
        auto met = hn::FirstN(d, 0);
        intersect_triangle(d, record, scaled.origin, ray,
                           [&](auto, auto hit) { met = hn::Or(met, hit); });
        const auto passes = passes_by(d, planes, x, y, z);
        counts[0] += hn::Lanes(d), counts[1] += hn::CountTrue(d, met);
        counts[2] += hn::CountTrue(d, passes);
        counts[3] += hn::CountTrue(d, hn::And(met, passes));
      }
    }
  }
  return counts;
}

}  // namespace penumbra::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace penumbra {
namespace {

HWY_EXPORT(Count);

void expect_no_hit_is_passed_by(std::uint64_t pairs, bool extreme) {
  for_each_instruction_set([&] {
    const auto counts = HWY_DYNAMIC_DISPATCH(Count)(pairs, 12, extreme);
    EXPECT_GT(counts[1], pairs / 20);
    EXPECT_EQ(counts[3], 0u);
    const std::uint64_t missed = counts[0] - counts[1];
    EXPECT_GT(counts[2], extreme ? missed / 4 : missed * 9 / 10);
  });
}

TEST(EdgePlanes, NoRayHitsATriangleThatItPassesBy) { expect_no_hit_is_passed_by(2'000'000, false); }

TEST(EdgePlanes, NorAtTheEndsOfFloat) { expect_no_hit_is_passed_by(2'000'000, true); }

TEST(SlowEdgePlanes, NoRayHitsATriangleThatItPassesBy) {
  expect_no_hit_is_passed_by(40'000'000, false);
  expect_no_hit_is_passed_by(40'000'000, true);
}

}  // namespace
}  // namespace penumbra
#endif
