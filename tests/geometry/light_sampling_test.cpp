// SPDX-License-Identifier: MIT
#include "penumbra/geometry/light_sampling.h"

#include "penumbra/geometry/parallelogram.h"
#include "tests/geometry/chi_squared.h"
#include "tests/geometry/instruction_sets.h"
#include "tests/geometry/light_shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace penumbra {
namespace {

constexpr double pi = std::numbers::pi;
constexpr int side = 16;  // bins of each coordinate

struct Bin {
  double first, second;  // in [0, 1]
};

/// Deviate of the samples of a light over side x side bins of equal expected count (or of the given
/// shares): one sample a key, so that counts are independent, every sample of the pattern in turn.
double deviate(const LightShape& light, Vec3f p, std::uint32_t d,
               const std::function<Bin(Vec3d)>& bin_of,
               const std::vector<double>& shares = std::vector<double>(side * side, 1)) {
  constexpr std::uint64_t keys = 1'000'000;
  const SamplePattern pattern(d);
  LightSamples samples;
  std::vector<double> counts(side * side);
  for (std::uint64_t key = 0; key < keys; ++key) {
    sample_light(light, p, pattern, key, samples);
    const std::size_t i = key % d;
    const Bin bin = bin_of({samples.x[i], samples.y[i], samples.z[i]});
    const auto place = [](double x) {
      return static_cast<int>(std::clamp(x * side, 0.0, side - 1.0));
    };
    ++counts[place(bin.first) * side + place(bin.second)];
  }
  return chi_squared_deviate(counts, shares);
}

/// Share of the cone's solid angle up to the direction, and the angle around its axis.
std::function<Bin(Vec3d)> cone_bins(Vec3d axis, double sine_max) {
  const Frame<double> frame = frame_around(normalize(axis));
  const double one_minus_cos_max = sine_max * sine_max / (1 + std::sqrt(1 - sine_max * sine_max));
  return [=](Vec3d way) {
    const double x = dot(way, frame.u), y = dot(way, frame.v), z = dot(way, frame.n);
    const double r = length(way), one_minus_cos = (x * x + y * y) / (r * (r + z));
    return Bin{one_minus_cos / one_minus_cos_max, 0.5 + std::atan2(y, x) / (2 * pi)};
  };
}

double ball_deviate(const BallLight& ball, Vec3f p, std::uint32_t d) {
  const Vec3d way = Vec3d(ball.center) - Vec3d(p);
  return deviate(ball, p, d, cone_bins(way, ball.radius / length(way)));
}

/// Places on a parallelogram against the solid angles of its cells.
double parallelogram_deviate(const ParallelogramLight& light, Vec3f p, std::uint32_t d) {
  const SeenParallelogram seen = seen_from(light, p);
  const Vec3d n = cross(seen.u, seen.v);
  const auto bin_of = [&](Vec3d way) {
    const Vec3d w = way - seen.center;
    return Bin{0.5 + 0.5 * dot(cross(w, seen.v), n) / length_squared(n),
               0.5 + 0.5 * dot(cross(seen.u, w), n) / length_squared(n)};
  };
  std::vector<double> shares;
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) {
      const double a = (2.0 * i + 1) / side - 1, b = (2.0 * j + 1) / side - 1;
      shares.push_back(solid_angle(SeenParallelogram{
          seen.center + seen.u * a + seen.v * b, seen.u / double{side}, seen.v / double{side}}));
    }
  return deviate(light, p, d, bin_of, shares);
}

constexpr double limit = 3.9;

TEST(LightSampling, BallIsUniformInSolidAngle) {
  const BallLight ball{{1, 2, 3}, 0.5f};
  EXPECT_LT(std::abs(ball_deviate(ball, {-4, 1, 7}, 32)), limit) << "far";
  EXPECT_LT(std::abs(ball_deviate(ball, {1.4f, 2.4f, 3}, 32)), limit) << "near";
  EXPECT_LT(std::abs(ball_deviate(ball, {1, 2, 2.4999f}, 7)), limit) << "nearly touching";
  EXPECT_LT(std::abs(ball_deviate(ball, {0, 0, 0}, 1)), limit) << "d = 1";
}

TEST(LightSampling, TinyFarAndHugeBallsAreUniformToo) {
  EXPECT_LT(std::abs(ball_deviate({{1e4f, 0, 0}, 1e-4f}, {}, 20)), limit);
  EXPECT_LT(std::abs(ball_deviate({{0, -1e20f, 0}, 1e-10f}, {}, 8)), limit);
  EXPECT_LT(std::abs(ball_deviate({{0, 3e6f, -2e6f}, 3e6f}, {1, 1, 1}, 32)), limit);
}

TEST(LightSampling, FarFromTheOriginNearLightsKeepTheirShape) {
  const BallLight ball{{1e6f, 1e6f, 1e6f}, 0.25f};
  EXPECT_LT(std::abs(ball_deviate(ball, {1e6f, 1e6f, 1e6f + 1}, 32)), limit);
}

TEST(LightSampling, InsideABallDirectionsAreUniform) {
  const BallLight ball{{1, 2, 3}, 2};
  const auto sphere_bins = [](Vec3d way) {
    const Vec3d n = normalize(way);
    return Bin{0.5 + 0.5 * n.z, 0.5 + std::atan2(n.y, n.x) / (2 * pi)};
  };
  for (const Vec3f p : {Vec3f(1, 2, 3), Vec3f(1.5f, 3, 2), Vec3f(1, 2, 4.99f)})
    EXPECT_LT(std::abs(deviate(ball, p, 32, sphere_bins)), limit);
}

TEST(LightSampling, SunsAreUniformInTheirCone) {
  for (const double degrees : {0.53, 60.0, 1e-5, 178.0}) {
    const double half = 0.5 * degrees * pi / 180;
    const SunLight sun{{0, 0, 1}, static_cast<float>(half)};
    EXPECT_LT(std::abs(deviate(sun, {1, 2, 3}, 32, cone_bins({0, 0, 1}, std::sin(half)))), limit);
  }
  const Vec3f tilted = normalize(Vec3f(1, -2, 0.5f));
  const auto bins = cone_bins(Vec3d(tilted), std::sin(0.3));
  EXPECT_LT(std::abs(deviate(SunLight{tilted, 0.3f}, {}, 5, bins)), limit);
}

TEST(LightSampling, RectanglesAreUniformInSolidAngle) {
  const ParallelogramLight light{{0, 0, 2}, {1, 0, 0}, {0, 0.5f, 0}};
  EXPECT_LT(std::abs(parallelogram_deviate(light, {0, 0, 1.9f}, 4)), limit) << "near";
  EXPECT_LT(std::abs(parallelogram_deviate(light, {0.1f, 0.2f, 4}, 4)), limit) << "behind";
  EXPECT_LT(std::abs(parallelogram_deviate(light, {-5, 3, 1}, 4)), limit) << "oblique";
  EXPECT_LT(std::abs(parallelogram_deviate(light, {1.2f, 0, 1.99f}, 13)), limit) << "grazing";
  EXPECT_LT(std::abs(parallelogram_deviate(light, {0, 0, -998}, 1)), limit) << "far";
  const ParallelogramLight turned{{1, 2, 3}, {0.36f, 0.48f, -0.8f}, {0.8f, -0.6f, 0}};
  EXPECT_LT(std::abs(parallelogram_deviate(turned, {0, 1, 2}, 4)), limit) << "turned";
  const ParallelogramLight speck{{0, 0, 1e4f}, {1e-4f, 0, 0}, {0, 1e-4f, 0}};
  EXPECT_LT(std::abs(parallelogram_deviate(speck, {}, 4)), limit) << "tiny";
}

TEST(LightSampling, SkewParallelogramsAreUniformInSolidAngle) {
  const ParallelogramLight light{{0, 0, 2}, {1, 0, 0}, {0.7f, 0.5f, 0}};
  EXPECT_LT(std::abs(parallelogram_deviate(light, {0, 0, 1.5f}, 3)), limit) << "near";
  EXPECT_LT(std::abs(parallelogram_deviate(light, {-3, 2, 4}, 3)), limit) << "oblique, behind";
  EXPECT_LT(std::abs(parallelogram_deviate(light, {0, 0, -98}, 1)), limit) << "far";
}

TEST(LightSampling, EdgeOnLightsAreSampledByArea) {
  const ParallelogramLight light{{3, 0, 0}, {1, 0, 0}, {0.5f, 1, 0}};
  const SeenParallelogram seen = seen_from(light, {});
  const Vec3d n = cross(seen.u, seen.v);
  const auto bin_of = [&](Vec3d way) {
    const Vec3d w = way - seen.center;
    return Bin{0.5 + 0.5 * dot(cross(w, seen.v), n), 0.5 + 0.5 * dot(cross(seen.u, w), n)};
  };
  EXPECT_LT(std::abs(deviate(light, {}, 32, bin_of)), limit);
}

/// Distance of a place from the light's surface (for the flat one: from the light).
double distance_from(const BallLight& ball, Vec3d l) {
  return std::abs(length(l - Vec3d(ball.center)) - ball.radius);
}

double distance_from(const ParallelogramLight& light, Vec3d l) {
  const Vec3d u(light.u), v(light.v), w = l - Vec3d(light.center), n = cross(u, v);
  const double a = std::clamp(dot(cross(w, v), n) / length_squared(n), -1.0, 1.0);
  const double b = std::clamp(dot(cross(u, w), n) / length_squared(n), -1.0, 1.0);
  return length(w - u * a - v * b);
}

TEST(LightSampling, SamplesLieOnTheLight) {
  const SamplePattern pattern(48);
  LightSamples samples;
  const auto check = [&](const auto& light, double size) {
    for (std::uint64_t key = 0; key < 4000; ++key) {
      const auto coordinate = [&](std::uint64_t axis) {
        const std::uint64_t random = hash(key, axis);
        const double sign = random % 2 ? 1 : -1;
        return sign * std::exp2(static_cast<double>(random % 997) / 997 * 40 - 20);
      };
      const Vec3f p = light.center + Vec3f(Vec3d(coordinate(1), coordinate(2), coordinate(3)));
      sample_light(light, p, pattern, key, samples);
      ASSERT_EQ(samples.count, 48u);
      ASSERT_EQ(samples.t_max, 1);
      ASSERT_EQ(samples.origin, p);
      const double distance = length(Vec3d(p) - Vec3d(light.center));
      const double ulp = 0x1p-23 * (length(Vec3d(p)) + distance + size);
      for (int i = 0; i < 48; ++i) {
        const Vec3d l = Vec3d(p) + Vec3d(samples.x[i], samples.y[i], samples.z[i]);
        ASSERT_LE(distance_from(light, l), 8 * ulp) << "key " << key << ", sample " << i;
      }
    }
  };
  check(BallLight{{1, 2, 3}, 0.5f}, 0.5);
  check(BallLight{{-300, 2e5f, 3}, 1e-3f}, 1e-3);
  check(BallLight{{1, 2, 3}, 3e5f}, 3e5);
  check(ParallelogramLight{{1, 2, 3}, {1, 0, 0}, {0, 3, 0}}, 3.2);
  check(ParallelogramLight{{1, 2, 3}, {1, 0.5f, 0}, {0.25f, 3, 1}}, 4.4);
  check(ParallelogramLight{{1, 2, 3}, {1e4f, 0, 0}, {0, 1e-4f, 0}}, 1e4);
}

TEST(LightSampling, SamplesOfABallAreOnTheSideOfP) {
  const BallLight ball{{0, 0, 5}, 1};
  const SamplePattern pattern(256);
  LightSamples samples;
  for (std::uint64_t key = 0; key < 100; ++key) {
    sample_light(ball, {}, pattern, key, samples);
    for (int i = 0; i < 256; ++i) EXPECT_LE(samples.z[i], 4.8f + 1e-5f);  // the rim of the cap
  }
}

TEST(LightSampling, PaddingRepeatsTheLastSample) {
  LightSamples samples;
  for (const LightShape& light :
       {LightShape(PointLight{{1, 2, 3}}), LightShape(BallLight{{1, 2, 3}, 1}),
        LightShape(SunLight{}), LightShape(ParallelogramLight{{1, 2, 3}, {1, 0, 0}, {0, 1, 0}}),
        LightShape(ParallelogramLight{{1, 2, 3}, {1, 0, 0}, {1, 1, 0}})})
    for (const std::uint32_t d : {1u, 5u, 16u, 17u}) {
      sample_light(light, {}, SamplePattern(d), 3, samples);
      EXPECT_EQ(samples.count, d);
      EXPECT_EQ(samples.x.size() % LightSamples::padding, 0u);
      for (std::size_t i = d; i < samples.x.size(); ++i) {
        EXPECT_EQ(samples.x[i], samples.x[d - 1]);
        EXPECT_EQ(samples.y[i], samples.y[d - 1]);
        EXPECT_EQ(samples.z[i], samples.z[d - 1]);
      }
    }
}

TEST(LightSampling, PointsAndSunsAreWhatTheySay) {
  LightSamples samples;
  sample_light(PointLight{{1, 2, 3}}, {1, 1, 1}, SamplePattern(9), 3, samples);
  for (int i = 0; i < 9; ++i)
    EXPECT_EQ(Vec3f(samples.x[i], samples.y[i], samples.z[i]), Vec3f(0, 1, 2));
  sample_light(SunLight{{0.6f, 0, 0.8f}, 0.3f}, {1, 1, 1}, SamplePattern(99), 3, samples);
  EXPECT_EQ(samples.t_max, std::numeric_limits<float>::infinity());
  for (int i = 0; i < 99; ++i)
    EXPECT_NEAR(length(Vec3f(samples.x[i], samples.y[i], samples.z[i])), 1, 3e-7);
}

TEST(LightSampling, DegeneratePlacesGiveFiniteSamples) {
  LightSamples samples;
  const SamplePattern pattern(64);
  const BallLight ball{{1, 2, 3}, 0.5f};
  const ParallelogramLight flat{{1, 2, 3}, {1, 0, 0}, {0, 1, 0}};
  const ParallelogramLight skew{{1, 2, 3}, {1, 0, 0}, {1, 1, 0}};
  for (const LightShape& light :
       {LightShape(PointLight{{1, 2, 3}}), LightShape(ball), LightShape(flat), LightShape(skew),
        LightShape(BallLight{{1, 2, 3}, 1e-30f})})
    for (const Vec3f p : {Vec3f(1, 2, 3), Vec3f(1.5f, 2, 3), Vec3f(1, 2, 3.5f), Vec3f(2, 3, 3),
                          Vec3f(2, 2, 3), Vec3f(std::nextafter(1.5f, 2.f), 2, 3), Vec3f(9, 2, 3),
                          Vec3f(1, 2, std::nextafter(3.f, 4.f)), Vec3f(1e18f, -1e18f, 0)}) {
      sample_light(light, p, pattern, 1, samples);
      for (std::size_t i = 0; i < samples.x.size(); ++i)
        ASSERT_TRUE(is_finite(Vec3f(samples.x[i], samples.y[i], samples.z[i])));
    }
}

TEST(LightSampling, EveryInstructionSetGivesTheSameBits) {
  const std::vector<LightShape> lights = {BallLight{{1, 2, 3}, 0.5f},
                                          BallLight{{1, 2, 3}, 3.7f},
                                          BallLight{{1, 2, 3}, 9},
                                          SunLight{{0.6f, 0, 0.8f}, 0.3f},
                                          ParallelogramLight{{1, 2, 3}, {1, 0, 0}, {0, 1, 0}},
                                          ParallelogramLight{{1, 2, 0}, {1, 0, 0}, {0, 1, 0}},
                                          DiskLight{{1, 2, 3}, {0.6f, 0, 0.8f}, 1},
                                          DiskLight{{1, 0.25f, 0}, {0, 0, 1}, 2},
                                          LineLight{{1, 2, 3}, {1, 0, 0.5f}},
                                          polygon_around({1, 2, 3}, {1, 0, 0}, {0, 1, 0}, 5),
                                          box_around({1, 2, 3}, {1, 2, 0.5f})};
  const SamplePattern pattern(53);
  const auto all_samples = [&] {
    std::vector<float> result;
    LightSamples samples;
    for (const LightShape& light : lights)
      for (std::uint64_t key = 0; key < 100; ++key) {
        sample_light(light, {0, 0.25f, 0}, pattern, key, samples);
        for (const auto& array : {samples.x, samples.y, samples.z})
          result.insert(result.end(), array.begin(), array.end());
      }
    return result;
  };
  const std::vector<float> expected = all_samples();
  for_each_instruction_set([&] { EXPECT_EQ(all_samples(), expected); });
}

}  // namespace
}  // namespace penumbra
