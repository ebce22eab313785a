// SPDX-License-Identifier: MIT
// How far the intersector is from exact geometry. Unit: ulp = 2^-24 of the reach, the largest
// distance along an axis from the ray's origin to the primitive's box.
#include <gtest/gtest.h>

#include "penumbra/kernel/kernel.h"
#include "penumbra/kernel/traverse.h"
#include "tests/kernel/exact_shapes.h"
#include "tests/kernel/nasty_shapes.h"

namespace penumbra {
namespace {

using nasty::Random;

/// Hits lie closer to the shape than this (see intersect-inl.h).
double bound_of(ShapeKind kind) {
  switch (kind) {
    case ShapeKind::sphere:
    case ShapeKind::ring: return 16;
    case ShapeKind::cone: return 32;
    case ShapeKind::triangle: break;
  }
  return 64;
}

/// Rays that pass deeper than this through a shape are hits.
constexpr double depth_bound = 8;

double reach_of(const Box& box, Vec3f origin) {
  return std::max(max_abs(Vec3d(box.lo) - Vec3d(origin)), max_abs(Vec3d(box.hi) - Vec3d(origin)));
}

struct Accuracy {
  std::uint64_t rays = 0, hits = 0, deep_misses = 0;
  double worst = 0;  // in ulp
};

void measure(const ShapeSet& shapes, const Kernel& kernel, Vec3f origin, Vec3f direction,
             Accuracy& accuracy) {
  const ShapeRef ref = all_primitives(shapes).front();
  const auto hit = kernel.closest({origin, direction}).hit;
  const exact::Line ray{exact::Vec(origin), exact::Vec(direction)};
  const double reach = reach_of(bounds(shapes, ref), origin), ulp = 0x1p-24 * reach;
  ++accuracy.rays, accuracy.hits += hit.has_value();
  exact::visit(shapes, ref, [&](const auto& shape) {
    if (hit) {
      const auto error = static_cast<double>(exact::distance(shape, ray.at(hit->t)) / ulp);
      accuracy.worst = std::max(accuracy.worst, error);
    } else {
      const double far = 4 * reach / max_abs(Vec3d(direction));
      accuracy.deep_misses += exact::surely_meets(shape, ray, depth_bound * ulp, far);
    }
  });
}

Accuracy measure_kind(ShapeKind kind, std::uint64_t rays, std::uint64_t seed) {
  Random random(seed);
  Accuracy accuracy;
  while (accuracy.rays < rays) {
    const nasty::Place place = nasty::random_place(random);
    ShapeSet shapes = nasty::random_shapes(kind, 1, place, random);
    for (Mesh& mesh : shapes.meshes) drop_degenerate_triangles(mesh);
    const std::vector<ShapeRef> refs = all_primitives(shapes);
    if (refs.empty()) continue;
    const Kernel kernel(shapes, {KernelKind::brute, {}});
    const LightSamples packet = nasty::random_packet(shapes, refs, place, 64, random);
    for (std::uint32_t i = 0; i < packet.count; ++i) {
      const Vec3f direction{packet.x[i], packet.y[i], packet.z[i]};
      if (is_finite(direction) && max_abs(direction) > 1e-18f)
        measure(shapes, kernel, packet.origin, direction, accuracy);
    }
  }
  return accuracy;
}

void expect_accurate(ShapeKind kind, const Accuracy& accuracy) {
  EXPECT_LE(accuracy.worst, bound_of(kind));
  EXPECT_EQ(accuracy.deep_misses, 0u);
  EXPECT_GT(accuracy.hits, accuracy.rays / 10);
  EXPECT_LT(accuracy.hits, accuracy.rays * 9 / 10);
}

class IntersectAccuracy : public testing::TestWithParam<ShapeKind> {};

TEST_P(IntersectAccuracy, HitsLieOnTheShapeAndDeepRaysHit) {
  expect_accurate(GetParam(), measure_kind(GetParam(), 150'000, 21));
}

constexpr auto kinds = {ShapeKind::sphere, ShapeKind::cone, ShapeKind::ring, ShapeKind::triangle};
INSTANTIATE_TEST_SUITE_P(EachKind, IntersectAccuracy, testing::ValuesIn(kinds));

class SlowIntersectAccuracy : public testing::TestWithParam<ShapeKind> {};

TEST_P(SlowIntersectAccuracy, HitsLieOnTheShapeAndDeepRaysHit) {
  expect_accurate(GetParam(), measure_kind(GetParam(), 3'000'000, 22));
}

INSTANTIATE_TEST_SUITE_P(Slow, SlowIntersectAccuracy, testing::ValuesIn(kinds));

/// Down the axis of a full cone both crossings fall into the apex: squared, half the digits go.
TEST(IntersectCone, TheApexIsSharpSeenFromInside) {
  ShapeSet shapes;
  shapes.cones.push_back({{0, 0, 0}, {0, 0, 1}, 0.25f, 0, Caps::open, 0});
  const Kernel kernel(shapes, {});
  Random random(23);
  for (int i = 0; i < 10'000; ++i) {
    const Vec3f origin{random.uniform(-0.01f, 0.01f), random.uniform(-0.01f, 0.01f), -1};
    const Vec3f target{random.uniform(-1e-5f, 1e-5f), random.uniform(-1e-5f, 1e-5f), 1};
    const Vec3f direction = target - origin;
    const auto hit = kernel.closest({origin, direction}).hit;
    const exact::Line ray{exact::Vec(origin), exact::Vec(direction)};
    if (hit) {
      ASSERT_LE(exact::distance(shapes.cones[0], ray.at(hit->t)), 0x1p-20L) << "ray " << i;
    } else {
      ASSERT_FALSE(exact::surely_meets(shapes.cones[0], ray, 0x1p-21L, 4)) << "ray " << i;
    }
  }
}

/// A ray in the plane of a cylinder's rim may not take its bearings from where that meets the axis'
/// slab: far away.
TEST(IntersectCone, RaysInTheRimsPlaneAreAccurate) {
  ShapeSet shapes;
  shapes.cones.push_back({{-1.57237482f, 0.78618741f, -0.78618741f},
                          {0, 0, -1.57237482f},
                          0.00311910314f,
                          0.00311910314f,
                          Caps::capped,
                          0});
  const Kernel kernel(shapes, {});
  const Vec3f origin{-0.000313005294f, 0.0018589627f, -1.57485974f},
      direction{-0.0014187491f, -0.00419564918f, 0.00135815144f};
  const auto hit = kernel.closest({origin, direction}).hit;
  ASSERT_TRUE(hit);
  const exact::Line ray{exact::Vec(origin), exact::Vec(direction)};
  EXPECT_LE(exact::distance(shapes.cones[0], ray.at(hit->t)), 0x1p-20L);
}

/// Through two points of a capped cone's solid that lie on its rims, its apex or (the first)
/// inside.
struct RimRay {
  Vec3f origin, direction;
};

RimRay through_rims(const Cone& cone, Random& random) {
  const exact::Vec along = exact::Vec(cone.apex) - exact::Vec(cone.base);
  const Frame<exact::Real> frame = frame_around(normalize(along));
  const auto on_rim = [&](bool is_apex, exact::Real share) {
    const exact::Real angle = random.one_in(2) ? random.below(4) * 1.57079632679489661923L
                                               : exact::Real(random.uniform(0, 6.2831853f));
    const exact::Real radius = share * exact::Real(is_apex ? cone.apex_radius : cone.base_radius);
    return exact::Vec(is_apex ? cone.apex : cone.base) + frame.u * (radius * std::cos(angle)) +
           frame.v * (radius * std::sin(angle));
  };
  const bool to_apex = random.one_in(2), from_inside = random.one_in(3);
  const exact::Vec to = on_rim(to_apex, 1);
  exact::Vec from = on_rim(!to_apex, from_inside ? exact::Real(random.uniform(0, 0.9f)) : 1);
  if (from_inside) from = from + (to - from) * exact::Real(random.uniform(0.1f, 0.9f));
  // What float leaves of both points decides how far off the rim the ray passes.
  const exact::Real before = from_inside ? 0 : random.uniform(0.1f, 3);
  const Vec3f origin(from - (to - from) * before);
  const auto size = std::pow(2.0f, random.uniform(-2, 1));
  return {origin, Vec3f(to - exact::Vec(origin)) * size};
}

/// How far outside the solid, at least; negative inside.
exact::Real height_above(const Cone& cone, exact::Vec p) {
  const exact::Vec q = exact::axis_of(cone).profile_point(p);
  const exact::Real height = exact::height_of(cone),
                    slope =
                        (exact::Real(cone.apex_radius) - exact::Real(cone.base_radius)) / height;
  return std::max(
      {-q.x, q.x - height,
       (q.y - exact::Real(cone.base_radius) - slope * q.x) / std::sqrt(1 + slope * slope)});
}

struct RimTrials {
  std::uint64_t deep = 0, missed = 0;
  double worst = 0;  // in ulp
};

RimTrials try_rims(std::uint64_t trials, Random& random) {
  RimTrials result;
  for (std::uint64_t i = 0; i < trials; ++i) {
    const nasty::Place place = nasty::random_place(random);
    const ShapeSet shapes = nasty::random_shapes(ShapeKind::cone, 1, place, random);
    if (shapes.cones.empty()) continue;
    ShapeSet solid = shapes;
    Cone& cone = solid.cones.front();
    cone.caps = Caps::capped;
    if (!random.one_in(4)) cone.base_radius *= std::pow(2.0f, random.uniform(0, 6));
    if (std::abs(cone.apex_radius - cone.base_radius) > 4 * exact::height_of(cone)) continue;
    const RimRay ray = through_rims(cone, random);
    if (!(max_abs(ray.direction) > 1e-18f)) continue;
    const exact::Line line{exact::Vec(ray.origin), exact::Vec(ray.direction)};
    const double reach = reach_of(bounds(solid), ray.origin), ulp = 0x1p-24 * reach;
    const auto outside = [&](exact::Real t) { return height_above(cone, line.at(t)); };
    const double far = 16 * reach / max_abs(Vec3d(ray.direction));
    if (!exact::surely_crosses(outside, {0, far}, depth_bound * ulp)) continue;
    ++result.deep;
    const Record record = make_record(solid, {ShapeKind::cone, 0, 0, 0}, 0);
    const NearestRecord found = nearest_brute({&record, 1}, {ray.origin, ray.direction});
    result.missed += found.record == no_record;
    if (found.record != no_record)
      result.worst = std::max(result.worst,
                              static_cast<double>(exact::distance(cone, line.at(found.t)) / ulp));
  }
  return result;
}

/// Where side and cap meet neither may leave the ray to the other.
TEST(IntersectCone, DeepRaysThroughBothRimsOfASolidHit) {
  Random random(25);
  const RimTrials trials = try_rims(200'000, random);
  EXPECT_GT(trials.deep, 50'000u);
  EXPECT_EQ(trials.missed, 0u);
  EXPECT_LE(trials.worst, bound_of(ShapeKind::cone));
}

TEST(SlowIntersectCone, DeepRaysThroughBothRimsOfASolidHit) {
  Random random(26);
  const RimTrials trials = try_rims(5'000'000, random);
  EXPECT_EQ(trials.missed, 0u);
  EXPECT_LE(trials.worst, bound_of(ShapeKind::cone));
}

/// Rays that run within rounding of a triangle's plane cross it far outside the triangle.
TEST(IntersectTriangle, GrazingHitsLieOnTheTriangle) {
  Random random(24);
  std::uint64_t hits = 0;
  for (int i = 0; i < 300'000; ++i) {
    ShapeSet shapes;
    Mesh& mesh = shapes.meshes.emplace_back();
    for (int corner = 0; corner < 3; ++corner) mesh.positions.push_back(random.in_cube());
    mesh.triangles.push_back({0, 1, 2});
    const exact::Corners exact{exact::Vec(mesh.positions[0]), exact::Vec(mesh.positions[1]),
                               exact::Vec(mesh.positions[2])};
    const auto on_plane = [&] {
      const Vec3f p = mesh.positions[0], u = mesh.positions[1] - p, v = mesh.positions[2] - p;
      return p + u * random.uniform(-2, 3) + v * random.uniform(-2, 3);
    };
    const Vec3f origin = on_plane(), direction = on_plane() - origin;
    const Record record = make_record(shapes, {ShapeKind::triangle, 0, 0, 0}, 0);
    const NearestRecord found = nearest_brute({&record, 1}, {origin, direction});
    if (found.record == no_record) continue;
    ++hits;
    const double reach = reach_of(bounds(shapes), origin);
    const exact::Line ray{exact::Vec(origin), exact::Vec(direction)};
    ASSERT_LE(exact::distance(exact, ray.at(found.t)) / reach,
              bound_of(ShapeKind::triangle) * 0x1p-24)
        << "ray " << i;
  }
  EXPECT_GT(hits, 1000u);
}

}  // namespace
}  // namespace penumbra
