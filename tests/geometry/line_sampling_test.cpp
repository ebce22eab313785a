// SPDX-License-Identifier: MIT
#include "penumbra/geometry/line_sampling.h"

#include "penumbra/geometry/light_sampling.h"
#include "tests/geometry/chi_squared.h"
#include "tests/geometry/sample_counts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace penumbra {
namespace {

constexpr std::size_t bins = 64;
constexpr double limit = 3.9;

double line_deviate(const LineLight& light, Vec3f p, const std::function<double(Vec3d)>& place_of) {
  const auto bin_of = [&](Vec3d way) {
    return static_cast<std::size_t>(std::clamp(place_of(way) * bins, 0.0, bins - 1.0));
  };
  return chi_squared_deviate(sample_counts(light, p, 4, bins, 100'000, bin_of),
                             std::vector<double>(bins, 1));
}

double angle_deviate(const LineLight& light, Vec3f p) {
  const SeenLine seen = seen_from(light, p);
  const Vec3d start = seen.center - seen.half;
  return line_deviate(light, p, [&](Vec3d way) {
    return std::atan2(length(cross(start, way - start)), dot(start, way)) / seen.angle;
  });
}

TEST(LineSampling, IsUniformInAngle) {
  const LineLight light{{1, 2, 3}, {0.5f, 1, -0.25f}};
  EXPECT_LT(std::abs(angle_deviate(light, {0, 0, 0})), limit);
  EXPECT_LT(std::abs(angle_deviate(light, {1.3f, 2.5f, 3})), limit) << "near";
  EXPECT_LT(std::abs(angle_deviate(light, {1.001f, 2, 3})), limit) << "nearly touching";
  EXPECT_LT(std::abs(angle_deviate(light, {101, 203, -47})), limit) << "nearly end-on";
  EXPECT_LT(std::abs(angle_deviate({{0, 0, 100}, {0.1f, 0, 0}}, {})), limit) << "small";
}

TEST(LineSampling, EndOnIsTheLimit) {
  // The integral of 1 / z² from the near end, 1, to the far end, 3, is 1 - 1 / z.
  const double deviate =
      line_deviate({{0, 0, 2}, {0, 0, 1}}, {}, [](Vec3d way) { return (1 - 1 / way.z) * 1.5; });
  EXPECT_LT(std::abs(deviate), limit);
}

TEST(LineSampling, OnTheLineIsUniformInLength) {
  const double deviate =
      line_deviate({{0, 0, 0}, {0, 0, 1}}, {}, [](Vec3d way) { return 0.5 + 0.5 * way.z; });
  EXPECT_LT(std::abs(deviate), limit);
}

TEST(LineSampling, LiesOnTheLine) {
  const SamplePattern pattern(48);
  LightSamples samples;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> exponent(-20, 20);
  std::normal_distribution<double> normal;
  for (const LineLight& light :
       {LineLight{{1, 2, 3}, {1, 0, 0}}, LineLight{{-300, 2e5f, 3}, {1e-3f, 2e-3f, 0}},
        LineLight{{1, 2, 3}, {3e5f, 1, 2e4f}}})
    for (std::uint64_t key = 0; key < 2000; ++key) {
      const Vec3d way(normal(random), normal(random), normal(random));
      const Vec3f p(Vec3d(light.center) + way * std::exp2(exponent(random)));
      sample_light(light, p, pattern, key, samples);
      const Vec3d c(light.center), half(light.half);
      const double ulp = 0x1p-23 * (length(Vec3d(p)) + length(Vec3d(p) - c) + length(half));
      for (int i = 0; i < 48; ++i) {
        const Vec3d l = Vec3d(p) + Vec3d(samples.x[i], samples.y[i], samples.z[i]);
        ASSERT_LE(distance_to_segment(l, c - half, c + half), 2 * ulp);
      }
    }
}

TEST(LineSampling, FewSamplesAreStratified) {
  const LineLight light{{0, 0, 1}, {1, 0, 0}};
  const SeenLine seen = seen_from(light, {});
  LightSamples samples;
  for (std::uint64_t key = 0; key < 50; ++key) {
    sample_light(light, {}, SamplePattern(16), key, samples);
    std::vector<int> counts(16);
    for (int i = 0; i < 16; ++i)
      ++counts[static_cast<int>((std::atan(samples.x[i]) / seen.angle + 0.5) * 16)];
    EXPECT_EQ(counts, std::vector<int>(16, 1));
  }
}

TEST(LineSampling, DegeneratePlacesGiveFiniteSamples) {
  const SamplePattern pattern(64);
  LightSamples samples;
  for (const LineLight& light :
       {LineLight{{1, 2, 3}, {0.5f, 0, 0}}, LineLight{{1, 2, 3}, {1e-30f, 0, 0}},
        LineLight{{1, 2, 3}, {1e15f, 1e15f, 0}}})
    for (const Vec3f p : {Vec3f(1, 2, 3), Vec3f(1.5f, 2, 3), Vec3f(0.5f, 2, 3),
                          Vec3f(1.5f, 2, std::nextafter(3.f, 4.f)), Vec3f(9, 2, 3),
                          Vec3f(1e18f, 0, 0), Vec3f(-3e38f, 3e38f, 3e38f)}) {
      sample_light(light, p, pattern, 1, samples);
      for (std::size_t i = 0; i < samples.x.size(); ++i)
        ASSERT_TRUE(is_finite(Vec3f(samples.x[i], samples.y[i], samples.z[i])));
    }
}

}  // namespace
}  // namespace penumbra
