// SPDX-License-Identifier: MIT
// Lights of all sizes, receivers at all distances: on corners, on edges, in planes, within an ulp.
#include "penumbra/geometry/irradiance.h"
#include "penumbra/geometry/light_sampling.h"
#include "tests/geometry/light_shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace penumbra {
namespace {

class LightFuzz : public testing::Test {
 protected:
  double power(double from, double to) { return std::exp2(from + (to - from) * unit_(random_)); }
  Vec3d vector() { return {normal_(random_), normal_(random_), normal_(random_)}; }
  Vec3d direction() { return normalize(vector()); }

  LightShape light(int kind) {
    const double away = power(-30, 30), size = away * power(-10, 20);
    const Vec3f c(vector() * away);
    const Vec3f u(vector() * size), v(vector() * (size * power(-4, 0)));
    switch (kind) {
      case 0: return DiskLight{c, Vec3f(direction()), static_cast<float>(size)};
      case 1: return LineLight{c, u};
      case 2: return ParallelogramLight{c, u, v};
      case 3: return polygon_around(c, u, v, 3 + static_cast<int>(10 * unit_(random_)));
      default: return box_around(c, max(u, -u));
    }
  }

  /// A point of the light: of its rim, its corners and edges, or of its middle.
  Vec3d point_of(const LightShape& shape) {
    if (unit_(random_) < 0.5) return *support(shape, vector());
    const double share = unit_(random_);
    return *support(shape, vector()) * share + *support(shape, vector()) * (1 - share);
  }

  Vec3f receiver(const LightShape& shape, double size) {
    const Vec3d on = point_of(shape);
    const double choice = unit_(random_);
    if (choice < 0.2) return Vec3f(on);
    if (choice < 0.4) return Vec3f(on + (point_of(shape) - on) * (4 * unit_(random_)));
    if (choice < 0.45) return Vec3f(direction() * 3e38);
    return Vec3f(on + direction() * (size * power(-25, 20)));
  }

  std::mt19937 random_{5};
  std::uniform_real_distribution<double> unit_;
  std::normal_distribution<double> normal_;
};

TEST_F(LightFuzz, SamplesLieInTheLightAndValuesInTheirRange) {
  const SamplePattern pattern(16);
  LightSamples samples;
  for (std::uint64_t key = 0; key < 50'000; ++key) {
    const LightShape shape = light(static_cast<int>(key % 5));
    const Box box = *bounds(shape);
    const double size = length(Vec3d(box.hi) - Vec3d(box.lo));
    const Vec3f p = receiver(shape, size);
    sample_light(shape, p, pattern, key, samples);
    const Vec3d middle(*center(shape));
    const double ulp = 0x1p-24 * (length(Vec3d(p)) + length(Vec3d(p) - middle) + size);
    for (int i = 0; i < 16; ++i) {
      const Vec3f way(samples.x[i], samples.y[i], samples.z[i]);
      ASSERT_TRUE(is_finite(way)) << "key " << key;
      const Vec3d l = Vec3d(p) + Vec3d(way), from_middle = normalize(l - middle);
      ASSERT_LE(dot(l - *support(shape, from_middle), from_middle), 8 * ulp) << "key " << key;
    }
    const double e = irradiance(shape, p, Vec3f(direction()));
    ASSERT_TRUE(e >= 0 && e <= 1) << "key " << key << ": " << e;
    const double angle = solid_angle(shape, p);
    ASSERT_TRUE(angle >= 0 && angle <= 4 * std::numbers::pi) << "key " << key << ": " << angle;
    const double factor = inverse_square_factor(shape, p);
    ASSERT_TRUE(factor >= 0 && std::isfinite(factor)) << "key " << key << ": " << factor;
    ASSERT_TRUE(contains(shape, Vec3f(point_of(shape)))) << "key " << key;
  }
}

}  // namespace
}  // namespace penumbra
