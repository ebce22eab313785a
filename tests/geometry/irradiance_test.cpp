// SPDX-License-Identifier: MIT
#include "penumbra/geometry/irradiance.h"

#include "penumbra/geometry/light_sampling.h"
#include "tests/geometry/light_shapes.h"

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

TEST(Irradiance, OfTheOtherLightsIsTheirMeanCosine) {
  std::uint64_t key = 0;
  for (const LightShape& light :
       {LightShape(DiskLight{{0, 0, 0}, {0, 0.6f, 0.8f}, 1.3f}),
        LightShape(LineLight{{0, 0, 0}, {1, 0.5f, 0.25f}}),
        LightShape(polygon_around({0, 0, 0}, {1, 0, 0}, {0, 0.5f, 0.25f}, 5)),
        LightShape(box_around({0, 0, 0}, {0.5f, 0.25f, 0.75f}))})
    for (const Place& place : places(200)) {
      if (contains(light, place.p)) continue;
      const double expected = mean_cosine(light, place.p, place.n, key++);
      EXPECT_NEAR(irradiance(light, place.p, place.n), expected, 4e-4)
          << "light " << light.index() << " from " << length(place.p);
    }
}

TEST(Irradiance, OfADiskIsThatOfTheBooks) {
  // Parallel and straight above: E = pi sin², and the mean cosine is (1 + cos) / 2.
  for (const float h : {0.01f, 1.0f, 20.0f}) {
    const double cosine = h / std::hypot(h, 1.0);
    EXPECT_NEAR(irradiance(DiskLight{{0, 0, h}, {0, 0, 1}, 1}, {}, {0, 0, 1}), (1 + cosine) / 2,
                1e-12);
  }
  // From aside, parallel (J. R. Howell, A Catalog of Radiation Configuration Factors, B-13):
  // E / pi = (1 - (h² + l² - r²) / sqrt((h² + l² + r²)² - 4 l² r²)) / 2.
  for (const float l : {0.5f, 1.0f, 3.0f})
    for (const float h : {0.01f, 1.0f, 20.0f}) {
      const DiskLight disk{{l, 0, h}, {0, 0, 1}, 1};
      const double h2 = double(h) * h, l2 = double(l) * l;
      const double root = std::sqrt((h2 + l2 + 1) * (h2 + l2 + 1) - 4 * l2);
      const double projected = pi * 0.5 * (1 - (h2 + l2 - 1) / root);
      EXPECT_NEAR(irradiance(disk, {}, {0, 0, 1}) * solid_angle(disk, {}) / projected, 1, 1e-9);
    }
}

TEST(Irradiance, OfARoundPolygonIsThatOfADisk) {
  const PolygonLight polygon = polygon_around({0, 0, 0}, {1.3f, 0, 0}, {0, 1.3f, 0}, 2000);
  const DiskLight disk{{0, 0, 0}, {0, 0, 1}, 1.3f};
  for (const Place& place : places(200)) {
    if (std::abs(place.p.z) < 1e-3f) continue;
    EXPECT_NEAR(solid_angle(disk, place.p) / solid_angle(polygon, place.p), 1, 5e-5);
    EXPECT_NEAR(irradiance(disk, place.p, place.n), irradiance(polygon, place.p, place.n), 5e-5);
  }
}

TEST(Irradiance, OfAPolygonWithFourCornersIsThatOfAParallelogram) {
  const ParallelogramLight light{{0, 0, 0}, {1, 0.5f, 0.25f}, {-0.25f, 0.5f, 1}};
  PolygonLight polygon{{0, 0, 0}, {}};
  for (const Vec3d corner : corners(light)) polygon.corners.emplace_back(corner);
  for (const Place& place : places(200)) {
    EXPECT_NEAR(irradiance(light, place.p, place.n), irradiance(polygon, place.p, place.n), 1e-6);
    EXPECT_NEAR(inverse_square_factor(light, place.p), inverse_square_factor(polygon, place.p),
                1e-6);
  }
}

TEST(Irradiance, InsideAMeshIsWhatItIsOnItsSkin) {
  const MeshLight box = box_around({0, 0, 0}, {1, 1, 1});
  EXPECT_EQ(irradiance(box, {0.5f, 0, 0}, {1, 0, 0}), 0.5);
  EXPECT_NEAR(irradiance(box, {1.0001f, 0, 0}, {-1, 0, 0}), 0.5, 1e-3);
  EXPECT_NEAR(inverse_square_factor(box, {1.0001f, 0, 0}) / inverse_square_factor(box, {}), 1,
              1e-3);
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
    EXPECT_NEAR(irradiance(DiskLight{{1, 2, 3}, {0, 0, 1}, size}, {}, n), expected, 1e-5);
    EXPECT_NEAR(irradiance(LineLight{{1, 2, 3}, {size, 0, 0}}, {}, n), expected, 1e-5);
    const Vec3f u{size, 0, 0}, v{0, size, 0};
    if (size < 1e-7f) continue;  // corners are floats
    EXPECT_NEAR(irradiance(polygon_around({1, 2, 3}, u, v, 6), {}, n), expected, 2e-5);
    EXPECT_NEAR(irradiance(box_around({1, 2, 3}, {size, size, size}), {}, n), expected, 1e-2);
  }
}

TEST(Irradiance, StaysInRangeWhateverThePlace) {
  const std::vector<LightShape> lights = {DiskLight{{1, 2, 3}, {0, 0, 1}, 0.5f},
                                          LineLight{{1, 2, 3}, {1, 0, 0}},
                                          LineLight{{1, 2, 3}, {1e-30f, 0, 0}},
                                          DiskLight{{1, 2, 3}, {0, 0, 1}, 1e-30f},
                                          polygon_around({1, 2, 3}, {1, 0, 0}, {0, 1, 0}, 6),
                                          box_around({1, 2, 3}, {1, 1, 1})};
  for (const LightShape& light : lights)
    for (const Vec3f p :
         {Vec3f(1, 2, 3), Vec3f(1.5f, 2, 3), Vec3f(1.5f, 2, std::nextafter(3.f, 4.f)),
          Vec3f(2, 2, 3), Vec3f(2, 3, std::nextafter(4.f, 5.f)), Vec3f(9, 2, 3), Vec3f(1, 2, 4),
          Vec3f(1.500001f, 2, 3.000001f), Vec3f(1e18f, 0, 0), Vec3f(-3e38f, 3e38f, 3e38f)})
      for (const Vec3f n :
           {Vec3f(0, 0, 1), Vec3f(0, 0, -1), Vec3f(1, 0, 0), Vec3f(0, 0.6f, 0.8f)}) {
        const double value = irradiance(light, p, n);
        EXPECT_TRUE(value >= 0 && value <= 1) << light.index() << " " << value;
        const double factor = inverse_square_factor(light, p);
        EXPECT_TRUE(factor >= 0 && std::isfinite(factor)) << light.index() << " " << factor;
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

TEST(InverseSquareFactor, OfTheOtherLightsGivesThePhysicalIrradiance) {
  const Vec3f up{0, 0, 1};
  const auto physical = [&](const LightShape& light, Vec3f p) {
    return irradiance(light, p, up) * inverse_square_factor(light, p);
  };
  // As a point from afar, along the normal of flat ones.
  const Vec3f u{0.5f, 0, 0}, v{0, 0.5f, 0}, far{0, 0, 100};
  EXPECT_NEAR(physical(DiskLight{far, up, 0.5f}, {}) * 1e4, 1, 1e-4);
  EXPECT_NEAR(physical(polygon_around(far, u, v, 7), {}) * 1e4, 1, 1e-4);
  EXPECT_NEAR(physical(LineLight{far, {0.5f, 0.2f, 0.1f}}, {}) * 1e4, 1, 1e-4);
  // A disk of radiance 1 / area over the whole sky.
  EXPECT_NEAR(physical(DiskLight{{0, 0, 1}, up, 1000}, {}) * 1e6, 1, 1e-5);
  // A row of points by the sum over them.
  const LineLight line{{1, 0.5f, 2}, {3, 0.25f, -1}};
  double sum = 0;
  constexpr int count = 100'000;
  for (int i = 0; i < count; ++i) {
    const Vec3d l = Vec3d(line.center) + Vec3d(line.half) * ((2.0 * i + 1) / count - 1);
    sum += std::max(0.0, l.z) / (length_squared(l) * length(l));
  }
  EXPECT_NEAR(physical(line, {}) / (sum / count), 1, 1e-6);
  // End-on: the integral of 1 / z² from 1 to 3, over 2.
  EXPECT_NEAR(physical(LineLight{{0, 0, 2}, {0, 0, 1}}, {}), 1.0 / 3, 1e-12);
  // A cube, whose face from afar has a quarter of what a sixth of the surface has: 4 / 6.
  EXPECT_NEAR(physical(box_around(far, {0.5f, 0.5f, 0.5f}), {}) * 1e4, 4.0 / 6, 1e-2);
}

}  // namespace
}  // namespace penumbra
