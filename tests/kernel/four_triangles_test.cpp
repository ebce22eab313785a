// SPDX-License-Identifier: MIT
// Triangles that a ray is said to pass by are none that it hits, on every instruction set.
#include <gtest/gtest.h>

#include <array>

#include "tests/geometry/instruction_sets.h"
#include "tests/kernel/nasty_shapes.h"

// Highway compiles the rest once for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/kernel/four_triangles_test.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

#include "penumbra/kernel/four_triangles-inl.h"
#include "penumbra/kernel/intersect-inl.h"

HWY_BEFORE_NAMESPACE();
namespace penumbra::HWY_NAMESPACE {

/// Four of the shapes' triangles, the last standing in for those that are missing.
inline std::array<Record, 4> four_records(const ShapeSet& shapes) {
  const std::vector<ShapeRef> refs = all_primitives(shapes);
  std::array<Record, 4> records;
  for (std::uint32_t i = 0; i < 4; ++i)
    records[i] = make_record(shapes, refs[std::min<std::size_t>(i, refs.size() - 1)], i);
  return records;
}

/// (ray, triangle) pairs: all, those whose line meets the triangle, those that are said to pass it
/// by, and those of which both is said. `ShapeKind` of the third record, to be left alone.
std::array<std::uint64_t, 4> Count(std::uint64_t pairs, std::uint64_t seed, ShapeKind third) {
  const hn::CappedTag<float, 1> d;
  nasty::Random random(seed);
  std::array<std::uint64_t, 4> counts{};
  while (counts[0] < pairs) {
    const nasty::Place place = nasty::random_place(random);
    const ShapeSet shapes = nasty::random_shapes(ShapeKind::triangle, 4, place, random);
    std::array<Record, 4> records = four_records(shapes);
    records[2].kind = third;
    const Record* const four[] = {&records[0], &records[1], &records[2], &records[3]};
    const LightSamples rays =
        nasty::random_packet(shapes, all_primitives(shapes), place, 64, random);
    const FourTriangles triangles(four, rays.origin);
    for (std::uint32_t i = 0; i < rays.count; ++i) {
      const auto ray =
          make_ray_lanes(d, hn::Set(d, rays.x[i]), hn::Set(d, rays.y[i]), hn::Set(d, rays.z[i]));
      const Shear shear{hn::GetLane(ray.shear_x), hn::GetLane(ray.shear_y),
                        static_cast<int>(hn::GetLane(ray.axis))};
      std::uint8_t passed[8] = {};
      hn::StoreMaskBits(FourTriangles::D(), triangles.passed_by(shear), passed);
      for (int k = 0; k < 4; ++k) {
        bool met = false;
        intersect_triangle(d, records[k], rays.origin, ray, [&](auto, auto) { met = true; });
        const bool is_passed = passed[0] >> k & 1;
        ++counts[0], counts[1] += met, counts[2] += is_passed;
        counts[3] += is_passed && (met || records[k].kind != ShapeKind::triangle);
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

void expect_no_hit_is_passed_by(std::uint64_t pairs, ShapeKind third) {
  int in_lanes = 0;
  for_each_instruction_set([&] {
    const auto counts = HWY_DYNAMIC_DISPATCH(Count)(pairs, 11, third);
    EXPECT_GT(counts[1], pairs / 20);
    EXPECT_EQ(counts[3], 0u);
    if (counts[2] == 0) return;  // a single lane
    ++in_lanes;
    const bool are_all = third == ShapeKind::triangle;
    EXPECT_GT(counts[1] + counts[2], are_all ? counts[0] * 99 / 100 : 0);
  });
  EXPECT_GT(in_lanes, 0);
}

TEST(FourTriangles, NoRayHitsOneThatItPassesBy) {
  expect_no_hit_is_passed_by(2'000'000, ShapeKind::triangle);
}

TEST(FourTriangles, OtherShapesAreLeftToTheIntersector) {
  expect_no_hit_is_passed_by(100'000, ShapeKind::cone);
}

TEST(SlowFourTriangles, NoRayHitsOneThatItPassesBy) {
  expect_no_hit_is_passed_by(40'000'000, ShapeKind::triangle);
}

}  // namespace
}  // namespace penumbra
#endif
