// SPDX-License-Identifier: MIT
#include "penumbra/geometry/disk_sampling.h"

#include "penumbra/geometry/light_sampling.h"
#include "penumbra/geometry/seen_disk.h"
#include "tests/geometry/chi_squared.h"
#include "tests/geometry/sample_counts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace penumbra {
namespace {

constexpr double pi = std::numbers::pi;
constexpr int side = 16;
constexpr double limit = 3.9;

/// Solid angles of side x side cells, of equal width in squared radius and in angle.
std::vector<double> cell_angles(const SeenDisk& seen, int steps) {
  std::vector<double> angles(side * side);
  const int all = side * steps;
  for (int i = 0; i < all; ++i)
    for (int j = 0; j < all; ++j) {
      const double r = seen.radius * std::sqrt((i + 0.5) / all), angle = 2 * pi * (j + 0.5) / all;
      const Vec3d l = seen.center + (seen.inward * std::cos(angle) + seen.x * std::sin(angle)) * r;
      const double distance = length(l);
      angles[i / steps * side + j / steps] += seen.height / (distance * distance * distance) * pi *
                                              seen.radius * seen.radius / (1.0 * all * all);
    }
  return angles;
}

double disk_deviate(const DiskLight& light, Vec3f p, std::uint32_t d,
                    const std::vector<double>& shares) {
  const SeenDisk seen = seen_from(light, p);
  const auto bin_of = [&](Vec3d way) {
    const Vec3d w = way - seen.center;
    const double x = dot(w, seen.inward), y = dot(w, seen.x);
    const double m = (x * x + y * y) / (seen.radius * seen.radius);
    double turn = std::atan2(y, x) / (2 * pi);
    if (turn < 0) turn += 1;
    return static_cast<std::size_t>(std::min(side - 1.0, m * side)) * side +
           static_cast<std::size_t>(std::min(side - 1.0, turn * side));
  };
  return chi_squared_deviate(sample_counts(light, p, d, side * side, 100'000, bin_of), shares);
}

TEST(DiskSampling, IsUniformInSolidAngle) {
  const DiskLight light{{0, 0, 2}, {0, 0, 1}, 1};
  const auto check = [&](const DiskLight& disk, Vec3f p, const char* place) {
    const std::vector<double> shares = cell_angles(seen_from(disk, p), 32);
    EXPECT_LT(std::abs(disk_deviate(disk, p, 4, shares)), limit) << place;
  };
  check(light, {0, 0, 0}, "straight above");
  check(light, {0.3f, 0.2f, 1.8f}, "near");
  check(light, {0.1f, 0.2f, 4}, "behind");
  check(light, {-5, 3, 1}, "oblique");
  check(light, {1.2f, 0, 1.97f}, "grazing");
  check(light, {0, 0.9f, 1.9f}, "near the rim");
  check(light, {0, 0, -998}, "far");
  check({{1, 2, 3}, normalize(Vec3f(1, -2, 0.5f)), 0.7f}, {0, 1, 2}, "turned");
  check({{0, 0, 1e4f}, {0, 0.6f, 0.8f}, 1}, {}, "small");
}

TEST(DiskSampling, EdgeOnTinyAndTouchedDisksAreSampledByArea) {
  const DiskLight light{{0, 0, 2}, {0, 0, 1}, 1};
  const std::vector<double> equal(side * side, 1);
  EXPECT_LT(std::abs(disk_deviate(light, {3, 0, 2}, 4, equal)), limit);
  EXPECT_LT(std::abs(disk_deviate(light, {0.5f, 0, 2}, 4, equal)), limit);
  EXPECT_LT(std::abs(disk_deviate({{0, 0, 1}, {0, 0, 1}, 1e-6f}, {}, 4, equal)), limit);
}

TEST(DiskSampling, LiesOnTheDisk) {
  const SamplePattern pattern(48);
  LightSamples samples;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> exponent(-20, 20);
  std::normal_distribution<double> normal;
  for (const DiskLight& light :
       {DiskLight{{1, 2, 3}, {0, 0, 1}, 1}, DiskLight{{-300, 2e5f, 3}, {0, 1, 0}, 1e-3f},
        DiskLight{{1, 2, 3}, normalize(Vec3f(1, 2, -1)), 3e5f}})
    for (std::uint64_t key = 0; key < 2000; ++key) {
      const Vec3d way(normal(random), normal(random), normal(random));
      const Vec3f p(Vec3d(light.center) + way * std::exp2(exponent(random)));
      sample_light(light, p, pattern, key, samples);
      const double distance = length(Vec3d(p) - Vec3d(light.center));
      const double ulp = 0x1p-23 * (length(Vec3d(p)) + distance + light.radius);
      const Vec3d n = normalize(Vec3d(light.normal));
      for (int i = 0; i < 48; ++i) {
        const Vec3d w =
            Vec3d(p) + Vec3d(samples.x[i], samples.y[i], samples.z[i]) - Vec3d(light.center);
        const double height = dot(w, n);
        const double outside = std::max(0.0, length(w - n * height) - light.radius);
        ASSERT_LE(std::hypot(height, outside), 2 * ulp) << "key " << key << ", sample " << i;
      }
    }
}

TEST(DiskSampling, DegeneratePlacesGiveFiniteSamples) {
  const SamplePattern pattern(64);
  LightSamples samples;
  for (const DiskLight& light :
       {DiskLight{{1, 2, 3}, {0, 0, 1}, 0.5f}, DiskLight{{1, 2, 3}, {0.6f, 0, 0.8f}, 1e-30f},
        DiskLight{{1, 2, 3}, {0, 0, 1}, 1e15f}})
    for (const Vec3f p :
         {Vec3f(1, 2, 3), Vec3f(1.5f, 2, 3), Vec3f(1.5f, 2, std::nextafter(3.f, 4.f)),
          Vec3f(1.500001f, 2, 3.000001f), Vec3f(1, 2, 3.5f), Vec3f(9, 2, 3), Vec3f(1e18f, 0, 0),
          Vec3f(1e18f, -1e18f, 3e38f), Vec3f(-3e38f, 3e38f, 3e38f)}) {
      sample_light(light, p, pattern, 1, samples);
      for (std::size_t i = 0; i < samples.x.size(); ++i)
        ASSERT_TRUE(is_finite(Vec3f(samples.x[i], samples.y[i], samples.z[i])));
    }
}

TEST(SeenDisk, SolidAngleIsThatOfTheBooks) {
  const auto angle = [](Vec3f p, float r) {
    return solid_angle(DiskLight{{0, 0, 0}, {0, 0, 1}, r}, p);
  };
  for (const float h : {1e-3f, 0.1f, 1.0f, 30.0f}) {
    const double d = std::hypot(h, 1.0), expected = 2 * pi / (d * (d + h));
    EXPECT_NEAR(angle({0, 0, h}, 1) / expected, 1, 1e-12) << h;
    EXPECT_NEAR(angle({0, 0, -h}, 1) / expected, 1, 1e-12) << h;
  }
  EXPECT_NEAR(angle({0, 0, 1e4f}, 1e-4f) / (pi * 1e-16), 1, 1e-6);
  EXPECT_EQ(angle({3, 0, 0}, 1), 0);
  EXPECT_EQ(angle({0.5f, 0, 0}, 1), 2 * pi);
  // F. Paxton, Solid Angle Calculation for a Circular Disk, 1959: over the rim, by the complete
  // elliptic integral of the first kind.
  for (const float h : {1e-4f, 0.01f, 0.5f, 2.0f}) {
    const double longest = std::hypot(2.0, h), k = 2 / longest;
    const double expected = pi - 2 * h / longest * std::comp_ellint_1(k);
    EXPECT_NEAR(angle({1, 0, h}, 1), expected, 1e-10) << h;
  }
}

TEST(SeenDisk, SolidAngleIsTheIntegral) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  const DiskLight light{{0.5f, 1, 2}, normalize(Vec3f(1, 2, 3)), 1.5f};
  for (int i = 0; i < 30; ++i) {
    const Vec3f p(Vec3d(normal(random), normal(random), normal(random)) * 3.0);
    const SeenDisk seen = seen_from(light, p);
    double sum = 0;
    for (const double angle : cell_angles(seen, 16)) sum += angle;
    EXPECT_NEAR(solid_angle(seen) / sum, 1, 2e-3 / std::min(1.0, seen.height * seen.height));
    EXPECT_NEAR(length(seen.x), 1, 1e-15);
    EXPECT_NEAR(dot(seen.x, seen.z), 0, 1e-15);
    EXPECT_NEAR(dot(seen.y, seen.z), 0, 1e-15);
  }
}

}  // namespace
}  // namespace penumbra
