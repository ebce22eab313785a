// SPDX-License-Identifier: MIT
#include "penumbra/shadow/chord.h"

#include <gtest/gtest.h>

#include <random>

namespace penumbra {
namespace {

bool holds(Chord chord, double s) { return chord.from <= s && s <= chord.to; }

TEST(Chord, BelowIsAHalfLineAllOrNothing) {
  EXPECT_TRUE(holds(chord_below(-1, 2), 0.5) && !holds(chord_below(-1, 2), 0.51));
  EXPECT_TRUE(holds(chord_below(1, -2), 0.5) && !holds(chord_below(1, -2), 0.49));
  EXPECT_TRUE(holds(chord_below(0, 0), 1e300));
  EXPECT_TRUE(chord_below(1, 0).is_empty());
  EXPECT_TRUE(chord_below(NAN, 0).is_empty());
  EXPECT_TRUE(common(chord_below(-1, 1), chord_below(2, -1)).is_empty());
}

/// Rising lines, ones that run along the axis, cones that open faster than the line and slower.
TEST(Chord, OfAConeIsWhereTheLineLiesInIt) {
  std::mt19937_64 engine(41);
  const auto uniform = [&] { return std::uniform_real_distribution<double>(-2, 2)(engine); };
  const auto often_zero = [&] { return engine() % 3 == 0 ? 0 : uniform(); };
  int inside = 0;
  for (int i = 0; i < 200'000; ++i) {
    const Vec3d a{often_zero(), uniform(), uniform()}, b{often_zero(), often_zero(), often_zero()};
    const double radius = uniform(), growth = often_zero();
    const Chord chord = chord_of_cone(a, b, radius, growth);
    for (double s : {-3.0, -0.3, 0.0, 0.1, 0.9, 1.0, 4.0}) {
      const double room = radius + s * growth - length(a + b * s);
      if (std::abs(room) < 1e-9) continue;
      ASSERT_EQ(holds(chord, s), room > 0) << i << " at " << s;
      inside += room > 0;
    }
  }
  EXPECT_GT(inside, 100'000);
}

TEST(Chord, OfWhatIsNoNumberIsEmpty) {
  EXPECT_TRUE(chord_of_cone({NAN, 0, 0}, {1, 0, 0}, 1, 0).is_empty());
  EXPECT_TRUE(chord_of_cone({0, 0, 0}, {1, NAN, 0}, 1, 0).is_empty());
  EXPECT_TRUE(chord_of_cone({0, 0, 0}, {1, 0, 0}, NAN, 0).is_empty());
}

}  // namespace
}  // namespace penumbra
