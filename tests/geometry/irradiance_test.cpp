// SPDX-License-Identifier: MIT
#include "penumbra/geometry/irradiance.h"

#include "penumbra/geometry/light_sampling.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace penumbra {
namespace {

constexpr double pi = std::numbers::pi;

/// Mean of max(0, n·ω) over the samples of one key.
double mean_cosine(const LightShape& light, Vec3f p, Vec3f n, std::uint64_t key) {
  static const SamplePattern pattern(8192);
  LightSamples samples;
  sample_light(light, p, pattern, key, samples);
  double sum = 0;
  for (std::uint32_t i = 0; i < samples.count; ++i)
    sum += std::max(0.0, dot(normalize(Vec3d(samples.x[i], samples.y[i], samples.z[i])), Vec3d(n)));
  return sum / samples.count;
}

struct Place {
  Vec3f p, n;
};

/// Around the origin at distances from 2^-2 to 2^4, every other one with the origin near its
/// horizon.
std::vector<Place> places(int count) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> exponent(-2, 4);
  const auto direction = [&] {
    return normalize(Vec3d(normal(random), normal(random), normal(random)));
  };
  std::vector<Place> result;
  for (int i = 0; i < count; ++i) {
    const Vec3d way = direction(), p = way * std::exp2(exponent(random));
    const Vec3d any = direction();
    const Vec3d n = i % 2 ? any : normalize(cross(any, way) + way * (0.2 * normal(random)));
    result.push_back({Vec3f(p), Vec3f(n)});
  }
  return result;
}

TEST(Irradiance, OfABallIsTheIntegralOverItsCone) {
  const BallLight ball{{0, 0, 0}, 0.9f};
  std::uint64_t key = 0;
  for (const Place& place : places(500)) {
    const double r = length(Vec3d(place.p));
    if (contains(ball, place.p)) {
      EXPECT_EQ(irradiance(ball, place.p, place.n), 1);
      continue;
    }
    const double expected = mean_cosine(ball, place.p, place.n, key++) *
                            solid_angle(ball, place.p) / (pi * 0.81 / (r * r));
    EXPECT_NEAR(irradiance(ball, place.p, place.n), expected, 4e-4) << "distance " << r;
  }
}

TEST(Irradiance, OfASunIsTheIntegralOverItsCone) {
  std::uint64_t key = 0;
  for (const float half : {0.00465f, 0.3f, 1.2f, 1.55f})
    for (const Place& place : places(50)) {
      const SunLight sun{normalize(place.p), half};
      const double sine = std::sin(half);
      const double expected =
          mean_cosine(sun, {}, place.n, key++) * solid_angle(sun, {}) / (pi * sine * sine);
      EXPECT_NEAR(irradiance(sun, {}, place.n), expected, 4e-4);
    }
}

TEST(Irradiance, OfAParallelogramIsItsMeanCosine) {
  std::uint64_t key = 0;
  for (const ParallelogramLight& light :
       {ParallelogramLight{{0, 0, 0}, {1, 0, 0}, {0, 0.5f, 0}},
        ParallelogramLight{{0, 0, 0}, {1, 0.5f, 0.25f}, {-0.25f, 0.5f, 1}}})
    for (const Place& place : places(200)) {
      const double expected = mean_cosine(light, place.p, place.n, key++);
      EXPECT_NEAR(irradiance(light, place.p, place.n), expected, 4e-4);
    }
}

TEST(Irradiance, WhollyAboveTheHorizonABallCountsAsItsCentre) {
  const BallLight ball{{3, 0, 4}, 1};
  EXPECT_NEAR(irradiance(ball, {}, {0, 0, 1}), 0.8, 1e-15);
  EXPECT_NEAR(irradiance(PointLight{{3, 0, 4}}, {}, {0, 0, 1}), 0.8, 1e-15);
  EXPECT_EQ(irradiance(PointLight{{3, 0, 4}}, {}, {0, 0, -1}), 0);
  EXPECT_EQ(irradiance(ball, {}, {0, 0, -1}), 0);
}

TEST(Irradiance, IsContinuousWhereTheHorizonTouches) {
  for (const float half : {1e-6f, 0.01f, 1.0f, 1.5f}) {
    const SunLight sun{{0, 0, 1}, half};
    const double s = std::sin(static_cast<double>(half));
    const auto at = [&](double elevation) {
      return irradiance(sun, {}, Vec3f(Vec3d(std::sqrt(1 - elevation * elevation), 0, elevation)));
    };
    EXPECT_NEAR(at(s * 0.99999), at(s * 1.00001), 1e-4 * s);
    EXPECT_NEAR(at(-s * 0.99999), 0, 1e-4 * s);
    EXPECT_GT(at(0), 0);
    EXPECT_LT(at(0), s);
  }
}

TEST(Irradiance, HalfSetSunsApproachTheirLimit) {
  // A small disk cut in half by the horizon: the centroid of its upper half is 4 s / (3 pi) high.
  for (const float s : {1e-2f, 1e-4f, 1e-6f})
    EXPECT_NEAR(irradiance(SunLight{{0, 0, 1}, s}, {}, {1, 0, 0}) / (s * 2 / (3 * pi)), 1, 1e-4);
}

TEST(Irradiance, OfSmallLightsIsThatOfPoints) {
  const Vec3f n{0, 0.6f, 0.8f};
  for (const float size : {1e-2f, 1e-4f, 1e-6f, 1e-12f}) {
    const double expected = irradiance(PointLight{{1, 2, 3}}, {}, n);
    EXPECT_NEAR(irradiance(BallLight{{1, 2, 3}, size}, {}, n), expected, 1e-7);
    const ParallelogramLight light{{1, 2, 3}, {size, 0, 0}, {0, size, 0}};
    EXPECT_NEAR(irradiance(light, {}, n), expected, 1e-5);
  }
}

TEST(Irradiance, EdgeOnLightsGiveNone) {
  EXPECT_EQ(irradiance(ParallelogramLight{{3, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}, {1, 0, 0}), 0);
  EXPECT_EQ(irradiance(ParallelogramLight{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}, {0, 0, 1}), 0);
}

TEST(InverseSquareFactor, GivesThePhysicalIrradiance) {
  const Vec3f up{0, 0, 1};
  EXPECT_DOUBLE_EQ(inverse_square_factor(PointLight{{0, 0, 4}}, {}), 1.0 / 16);
  EXPECT_EQ(inverse_square_factor(PointLight{{0, 0, 4}}, {0, 0, 4}), 0);
  EXPECT_EQ(inverse_square_factor(SunLight{}, {}), 1);
  // A ball of radiance 1 / (pi R²): E = pi sin² / (pi R²) = 1 / D².
  EXPECT_DOUBLE_EQ(inverse_square_factor(BallLight{{0, 0, 4}, 2}, {}), 1.0 / 16);
  EXPECT_DOUBLE_EQ(inverse_square_factor(BallLight{{0, 0, 1}, 2}, {}), 1.0 / 4);
  // A square of radiance 1 / area: near an endless ceiling of radiance L the irradiance is pi L;
  // far from a small light straight above it is 1 / D².
  const ParallelogramLight ceiling{{0, 0, 1}, {1000, 0, 0}, {0, 1000, 0}};
  const double near = irradiance(ceiling, {}, up) * inverse_square_factor(ceiling, {});
  EXPECT_NEAR(near * 4e6 / pi, 1, 1e-5);
  const ParallelogramLight small{{0, 0, 100}, {0.5f, 0, 0}, {0, 0.5f, 0}};
  EXPECT_NEAR(irradiance(small, {}, up) * inverse_square_factor(small, {}) * 1e4, 1, 1e-4);
  // From aside its own tilt dims it: cos² / D² for surfaces that face along z.
  const Vec3f aside{100, 0, 0};
  const double dimmed = irradiance(small, aside, up) * inverse_square_factor(small, aside);
  EXPECT_NEAR(dimmed * 2e4 * 2, 1, 1e-4);
}

}  // namespace
}  // namespace penumbra
