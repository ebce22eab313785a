// SPDX-License-Identifier: MIT
// Shafts down the hierarchy against brute force: no record that blocks a ray of the shaft lies in a
// leaf that the walk passes by.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "penumbra/kernel/kernel.h"
#include "tests/kernel/nasty_shapes.h"

namespace penumbra {
namespace {

using nasty::Place;
using nasty::Random;

struct Count {
  std::uint64_t shafts = 0, rays = 0, blocked = 0;
  std::uint64_t records = 0, visited = 0;  ///< of which a shaft's walk could have spared some
};

/// Flat along some axes, a point often.
Box random_box(Vec3f middle, float scale, Random& random) {
  Box box{middle, middle};
  if (random.one_in(4)) return box;
  const float size = scale * random.power(-7, 1);
  for (int axis = 0; axis < 3; ++axis) {
    if (random.one_in(3)) continue;
    const float half = size * (random.one_in(2) ? 1 : random.power(-3, 0));
    box.lo[axis] -= half, box.hi[axis] += half;
  }
  return box;
}

/// Corners and what lies between them.
Vec3f point_of(const Box& box, Random& random) {
  Vec3f p;
  for (int axis = 0; axis < 3; ++axis) {
    const float t = random.uniform(0, 1);
    p[axis] = random.one_in(3)   ? box.lo[axis]
              : random.one_in(2) ? box.hi[axis]
                                 : box.lo[axis] + (box.hi[axis] - box.lo[axis]) * t;
    p[axis] = std::clamp(p[axis], box.lo[axis], box.hi[axis]);
  }
  return p;
}

Vec3f rounded_down(Vec3d v) { return {round_down(v.x), round_down(v.y), round_down(v.z)}; }
Vec3f rounded_up(Vec3d v) { return -rounded_down(-v); }

/// The shaft of a box of receivers and targets in a box, or of directions that many times as long.
struct Question {
  Question(const ShapeSet& shapes, const std::vector<ShapeRef>& refs, const Place& place,
           Random& random) {
    const auto interesting = [&] {
      const auto any = random.below(static_cast<std::uint32_t>(refs.size()));
      return nasty::point_of_interest(shapes, refs[any], random);
    };
    const auto somewhere = [&] {
      return random.one_in(2) ? interesting()
                              : place(random.in_cube() * (random.one_in(4) ? 10.0f : 2.0f));
    };
    bounds.receivers = random_box(somewhere(), place.scale, random);
    is_sun = random.one_in(4);
    // Grazing something, or anywhere.
    const Vec3f from = point_of(bounds.receivers, random);
    const Vec3f to =
        random.one_in(2) ? from + (interesting() - from) * random.uniform(0.9f, 3) : somewhere();
    const Vec3f way = random.one_in(2) ? Vec3f(random.direction()) : normalize(to - from);
    targets = is_sun ? random_box(way, 1, random) : random_box(to, place.scale, random);
    if (is_sun) {
      // As long as the scene is wide, whatever the direction.
      Box scene = penumbra::bounds(shapes);
      scene.add(bounds.receivers);
      reach = 8 * max_abs(scene.size()) + 1e-20f;
      bounds.least = targets.lo * reach, bounds.most = targets.hi * reach;
      return;
    }
    // A way's own rounding may take it out of the box.
    const Vec3d lo = Vec3d(targets.lo) - Vec3d(bounds.receivers.lo);
    const Vec3d hi = Vec3d(targets.hi) - Vec3d(bounds.receivers.hi);
    const double far = max_abs(Vec3d(targets.lo) - Vec3d(bounds.receivers.hi)) +
                       max_abs(Vec3d(targets.hi) - Vec3d(bounds.receivers.lo));
    const Vec3d pad = Vec3d{1, 1, 1} * (0x1p-24 * far);
    bounds.least = rounded_down(lo - pad), bounds.most = rounded_up(hi + pad);
  }

  /// From one receiver; all to targets.
  LightSamples rays(std::uint32_t count, Random& random) const {
    LightSamples rays;
    rays.resize(count);
    rays.origin = point_of(bounds.receivers, random);
    rays.t_max = is_sun ? reach : 1;
    for (std::uint32_t i = 0; i < rays.x.size(); ++i) {
      const Vec3f to = point_of(targets, random), way = is_sun ? to : to - rays.origin;
      rays.x[i] = way.x, rays.y[i] = way.y, rays.z[i] = way.z;
    }
    return rays;
  }

  ShaftBounds bounds;
  Box targets;
  bool is_sun = false;
  float reach = 1;
};

/// Turns to the half-space that holds all of one receiver's rays whose ways rise; returns these.
std::vector<std::uint32_t> look_up(const Kernel& kernel, const LightSamples& rays, Vec3f up,
                                   ShaftBounds& bounds) {
  const Box scene = kernel.bounds();
  const double extent =
      max_abs(scene.size()) + max_abs(scene.lo) + max_abs(scene.hi) + max_abs(rays.origin);
  bounds.up = up;
  bounds.floor = static_cast<float>(dot(Vec3d(up), Vec3d(rays.origin)) - 0x1p-17 * extent);
  std::vector<std::uint32_t> active((rays.count + 31) / 32);
  for (std::uint32_t i = 0; i < rays.count; ++i) {
    const Vec3d way{double(rays.x[i]), double(rays.y[i]), double(rays.z[i])};
    active[i / 32] |= std::uint32_t{dot(Vec3d(up), way) >= 0} << i % 32;
  }
  return active;
}

/// By record: whether its leaf is visited.
std::vector<bool> visited_records(const Kernel& kernel, const ShaftBounds& bounds) {
  std::vector<bool> visited(kernel.records().size());
  const bool is_ended =
      walk(kernel.tree(), bounds, [&](std::span<const Record> records, std::uint32_t first) {
        for (std::uint32_t i = 0; i < records.size(); ++i) visited[first + i] = true;
        return false;
      });
  EXPECT_FALSE(is_ended);
  return visited;
}

void judge(const Kernel& kernel, const std::vector<bool>& visited, const LightSamples& rays,
           const std::vector<std::uint32_t>& active, Count& count) {
  std::vector<std::uint32_t> blocked(active.size());
  const std::vector<std::uint32_t> none(active.size());
  count.rays += rays.count;
  for (std::uint32_t i = 0; i < visited.size(); ++i) {
    occluded_among(kernel.records(), {&i, 1}, rays, active, blocked);
    ++count.records, count.visited += visited[i];
    if (blocked == none) continue;
    ++count.blocked;
    ASSERT_TRUE(visited[i]) << "record " << i;
  }
}

void run(const Kernel& kernel, Question question, Random& random, Count& count) {
  ++count.shafts;
  const std::vector<bool> visited = visited_records(kernel, question.bounds);
  for (int receiver = 0; receiver < 3; ++receiver) {
    const LightSamples rays = question.rays(1 + random.below(64), random);
    std::vector<std::uint32_t> active((rays.count + 31) / 32, ~0u);
    if (rays.count % 32 != 0) active.back() = (1u << rays.count % 32) - 1;
    judge(kernel, visited, rays, active, count);
    if (testing::Test::HasFatalFailure()) return;
    active = look_up(kernel, rays, Vec3f(random.direction()), question.bounds);
    judge(kernel, visited_records(kernel, question.bounds), rays, active, count);
    if (testing::Test::HasFatalFailure()) return;
    question.bounds.up = {};
    question.bounds.floor = -std::numeric_limits<float>::infinity();
  }
}

Count run_kind(ShapeKind kind, std::uint64_t shafts, std::uint64_t first_seed) {
  Count count;
  for (std::uint64_t seed = first_seed; count.shafts < shafts; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    const Place place = nasty::random_place(random);
    const ShapeSet shapes = nasty::random_shapes(kind, 2 + random.below(60), place, random);
    const std::vector<ShapeRef> refs = all_primitives(shapes);
    if (refs.empty()) continue;
    const Kernel kernel(shapes, {});
    for (int i = 0; i < 50; ++i) {
      run(kernel, Question(shapes, refs, place, random), random, count);
      if (testing::Test::HasFatalFailure()) return count;
    }
  }
  return count;
}

constexpr ShapeKind kinds[] = {ShapeKind::sphere, ShapeKind::cone, ShapeKind::ring,
                               ShapeKind::triangle};

class WalkShaft : public testing::TestWithParam<ShapeKind> {};
using SlowWalkShaft = WalkShaft;

TEST_P(WalkShaft, VisitsAllThatBlocksAnyOfItsRays) {
  const Count count = run_kind(GetParam(), 1'500, 0);
  EXPECT_GT(count.blocked, count.shafts);
  EXPECT_LT(count.visited, count.records * 3 / 4);
}

TEST_P(SlowWalkShaft, VisitsAllThatBlocksAnyOfItsRays) {
  run_kind(GetParam(), 1'000'000, 1'000'000);
}

const auto name_of_kind = [](const auto& test) {
  constexpr const char* names[] = {"sphere", "cone", "ring", "triangle"};
  return std::string(names[static_cast<std::size_t>(test.param)]);
};
INSTANTIATE_TEST_SUITE_P(Over, WalkShaft, testing::ValuesIn(kinds), name_of_kind);
INSTANTIATE_TEST_SUITE_P(Over, SlowWalkShaft, testing::ValuesIn(kinds), name_of_kind);

/// Unit balls at x = 0, 10, ..., 630, each in a leaf of a few.
struct Row {
  Row() {
    ShapeSet shapes;
    for (int i = 0; i < 64; ++i) shapes.spheres.push_back({{10.0f * float(i), 0, 0}, 1, 0});
    kernel.emplace(shapes, KernelOptions{});
  }
  std::size_t visited(const ShaftBounds& bounds) const {
    const std::vector<bool> records = visited_records(*kernel, bounds);
    return static_cast<std::size_t>(std::count(records.begin(), records.end(), true));
  }
  std::optional<Kernel> kernel;
};

TEST(WalkShaftOverARow, GoesNoFartherThanItsTargets) {
  const Row row;
  const Box receivers{{20, -1, -9}, {21, 1, -8}};
  EXPECT_LE(row.visited({receivers, {0, 0, 16}, {9, 0, 17}}), 16u);
  EXPECT_EQ(row.visited({receivers, {0, 0, 5}, {9, 0, 6}}), 0u);      // ends before them
  EXPECT_EQ(row.visited({receivers, {-90, 0, 0}, {900, 0, 0}}), 0u);  // passes them
  EXPECT_EQ(row.visited({receivers, {-90, 0, 16}, {2000, 0, 17}, {0, 0, 1}, 2}), 0u);
  EXPECT_EQ(row.visited({receivers, {-90, 0, 16}, {2000, 0, 17}, {0, 0, 1}, 0.5f}), 64u);
}

TEST(WalkShaftOverARow, WhatIsNoNumberMeetsAll) {
  const Row row;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const Box receivers{{0, 0, -9}, {630, 0, -8}};
  EXPECT_EQ(row.visited({receivers, {0, 0, 16}, {0, 0, 17}, {0, 0, nan}, 2}), 64u);
  EXPECT_EQ(row.visited({receivers, {0, 0, 16}, {0, 0, 17}, {0, 0, 1}, nan}), 64u);
}

TEST(WalkShaftOverARow, EndsWhereALeafSaysSo) {
  const Row row;
  int leaves = 0;
  const ShaftBounds all{{{0, 0, -9}, {630, 0, -8}}, {0, 0, 16}, {0, 0, 17}};
  EXPECT_TRUE(walk(row.kernel->tree(), all,
                   [&](std::span<const Record>, std::uint32_t) { return ++leaves == 2; }));
  EXPECT_EQ(leaves, 2);
  EXPECT_FALSE(walk(WideTree{}, all, [](std::span<const Record>, std::uint32_t) { return true; }));
}

}  // namespace
}  // namespace penumbra
