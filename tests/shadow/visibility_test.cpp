// SPDX-License-Identifier: MIT
#include "penumbra/shadow/visibility.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/shadow/light_kinds.h"

namespace penumbra {
namespace {

constexpr double pi = std::numbers::pi;

/// Shapes and one light, ready to be asked by one method.
struct Lit {
  Kernel kernel;
  ShadowScene scene;
  VisibilityScratch scratch;
  OccluderQueue queue;
  ShadowCounters counters;

  Lit(const ShapeSet& shapes, const LightShape& light, std::uint32_t d,
      Method method = Method::stochastic, KernelKind kind = KernelKind::wide)
      : kernel(shapes, {kind, {}}),
        scene(prepare_shadows(kernel, shapes, {kind, {}}, {&light, 1}, method)),
        scratch(d) {}
  Lit(const Lit&) = delete;

  Visibility see(const Receiver& receiver, std::uint64_t key = 1) {
    return visibility(scene, 0, receiver, key, queue, scratch, counters);
  }
};

/// Mean of the plain fraction over many keys, with its standard error.
struct Estimate {
  double mean = 0, error = 0;
};

Estimate estimate(const ShapeSet& shapes, const LightShape& light, const Receiver& receiver,
                  std::uint32_t d, int keys) {
  Lit lit(shapes, light, d);
  double sum = 0, squares = 0;
  for (int k = 0; k < keys; ++k) {
    const double f = lit.see(receiver, light_key(static_cast<std::uint64_t>(k), 0)).fraction;
    sum += f, squares += f * f;
  }
  const double mean = sum / keys;
  return {mean, std::sqrt(std::max(1e-12, (squares / keys - mean * mean) / (keys - 1)))};
}

void expect_unbiased(const Estimate& estimate, double truth) {
  EXPECT_NEAR(estimate.mean, truth, 4 * estimate.error)
      << "z = " << (estimate.mean - truth) / estimate.error;
}

const Receiver up{{0, 0, 0}, {0, 0, 1}};

/// The half-plane x > edge at height 1, as far as a ball light over the origin is concerned.
ShapeSet half_plane(float edge) {
  Mesh mesh;
  mesh.positions = {{edge, -1e3f, 1}, {1e3f, -1e3f, 1}, {1e3f, 1e3f, 1}, {edge, 1e3f, 1}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  ShapeSet shapes;
  shapes.meshes.push_back(mesh);
  return shapes;
}

/// Share of a cone of half angle a on the far side of a plane through its apex, at angle b from its
/// axis.
double share_beyond_plane(double a, double b) {
  const double cut = 2 * (std::acos(std::sin(b) / std::sin(a)) -
                          std::cos(a) * std::acos(std::tan(b) / std::tan(a)));
  return cut / (2 * pi * (1 - std::cos(a)));
}

/// Share of a cone of half angle a that another of half angle b hides, their axes at angle s.
double share_behind_ball(double a, double b, double s) {
  const double area =
      2 * (pi - std::acos((std::cos(s) - std::cos(a) * std::cos(b)) / (std::sin(a) * std::sin(b))) -
           std::cos(a) *
               std::acos((std::cos(b) - std::cos(s) * std::cos(a)) / (std::sin(s) * std::sin(a))) -
           std::cos(b) *
               std::acos((std::cos(a) - std::cos(s) * std::cos(b)) / (std::sin(s) * std::sin(b))));
  return area / (2 * pi * (1 - std::cos(a)));
}

TEST(Visibility, HalfPlaneOverABallLight) {
  const BallLight light{{0, 0, 4}, 1.5f};
  const double a = std::asin(1.5 / 4);
  for (float edge : {0.0f, 0.1f, 0.25f, -0.2f}) {
    const double hidden = edge >= 0 ? share_beyond_plane(a, std::atan(edge))
                                    : 1 - share_beyond_plane(a, std::atan(-edge));
    for (std::uint32_t d : {1u, 7u, 32u, 256u})
      expect_unbiased(estimate(half_plane(edge), light, up, d, 20'000), 1 - hidden);
  }
}

TEST(Visibility, OneBallEclipsesAnother) {
  const BallLight light{{0, 0, 10}, 2};
  const double a = std::asin(0.2);
  for (double separation : {0.1, 0.2, 0.3}) {
    const double distance = 3, radius = 0.6, b = std::asin(radius / distance);
    ShapeSet shapes;
    shapes.spheres.push_back(
        {Vec3f(Vec3d{std::sin(separation), 0, std::cos(separation)} * distance), 0.6f, 0});
    expect_unbiased(estimate(shapes, light, up, 32, 20'000),
                    1 - share_behind_ball(a, b, separation));
  }
}

TEST(Visibility, DiskHidesPartOfTheSun) {
  const SunLight sun{{0, 0, 1}, 0.1f};
  ShapeSet shapes;
  shapes.rings.push_back({{0, 0, 100}, {0, 0, 1}, 5, 0, 0});
  const double hidden = (1 - std::cos(std::atan(0.05))) / (1 - std::cos(0.1));
  expect_unbiased(estimate(shapes, sun, up, 16, 20'000), 1 - hidden);
}

TEST(Visibility, HalfPlaneOverAParallelogramLight) {
  const ParallelogramLight light{{0, 0, 4}, {1, 0, 0}, {0, 1, 0}};
  expect_unbiased(estimate(half_plane(0), light, up, 32, 20'000), 0.5);
}

TEST(Visibility, ClassesByTheSamplesAndCountsWhatItTraced) {
  const BallLight light{{0, 0, 4}, 1};
  ShadowCounters counters;
  const auto see = [&](const ShapeSet& shapes) {
    Lit lit(shapes, light, 32);
    const Visibility seen = lit.see(up);
    counters.add(lit.counters);
    return seen;
  };
  ShapeSet far_ball, cover;
  far_ball.spheres.push_back({{50, 0, 0}, 1, 0});
  cover.spheres.push_back({{0, 0, 2}, 1.5f, 0});
  EXPECT_EQ(see(far_ball).shadow_class, ShadowClass::lit);
  EXPECT_EQ(see(far_ball).cosine_weighted, 1);
  EXPECT_EQ(see(cover).shadow_class, ShadowClass::umbra);
  EXPECT_EQ(see(cover).fraction, 0);
  EXPECT_EQ(see(half_plane(0)).shadow_class, ShadowClass::penumbra);
  EXPECT_EQ(counters.lit, 2u);
  EXPECT_EQ(counters.umbra, 2u);
  EXPECT_EQ(counters.penumbra, 1u);
  EXPECT_EQ(counters.rays, 5u * 32);
}

TEST(Visibility, SamplesBelowTheHorizonWeighNothingAndFireNoRay) {
  ShapeSet shapes;
  shapes.spheres.push_back({{0, 0, -50}, 1, 0});
  ShadowCounters counters;
  const auto see = [&](Vec3f center) {
    Lit lit(shapes, BallLight{center, 1}, 64);
    const Visibility seen = lit.see(up);
    counters.add(lit.counters);
    return seen;
  };
  EXPECT_EQ(see({0, 0, -4}).fraction, 0);
  EXPECT_EQ(counters.rays, 0u);
  EXPECT_EQ(counters.umbra, 0u);  // no query at all
  const Visibility half = see({4, 0, 0});
  EXPECT_EQ(half.cosine_weighted, 1);  // what is above is free
  EXPECT_NEAR(half.fraction, 0.5, 0.06);
  EXPECT_LT(counters.rays, 64u);
}

TEST(Visibility, InsideALightTheSamplesDecideAndTheClassIsPenumbra) {
  ShapeSet shapes;
  shapes.spheres.push_back({{50, 0, 0}, 1, 0});
  const Visibility seen = Lit(shapes, BallLight{{0, 0, 0.2f}, 1}, 64).see(up);
  EXPECT_EQ(seen.shadow_class, ShadowClass::penumbra);
  EXPECT_EQ(seen.cosine_weighted, 1);
  EXPECT_NEAR(seen.fraction, 0.5, 0.1);  // half of all directions are above the horizon
}

TEST(Visibility, NotANumberProvesNothing) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const Visibility seen =
      Lit(half_plane(0), BallLight{{0, 0, 4}, 1}, 32).see({{nan, 0, 0}, {0, 0, 1}});
  EXPECT_EQ(seen.shadow_class, ShadowClass::penumbra);
}

TEST(Visibility, HardTracesOneRayToTheCentre) {
  const BallLight light{{0, 0, 4}, 1};
  Lit free(half_plane(0.01f), light, 32, Method::hard);
  Lit hidden(half_plane(-0.01f), light, 32, Method::hard);
  EXPECT_EQ(free.see(up).cosine_weighted, 1);
  EXPECT_EQ(hidden.see(up).cosine_weighted, 0);
  EXPECT_EQ(free.counters.rays + hidden.counters.rays, 2u);
}

TEST(Visibility, TheCacheDecidesWhatItsOccludersBlockAndIsEmptiedByMisses) {
  ShapeSet shapes;
  shapes.spheres.push_back({{0, 0, 2}, 1.5f, 0});
  Lit lit(shapes, BallLight{{0, 0, 40}, 1}, 32);
  lit.see(up);
  EXPECT_EQ(lit.counters.rays, 32u);
  lit.see(up);
  EXPECT_EQ(lit.counters.rays, 32u);
  EXPECT_EQ(lit.counters.cache_decided, 32u);
  const Receiver aside{{50, 0, 0}, {0, 0, 1}};
  lit.see(aside);
  EXPECT_EQ(lit.counters.rays, 64u);
  EXPECT_EQ(lit.queue.record[0], no_record);
}

TEST(Visibility, ALightInsideAnOccluderIsHidden) {
  ShapeSet shapes;
  shapes.spheres.push_back({{0, 0, 4}, 1.5f, 0});
  expect_unbiased(estimate(shapes, BallLight{{0, 0, 4}, 1}, up, 32, 100), 0);
}

constexpr Method all_but_hard[] = {Method::stochastic, Method::offset, Method::reduced,
                                   Method::umbra, Method::shaft};

/// A plane's edge, a ball and a cone before a light, and what makes room for receivers.
ShapeSet some_of_each() {
  ShapeSet shapes = half_plane(0.1f);
  for (Vec3f& p : shapes.meshes[0].positions)
    p = {std::min(p.x, 3.0f), std::clamp(p.y, -4.0f, 4.0f), p.z};
  shapes.spheres.push_back({{-2, -2, -1}, 0.5f, 0});
  shapes.spheres.push_back({{-0.3f, 0.1f, 2}, 0.3f, 0});
  shapes.cones.push_back({{-1, -1, 1.5f}, {1, -0.2f, 1.8f}, 0.1f, 0.05f, Caps::capped, 0});
  return shapes;
}

/// 40 x 50 receivers on the ground.
std::vector<ShadowQuery> on_the_ground() {
  std::vector<ShadowQuery> queries;
  for (std::uint64_t key = 0; key < 2'000; ++key)
    queries.push_back(
        {{{static_cast<float>(key % 40) * 0.05f - 1, static_cast<float>(key / 40) * 0.04f - 1, 0},
          {0, 0, 1}},
         key});
  return queries;
}

TEST(Visibility, BruteForceGivesTheSameBits) {
  const BallLight light{{0, 0, 4}, 1};
  const ShapeSet shapes = some_of_each();
  for (const Method method : all_but_hard) {
    Lit wide(shapes, light, 48, method), brute(shapes, light, 48, method, KernelKind::brute);
    for (const ShadowQuery& query : on_the_ground()) {
      const Visibility a = wide.see(query.receiver, query.key);
      const Visibility b = brute.see(query.receiver, query.key);
      ASSERT_EQ(a.cosine_weighted, b.cosine_weighted) << static_cast<int>(method);
      ASSERT_EQ(a.fraction, b.fraction) << static_cast<int>(method);
      // Without a hierarchy there is nothing to ask for candidates.
      if (method == Method::shaft) continue;
      ASSERT_EQ(a.shadow_class, b.shadow_class) << static_cast<int>(method);
    }
  }
}

TEST(Visibility, ABatchIsAnsweredLikeItsReceiversOneByOne) {
  const std::vector<ShadowQuery> queries = on_the_ground();
  for (const char* kind : light_kinds) {
    const LightShape light = light_of_kind(kind, {0.2f, 0, 4}, 0.3f, {});
    Lit judge(some_of_each(), light, 32);
    for (const Method method : all_but_hard) {
      Lit lit(some_of_each(), light, 32, method);
      std::vector<Visibility> seen(queries.size());
      for (std::size_t first = 0, batch = 1; first < seen.size(); first += batch, batch += 9) {
        batch = std::min(batch, seen.size() - first);
        visibilities(lit.scene, 0, std::span(queries).subspan(first, batch), lit.queue, lit.scratch,
                     lit.counters, std::span(seen).subspan(first, batch));
      }
      for (std::size_t i = 0; i < seen.size(); ++i) {
        const Visibility truth = judge.see(queries[i].receiver, queries[i].key);
        ASSERT_EQ(seen[i].cosine_weighted, truth.cosine_weighted) << kind;
        ASSERT_EQ(seen[i].fraction, truth.fraction) << kind;
      }
      const ShadowCounters& of = lit.counters;
      EXPECT_EQ(of.lit + of.umbra + of.penumbra, queries.size()) << kind;
      EXPECT_TRUE(method != Method::shaft || of.lit + of.umbra > 20) << kind;  // proofs, too
    }
  }
}

/// The intersector leaves float's range where a sphere is some 10^-20 of the ray's length: it errs
/// by more than it promises, so that nothing may be proven.
TEST(Visibility, NothingIsProvenOfWhatIsTooSmallBesideTheLightsDistance) {
  nasty::Random random(3);
  for (int i = 0; i < 4'000; ++i) {
    const float radius = std::pow(10.0f, random.uniform(-17, -8));
    const float distance = std::pow(10.0f, random.uniform(1, 7.9f));
    const Vec3f to_light(random.direction());
    const Vec3f away = i % 2 == 0 ? to_light : Vec3f(random.direction());
    const float off =
        i % 3 == 0 ? random.uniform(0, 1) : 1 + std::pow(10.0f, random.uniform(-5, 0));
    ShapeSet shapes;
    shapes.spheres.push_back({{}, radius, 0});
    const BallLight light{to_light * distance, distance * 1e-3f};
    const Receiver receiver{away * (radius * off), to_light};
    Lit judge(shapes, light, 8, Method::stochastic);
    const Visibility expected = judge.see(receiver, 1);
    for (const Method method : {Method::offset, Method::umbra, Method::shaft}) {
      Lit lit(shapes, light, 8, method);
      ASSERT_EQ(lit.see(receiver, 1).fraction, expected.fraction)
          << static_cast<int>(method) << " radius " << radius << " distance " << distance;
    }
  }
}

/// A sun without size is a point far away: its samples are all the same.
TEST(Visibility, ASunOfNoSizeCostsOneRay) {
  ShapeSet shapes;
  shapes.spheres = {{{0, 0, 3}, 1, 0}};
  const Kernel kernel(shapes, {});
  const LightShape suns[] = {SunLight{{0, 0, 1}, 0}};
  for (const Method method : {Method::stochastic, Method::umbra, Method::shaft}) {
    const ShadowScene scene = prepare_shadows(kernel, shapes, {}, suns, method);
    VisibilityScratch scratch(32);
    ShadowCounters counters;
    OccluderQueue queue;
    const ShadowQuery queries[] = {{{{0, 0, 0}, {0, 0, 1}}, 1}, {{{5, 0, 0}, {0, 0, 1}}, 2}};
    Visibility seen[2];
    visibilities(scene, 0, queries, queue, scratch, counters, seen);
    EXPECT_EQ(seen[0].cosine_weighted, 0);
    EXPECT_EQ(seen[1].cosine_weighted, 1);
    EXPECT_LE(counters.rays, 2u);
  }
}

}  // namespace
}  // namespace penumbra
