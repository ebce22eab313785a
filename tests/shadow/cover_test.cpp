// SPDX-License-Identifier: MIT
#include "penumbra/shadow/cover.h"

#include <gtest/gtest.h>

#include <chrono>
#include <limits>

#include "tests/shadow/cover_trials.h"

namespace penumbra {
namespace {

using trials::LightKind;
using trials::Occluder;
using trials::OccluderKind;
using trials::Random;

Record record_of(const ShapeSet& shapes) {
  return make_record(shapes, all_primitives(shapes).front(), 0);
}

Box scene_box(const ShapeSet& shapes, Vec3f p) {
  Box box = bounds(shapes);
  box.add(p);
  return box;
}

bool covers(const ShapeSet& shapes, const LightShape& light, Vec3f p) {
  return surely_covers(record_of(shapes), LightHull(light, scene_box(shapes, p)), p);
}

ShapeSet sphere(Vec3f center, float radius) {
  ShapeSet shapes;
  shapes.spheres.push_back({center, radius, 0});
  return shapes;
}

ShapeSet cone(const Cone& c) {
  ShapeSet shapes;
  shapes.cones.push_back(c);
  return shapes;
}

ShapeSet ring(const Ring& r) {
  ShapeSet shapes;
  shapes.rings.push_back(r);
  return shapes;
}

ShapeSet triangle(Vec3f a, Vec3f b, Vec3f c) {
  ShapeSet shapes;
  Mesh& mesh = shapes.meshes.emplace_back();
  mesh.positions = {a, b, c}, mesh.triangles = {{0, 1, 2}};
  return shapes;
}

/// Ball of radius 3 at distance 12 from one of radius 1: the umbra is a cone of length 6 and half
/// angle asin(1/6) behind it.
TEST(Cover, ABallEclipsesABallExactlyInItsUmbraCone) {
  const ShapeSet shapes = sphere({0, 0, 0}, 1);
  const BallLight light{{0, 0, 12}, 3};
  const double sine = 1.0 / 6;
  EXPECT_TRUE(covers(shapes, light, {0, 0, -5.999f}));
  EXPECT_FALSE(covers(shapes, light, {0, 0, -6.001f}));
  for (double z = 0.5; z < 6; z += 0.5) {
    const double radius = (6 - z) * sine / std::sqrt(1 - sine * sine);
    if (z * z + radius * radius < 1) continue;  // in the ball
    EXPECT_TRUE(covers(shapes, light, Vec3f(Vec3d{radius * 0.999, 0, -z}))) << z;
    EXPECT_FALSE(covers(shapes, light, Vec3f(Vec3d{0, radius * 1.001, -z}))) << z;
  }
}

TEST(Cover, ABallHidesTheSunUpToItsOwnAngle) {
  const ShapeSet shapes = sphere({0, 0, 10}, 1);
  const double angle = std::asin(0.1);
  EXPECT_TRUE(covers(shapes, SunLight{{0, 0, 1}, float(angle * 0.98)}, {0, 0, 0}));
  EXPECT_FALSE(covers(shapes, SunLight{{0, 0, 1}, float(angle * 1.001)}, {0, 0, 0}));
  EXPECT_FALSE(covers(shapes, SunLight{{0, 0, -1}, float(angle * 0.5)}, {0, 0, 0}));
}

TEST(Cover, ALongCylinderHidesWhatItsTwoTangentPlanesHold) {
  const BallLight light{{0, 0, 10}, 0.5f};  // half angle asin(0.05) seen from 0
  for (Caps caps : {Caps::open, Caps::capped}) {
    const auto covered = [&](float radius) {
      return covers(cone({{-50, 0, 5}, {50, 0, 5}, radius, radius, caps, 0}), light, {0, 0, 0});
    };
    EXPECT_TRUE(covered(0.251f));
    EXPECT_FALSE(covered(0.249f));
  }
}

TEST(Cover, ATubeHidesNothingBehindItsOpenEnds) {
  const BallLight light{{0, 0, 10}, 0.5f};
  const Cone along{{0, 0, 3}, {0, 0, 5}, 1, 1, Caps::open, 0};
  Cone closed = along;
  closed.caps = Caps::capped;
  EXPECT_FALSE(covers(cone(along), light, {0, 0, 0}));
  EXPECT_TRUE(covers(cone(closed), light, {0, 0, 0}));
  // In through the side, out through an end: blocked on the way in.
  EXPECT_TRUE(covers(cone({{0, 0, -20}, {0, 0, 8}, 3, 3, Caps::open, 0}), light, {-9, 0, 0}));
  // The other way round; and from inside.
  EXPECT_TRUE(covers(cone({{0, 0, 5}, {0, 0, 50}, 3, 3, Caps::open, 0}),
                     BallLight{{9, 0, 20}, 0.5f}, {0, 0, 0}));
  EXPECT_TRUE(covers(cone({{-50, 0, 0}, {50, 0, 0}, 1, 1, Caps::open, 0}), light, {0, 0, 0}));
  EXPECT_FALSE(covers(cone({{0, 0, -5}, {0, 0, 5}, 1, 1, Caps::open, 0}), light, {0, 0, 0}));
}

TEST(Cover, AFullConeHasOneOpenEnd) {
  const BallLight light{{0, 0, 10}, 0.5f};
  EXPECT_TRUE(covers(cone({{0, 3, 4}, {0, -9, 4}, 2, 0, Caps::open, 0}), light, {0, 0, 0}));
  EXPECT_FALSE(covers(cone({{0, 0, 4}, {0, 0, 50}, 2, 1, Caps::open, 0}), light, {0, 0, 0}));
}

TEST(Cover, ADiskAndARing) {
  const BallLight light{{0, 0, 10}, 1};
  const double tangent = 1 / std::sqrt(99.0);
  EXPECT_TRUE(covers(ring({{0, 0, 5}, {0, 0, 1}, float(5 * tangent * 1.02), 0, 0}), light, {}));
  EXPECT_FALSE(covers(ring({{0, 0, 5}, {0, 0, 1}, float(5 * tangent * 0.999), 0, 0}), light, {}));
  const Ring wide{{4, 0, 5}, {0, 0, 1}, 6, 3.4f, 0};  // the light is seen 0.5 around x = -4 of it
  EXPECT_TRUE(covers(ring(wide), light, {}));
  Ring wider_hole = wide;
  wider_hole.inner_radius = 3.6f;
  EXPECT_FALSE(covers(ring(wider_hole), light, {}));
}

TEST(Cover, ATriangleHidesWhatItsThreePlanesHold) {
  const double tangent = 1 / std::sqrt(99.0);  // of the light's half angle
  for (double scale : {0.999, 1.001}) {
    const double inner = 5 * tangent * scale, far = inner * std::sqrt(3.0);
    const ShapeSet shapes = triangle(Vec3f(Vec3d{-far, -inner, 5}), Vec3f(Vec3d{far, -inner, 5}),
                                     Vec3f(Vec3d{0, 2 * inner, 5}));
    EXPECT_EQ(covers(shapes, BallLight{{0, 0, 10}, 1}, {}), scale > 1);
    EXPECT_FALSE(covers(shapes, BallLight{{0, 0, 5.9f}, 1}, {}));  // through the light
    EXPECT_FALSE(covers(shapes, BallLight{{0, 0, -10}, 1}, {}));   // behind p
    EXPECT_FALSE(covers(shapes, BallLight{{0, 0, 3}, 0.1f}, {}));  // before it
  }
}

TEST(Cover, TheLightMustBeOutside) {
  const ShapeSet room = sphere({0, 0, 0}, 10);
  EXPECT_FALSE(covers(room, BallLight{{0, 0, 5}, 1}, {0, 0, -20}));
  EXPECT_FALSE(covers(room, BallLight{{0, 0, 5}, 1}, {0, 0, 0}));
  EXPECT_FALSE(covers(room, BallLight{{0, 0, 10}, 1}, {0, 0, -20}));
  EXPECT_TRUE(covers(room, BallLight{{0, 0, 11.1f}, 1}, {0, 0, -20}));
  EXPECT_TRUE(covers(room, BallLight{{0, 0, 11.1f}, 1}, {0, 0, 3}));
}

TEST(Cover, WhatCastsNoShadowAndWhatIsNoNumberProvesNothing) {
  const ShapeSet shapes = sphere({0, 0, 0}, 1);
  const BallLight light{{0, 0, 12}, 1};
  const Vec3f p{0, 0, -2};
  ASSERT_TRUE(covers(shapes, light, p));
  Record record = record_of(shapes);
  const LightHull hull(light, scene_box(shapes, p));
  record.casts_shadow = false;
  EXPECT_FALSE(surely_covers(record, hull, p));
  const float nan = std::numeric_limits<float>::quiet_NaN(),
              infinity = std::numeric_limits<float>::infinity();
  for (float bad : {nan, infinity, -infinity}) {
    for (const auto& kind : trials::occluder_kinds) {
      Random random(31);
      const Occluder occluder = trials::make_occluder(kind, {}, random);
      for (std::size_t i = 0; i < record.number.size(); ++i) {
        Record broken = record_of(occluder.shapes);
        EXPECT_FALSE(surely_covers(broken, hull, {0, bad, -2}));
        const bool is_used = broken.kind == ShapeKind::triangle ? i < 9
                             : broken.kind == ShapeKind::sphere ? i < 4
                             : broken.kind == ShapeKind::ring   ? i < 8
                                                                : i < 9;
        broken.number[i] = bad;
        EXPECT_FALSE(is_used && surely_covers(broken, hull, p)) << kind.name << " " << i;
      }
    }
    EXPECT_FALSE(covers(shapes, BallLight{{bad, 0, 12}, 1}, p));
    EXPECT_FALSE(covers(shapes, BallLight{{0, 0, 12}, bad}, p));
    EXPECT_FALSE(covers(shapes, PointLight{{0, 0, bad}}, p));
  }
  EXPECT_FALSE(covers(sphere({0, 0, 0}, 0), light, p));
  EXPECT_FALSE(covers(sphere({0, 0, 0}, 1e-30f), light, p));
}

TEST(Cover, ABallIsCoveredByAPartOfASolid) {
  const BallLight light{{0, 0, 12}, 3};
  const Vec3f p{0, 0, -5};
  const LightHull hull(light, {{-10, -10, -10}, {10, 10, 20}});
  EXPECT_TRUE(ball_covers({0, 0, 0}, 1, hull, p, 0.01));
  EXPECT_FALSE(ball_covers({0, 0, 0}, 1, hull, p, 0.5));
  EXPECT_FALSE(ball_covers({0, 0, 40}, 30, hull, {0, 0, 0}, 0.01));  // behind the light
}

struct Trial {
  LightShape light;
  Vec3f p;
};

/// One way to look at an occluder: lights that grow or move with t, from surely hidden (if any is)
/// to surely not.
class Situation {
 public:
  Situation(const LightKind& kind, const Occluder& occluder, Random& random)
      : kind_(kind), random_(random.below(1u << 30)) {
    const Vec3d way = trials::some_direction(random);
    const double before = distance(occluder.size, random), behind = distance(occluder.size, random);
    Vec3d p = occluder.aim - way * before;
    center_ = occluder.aim + way * (random.one_in(30) ? -behind : behind);
    if (random.one_in(8)) {
      const Vec3f q = nasty::point_of_interest(occluder.shapes, occluder.ref(), random);
      p = Vec3d(q) - way * (occluder.size * (random.one_in(2) ? 0 : 1e-6));
    }
    p_ = Vec3f(p);
    const double seen = occluder.size * (1 + behind / (before + 1e-30));
    largest_ = std::min(seen, 100 * (before + behind)) * (random.one_in(2) ? 1 : 4);
    if (random.one_in(3)) {
      smallest_ = largest_ * std::pow(10.0, random.uniform(-4, -0.5f));
      shift_ = trials::some_direction(random) * (largest_ * 2);
    }
  }

  Trial at(double t) const {
    const bool is_moved = shift_ != Vec3d{};
    const double size = is_moved ? smallest_ : std::max(largest_ * t, largest_ * 1e-6);
    return {kind_.make(is_moved ? center_ + shift_ * t : center_, size, p_, random_), p_};
  }

 private:
  static double distance(double size, Random& random) {
    switch (random.below(6)) {
      case 0: return size * std::pow(10.0, random.uniform(-7, -1));
      case 1: return size * std::pow(10.0, random.uniform(0, 4));
      default: return size * random.uniform(0.1f, 4);
    }
  }

  const LightKind& kind_;
  Random random_;
  Vec3f p_;
  Vec3d center_, shift_;
  double largest_ = 0, smallest_ = 0;
};

struct Counts {
  std::uint64_t trials = 0, proven = 0, critical = 0, wrong = 0;
};

bool is_usable(const LightShape& light, Vec3f p) {
  if (!is_finite(p)) return false;
  if (const auto* ball = std::get_if<BallLight>(&light)) return ball->radius > 0;
  if (const auto* p4 = std::get_if<ParallelogramLight>(&light))
    return length(cross(Vec3d(p4->u), Vec3d(p4->v))) > 0;
  if (const auto* sun = std::get_if<SunLight>(&light)) return sun->half_angle_rad < 1.57f;
  return true;
}

/// Looks for the last t that is proven, and lets the judge have a look there.
void try_one(const OccluderKind& occluder_kind, const LightKind& light_kind, Random& random,
             const SamplePattern& pattern, Counts& counts) {
  const nasty::Place place = nasty::random_place(random);
  const Occluder occluder = trials::make_occluder(occluder_kind, place, random);
  const Situation situation(light_kind, occluder, random);
  const auto is_proven = [&](double t) {
    const Trial trial = situation.at(t);
    return is_usable(trial.light, trial.p) && covers(occluder.shapes, trial.light, trial.p);
  };
  ++counts.trials;
  if (!is_proven(0)) return;
  ++counts.proven;
  double proven = 0, unproven = 1;
  if (is_proven(1)) proven = 1;
  for (int i = 0; i < 24 && proven != 1; ++i) {
    const double middle = (proven + unproven) / 2;
    (is_proven(middle) ? proven : unproven) = middle;
  }
  counts.critical += proven > 0 && proven < 1;
  for (double t : {proven, 0.5 * proven, 0.0}) {
    if (!is_proven(t)) continue;  // a light that moves may come out from behind and go back
    const Trial trial = situation.at(t);
    const std::uint32_t free =
        trials::free_rays(record_of(occluder.shapes), trial.light, trial.p, pattern, 32, random);
    if (free == 0) continue;
    ++counts.wrong;
    ADD_FAILURE() << occluder_kind.name << ", " << light_kind.name << ": trial " << counts.trials
                  << " at t = " << t << " has " << free << " free rays";
  }
}

Counts try_many(const OccluderKind& occluder, const LightKind& light, std::uint64_t count,
                std::uint64_t seed) {
  Random random(seed);
  const SamplePattern pattern(32);
  Counts counts;
  for (std::uint64_t i = 0; i < count && counts.wrong < 5; ++i)
    try_one(occluder, light, random, pattern, counts);
  return counts;
}

void try_every_pair(std::uint64_t count, std::uint64_t seed, bool prints) {
  for (const OccluderKind& occluder : trials::occluder_kinds)
    for (const LightKind& light : trials::light_kinds) {
      const Counts counts = try_many(occluder, light, count, ++seed);
      EXPECT_EQ(counts.wrong, 0u);
      EXPECT_GT(counts.proven, count / 20) << occluder.name << ", " << light.name;
      EXPECT_GT(counts.critical, count / 40) << occluder.name << ", " << light.name;
      if (prints)
        std::printf("%-16s %-14s %8lu trials, %8lu proven, %8lu critical\n", occluder.name,
                    light.name, counts.trials, counts.proven, counts.critical);
    }
}

TEST(Cover, NoSampleIsFreeWhereCoverIsProven) { try_every_pair(2'000, 100, false); }

TEST(SlowCover, NoSampleIsFreeWhereCoverIsProven) { try_every_pair(400'000, 1000, true); }

/// Of the triples whose 256 samples are all blocked, which share is proven: one occluder about as
/// large as the light's shaft, one to ten times its extent from p and from the light.
struct Tightness {
  std::uint64_t blocked = 0, proven = 0;
  double share() const { return static_cast<double>(proven) / static_cast<double>(blocked); }
};

Tightness tightness(const OccluderKind& occluder_kind, const LightKind& light_kind,
                    std::uint64_t count, std::uint64_t seed) {
  Random random(seed);
  const SamplePattern pattern(256);
  Tightness result;
  while (result.blocked < count) {
    const Occluder occluder = trials::make_occluder(occluder_kind, {}, random);
    const Vec3d way = trials::some_direction(random);
    const double extent = length(Vec3d(bounds(occluder.shapes).size()));
    const auto distance = [&] { return extent * std::pow(10.0, random.uniform(0, 1)); };
    const double before = distance(), behind = distance();
    const Vec3f p(occluder.aim - way * before);
    const double size =
        occluder.size * (1 + behind / before) * std::pow(10.0, random.uniform(-2, 0));
    const LightShape light =
        light_kind.make(occluder.aim + way * behind, size, p, Random(random.below(1u << 30)));
    if (!is_usable(light, p) || contains(light, p)) continue;
    if (trials::free_rays(record_of(occluder.shapes), light, p, pattern, 0, random) > 0) continue;
    ++result.blocked;
    result.proven += covers(occluder.shapes, light, p);
  }
  return result;
}

TEST(SlowCover, ProvesNearlyAllUmbraOfOneOccluder) {
  for (const OccluderKind& occluder : trials::occluder_kinds)
    for (const LightKind& light : trials::light_kinds) {
      const Tightness result = tightness(occluder, light, 20'000, 200);
      EXPECT_GT(result.share(), 0.7) << occluder.name << ", " << light.name;
      std::printf("%-16s %-14s %.4f\n", occluder.name, light.name, result.share());
    }
}

}  // namespace
}  // namespace penumbra
