// SPDX-License-Identifier: MIT
#include "penumbra/shadow/offset.h"

#include <gtest/gtest.h>

#include "penumbra/shadow/record_hull.h"
#include "tests/shadow/offset_trials.h"

namespace penumbra {
namespace {

using nasty::Random;

Record ball(Vec3f center, float radius) {
  ShapeSet shapes;
  shapes.spheres.push_back({center, radius, 0});
  return only_record(shapes);
}

Record cylinder(Vec3f base, Vec3f apex, float radius) {
  ShapeSet shapes;
  shapes.cones.push_back({base, apex, radius, radius, Caps::capped, 0});
  return only_record(shapes);
}

Record ring(Vec3f center, float radius, float inner) {
  ShapeSet shapes;
  shapes.rings.push_back({center, {0, 0, 1}, radius, inner, 0});
  return only_record(shapes);
}

Record triangle(Vec3f a, Vec3f b, Vec3f c) {
  Mesh mesh;
  mesh.positions = {a, b, c};
  mesh.triangles = {{0, 1, 2}};
  ShapeSet shapes;
  shapes.meshes.push_back(mesh);
  return only_record(shapes);
}

const Box scene{{-10, -10, -10}, {10, 10, 10}};

/// Where, on the way from lo (not missed) to hi (missed), misses begin: `at(x)` gives record and p.
template <typename F>
double first_miss(double lo, double hi, F&& misses) {
  EXPECT_FALSE(misses(lo));
  EXPECT_TRUE(misses(hi));
  for (int i = 0; i < 40; ++i) {
    const double middle = (lo + hi) / 2;
    (misses(middle) ? hi : lo) = middle;
  }
  return hi;
}

TEST(Offset, OfASphereUnderABallIsALargerSphere) {
  const LightHull light(BallLight{{0, 0, 8}, 0.5f}, scene);
  for (double t : {0.0, 0.25, 1.0}) {
    const double gap = first_miss(0, 5, [&](double x) {
      return surely_misses_offset(ball({float(x), 0, 4}, 1), light, {0, 0, 0}, t);
    });
    EXPECT_NEAR(gap, 1 + t * 0.5, 1e-4);
  }
}

TEST(Offset, OfATriangleUnderABallHasARoundEdge) {
  const LightHull light(BallLight{{0, 0, 8}, 0.5f}, scene);
  const double beside = first_miss(0, 5, [&](double x) {
    const auto e = float(x);
    return surely_misses_offset(triangle({e, -2, 4}, {e, 2, 4}, {e + 3, 0, 5}), light, {0, 0, 0},
                                0.5);
  });
  EXPECT_NEAR(beside, 0.25, 1e-4);
  const double corner = first_miss(0, 5, [&](double x) {
    const auto e = float(x);
    return surely_misses_offset(triangle({e, e, 4}, {e + 3, e, 4}, {e, e + 3, 4}), light, {0, 0, 0},
                                0.5);
  });
  EXPECT_NEAR(corner, 0.25 / std::sqrt(2.0), 1e-4);
}

TEST(Offset, OfACylinderUnderABallHasARoundRim) {
  const LightHull light(BallLight{{0, 0, 8}, 0.5f}, scene);
  const double side = first_miss(0, 5, [&](double x) {
    return surely_misses_offset(cylinder({float(x), -2, 4}, {float(x), 2, 4}, 0.75f), light,
                                {0, 0, 0}, 1);
  });
  EXPECT_NEAR(side, 1.25, 1e-4);
  const double cap = first_miss(0, 5, [&](double x) {
    return surely_misses_offset(cylinder({float(x), 0, 4}, {float(x) + 3, 0, 4}, 0.75f), light,
                                {0, 0, 0}, 1);
  });
  EXPECT_NEAR(cap, 0.5, 1e-4);
}

TEST(Offset, UnderAParallelogramHasItsEdges) {
  const LightHull light(ParallelogramLight{{0, 0, 8}, {0.5f, 0, 0}, {0, 0.25f, 0}}, scene);
  const double along_u = first_miss(0, 5, [&](double x) {
    return surely_misses_offset(ball({float(x), 0, 4}, 1), light, {0, 0, 0}, 1);
  });
  EXPECT_NEAR(along_u, 1.5, 1e-4);
  const double along_v = first_miss(0, 5, [&](double y) {
    const auto e = float(y);
    return surely_misses_offset(triangle({-1, e, 4}, {1, e, 4}, {0, e + 2, 3}), light, {0, 0, 0},
                                1);
  });
  EXPECT_NEAR(along_v, 0.25, 1e-4);
}

TEST(Offset, UnderASunIsAsWideAsTheSunAtItsReach) {
  const LightHull light(SunLight{{0, 0, 1}, 0.01f}, scene);
  const double reach = light.center({}).z, t = 4 / reach;
  const double gap = first_miss(0, 5, [&](double x) {
    return surely_misses_offset(ball({float(x), 0, 3}, 1), light, {0, 0, 0}, t);
  });
  EXPECT_NEAR(gap, 1 + 4 * std::tan(0.01), 2e-4);
}

TEST(Offset, ARaysWayThroughARingsHoleIsFree) {
  const LightHull light(BallLight{{0, 0, 8}, 0.5f}, scene);
  EXPECT_TRUE(surely_misses_offset(ring({0, 0, 4}, 2, 1), light, {0, 0, 0}, 1));
  EXPECT_TRUE(surely_misses_offset(ring({0.45f, 0, 4}, 2, 1), light, {0, 0, 0}, 1));
  EXPECT_FALSE(surely_misses_offset(ring({0.55f, 0, 4}, 2, 1), light, {0, 0, 0}, 1));
  EXPECT_TRUE(surely_misses_offset(ring({0.55f, 0, 4}, 2, 1), light, {0, 0, 0}, 0.5));
  EXPECT_FALSE(surely_misses_offset(ring({0, 0, 4}, 2, 0), light, {0, 0, 0}, 1));
}

TEST(Offset, BoundsAreTheOccludersGrownByTheLight) {
  const Box box{{-1, -2, 3}, {1, 2, 4}};
  const Box grown = offset_bounds(
      box, LightHull(ParallelogramLight{{0, 0, 8}, {0.5f, 0, 0}, {0, 0.25f, 0.125f}}, scene), 0.5,
      scene);
  EXPECT_TRUE(grown.contains({{-1.25f, -2.125f, 2.9375f}, {1.25f, 2.125f, 4.0625f}}));
  EXPECT_NEAR(grown.hi.x, 1.25, 1e-3);
  EXPECT_NEAR(grown.lo.y, -2.125, 1e-3);
  EXPECT_NEAR(grown.hi.z, 4.0625, 1e-3);
}

TEST(Offset, InDoubtProvesNothing) {
  const float nan = std::numeric_limits<float>::quiet_NaN(), inf = HUGE_VALF;
  const LightHull light(BallLight{{0, 0, 8}, 0.5f}, scene);
  const Record records[] = {ball({0, 0, -4}, 1), cylinder({0, 0, -3}, {0, 0, -2}, 1),
                            ring({0, 0, -3}, 1, 0), triangle({-1, 0, -2}, {1, 0, -2}, {0, 1, -2})};
  for (const Record& record : records) {
    EXPECT_TRUE(surely_misses_offset(record, light, {0, 0, 0}, 1));
    for (Vec3f p : {Vec3f{nan, 0, 0}, Vec3f{0, inf, 0}, Vec3f{0, 0, -inf}}) {
      EXPECT_FALSE(surely_misses_offset(record, light, p, 1));
      EXPECT_FALSE(surely_behind_horizon(record, light, p));
    }
    Record broken = record;
    broken.number[1] = nan;
    EXPECT_FALSE(surely_misses_offset(broken, light, {0, 0, 0}, 1));
  }
  EXPECT_FALSE(surely_misses_offset(ball({3, 0, 4}, 1), light, {0, 0, 0}, nan));
  EXPECT_FALSE(surely_misses_offset(ball({0, 0, 0}, 1), light, {0, 0, 0}, 1));
  EXPECT_FALSE(surely_misses_offset(ball({0, 0, 8}, 1), light, {0, 0, 0}, 1));
}

/// Points of a shape whose tangent plane leaves the light some height above it.
struct OwnPoints {
  int all = 0, decided = 0;
};

OwnPoints decided_by_horizon(const ShapeForm& form, float least_height) {
  OwnPoints count;
  for (std::uint64_t seed = 0; seed < 3'000; ++seed) {
    Random random(seed);
    const nasty::Place place = nasty::random_place(random);
    const ShapeSet shapes = random_shape(form, place, random);
    const Kernel kernel(shapes, {KernelKind::brute, {}});
    const Record record = only_record(shapes);
    for (int i = 0; i < 8; ++i) {
      const auto own = trials::own_point(shapes, kernel, place, random);
      if (!own || (own->is_back && record.kind <= ShapeKind::cone)) continue;
      const Vec3f p = receiver_position(*own), n(own->normal);
      const Vec3f across = cross(n, trials::random_direction(random));
      const float size = place.scale * random.power(-2, 0);
      const Vec3f center = p + across * (place.scale * random.uniform(0, 5)) +
                           n * (size + place.scale * least_height);
      Box all = bounds(record);
      all.add(p);
      const LightHull light(BallLight{center, size}, all);
      ++count.all, count.decided += surely_behind_horizon(record, light, p);
    }
  }
  return count;
}

TEST(Horizon, DecidesTheSurfaceThatPLiesOn) {
  for (const ShapeForm& form : shape_forms) {
    const OwnPoints count = decided_by_horizon(form, 0.1f);
    EXPECT_GT(count.all, 1000) << form.name;
    EXPECT_GT(count.decided, count.all * 0.998) << form.name;
  }
}

}  // namespace
}  // namespace penumbra
