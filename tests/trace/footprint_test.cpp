// SPDX-License-Identifier: MIT
#include "penumbra/trace/footprint.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace penumbra {
namespace {

class Noise {
 public:
  double operator()(double lo, double hi) {
    return std::uniform_real_distribution<double>(lo, hi)(generator_);
  }
  TexelTriangle triangle(double size) {
    TexelTriangle t;
    for (TexelPoint& p : t) {
      p.x = (*this)(-1, 1) * size + 4, p.y = (*this)(-1, 1) * size + 4;
      p.position = {2 * p.x + p.y, p.x - p.y, 3};
    }
    return t;
  }

 private:
  std::mt19937 generator_{7};
};

TEST(Footprint, OfAllTexelsTogetherIsTheTriangle) {
  Noise noise;
  for (int trial = 0; trial < 200; ++trial) {
    const TexelTriangle t = noise.triangle(4);
    double sum = 0;
    for (int y = -1; y < 10; ++y)
      for (int x = -1; x < 10; ++x) sum += texel_area(Footprint(t, {double(x), double(y), 1}));
    EXPECT_NEAR(sum, texel_area(t[0], t[1], t[2]), 1e-9);
  }
}

TEST(Footprint, LiesInTheSquareAndOnTheSurface) {
  Noise noise;
  for (int trial = 0; trial < 500; ++trial) {
    const Footprint footprint(noise.triangle(4), {3, 4, 2});
    EXPECT_LE(footprint.corners().size(), 7u);
    for (const TexelPoint& p : footprint.corners()) {
      EXPECT_TRUE(p.x >= 3 - 1e-9 && p.x <= 5 + 1e-9 && p.y >= 4 - 1e-9 && p.y <= 6 + 1e-9);
      EXPECT_NEAR(p.position.x, 2 * p.x + p.y, 1e-9);
      EXPECT_NEAR(p.position.y, p.x - p.y, 1e-9);
    }
  }
}

TEST(Footprint, OfASliverStaysOnIt) {
  const TexelTriangle sliver{{{0, 0, {0, 0, 0}}, {1e6, 1e-9, {1, 0, 0}}, {1e6, 0, {1, 1, 0}}}};
  const Footprint footprint(sliver, {1000, 0, 1});
  for (const TexelPoint& p : footprint.corners()) {
    EXPECT_TRUE(p.position.x >= 0 && p.position.x <= 1 && p.position.y >= 0);
    EXPECT_LE(p.position.y, p.position.x);
  }
}

TEST(Footprint, LosesNoCornerFarOutInTheLargestTexture) {
  Noise noise;
  constexpr double far = 1000 * 65536.0, least_area = 1e-7;
  for (int trial = 0; trial < 1000; ++trial) {
    TexelTriangle around = noise.triangle(far);
    around[0].x = around[0].y = -far, around[1].x = far, around[1].y = -far;
    around[2].x = 0, around[2].y = far;
    const TexelSquare square{std::floor(noise(0, 65535)), std::floor(noise(0, 65535)), 1};
    EXPECT_NEAR(texel_area(Footprint(around, square)), 1, least_area);
    // Two triangles that share an edge through the square cover it together.
    const TexelPoint middle{square.x + noise(0, 1), square.y + noise(0, 1), {}};
    const double angle = noise(0, 7);
    const double dx = std::cos(angle) * far / 2, dy = std::sin(angle) * far / 2;
    const TexelPoint a{middle.x - dx, middle.y - dy, {}}, b{middle.x + dx, middle.y + dy, {}};
    const TexelPoint left{middle.x - dy, middle.y + dx, {}},
        right{middle.x + dy, middle.y - dx, {}};
    EXPECT_NEAR(
        texel_area(Footprint({a, b, left}, square)) + texel_area(Footprint({b, a, right}, square)),
        1, least_area);
  }
}

TEST(MayMeet, IsTrueWhereverTheyShareArea) {
  Noise noise;
  int apart = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const TexelTriangle t = noise.triangle(6);
    const bool may = may_meet(t, 2, 4, 2, 4);
    const bool does = texel_area(Footprint(t, {2, 2, 2})) > 0;
    EXPECT_TRUE(may || !does);
    apart += !may && !does;
    EXPECT_FALSE(may && texel_area(Footprint(t, {1.99, 1.99, 2.02})) == 0);
  }
  EXPECT_GT(apart, 100);
}

TEST(IsInside, TakesNeitherEdgesNorWhatIsOutside) {
  TexelTriangle t{{{0, 0, {}}, {4, 0, {}}, {0, 4, {}}}};
  for (int turn = 0; turn < 2; ++turn) {
    EXPECT_TRUE(is_inside(t, 1, 1));
    EXPECT_FALSE(is_inside(t, 2, 2));
    EXPECT_FALSE(is_inside(t, 0, 1));
    EXPECT_FALSE(is_inside(t, 3, 3));
    std::swap(t[1], t[2]);
  }
}

}  // namespace
}  // namespace penumbra
