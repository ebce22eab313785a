// SPDX-License-Identifier: MIT
#include "penumbra/scene/material.h"

#include <limits>

#include <gtest/gtest.h>

namespace penumbra {
namespace {

/// Upper row black, red; lower row green, white.
Texture four_texels() { return {2, 2, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 1}}}; }

TEST(Texture, TexelCentresGiveTheirPixels) {
  const Texture texture = four_texels();
  EXPECT_EQ(sample(texture, {0.25f, 0.75f}), (Color{0, 0, 0}));
  EXPECT_EQ(sample(texture, {0.75f, 0.75f}), (Color{1, 0, 0}));
  EXPECT_EQ(sample(texture, {0.25f, 0.25f}), (Color{0, 1, 0}));
  EXPECT_EQ(sample(texture, {0.75f, 0.25f}), (Color{1, 1, 1}));
}

TEST(Texture, MiddleIsTheMean) {
  const Color middle = sample(four_texels(), {0.5f, 0.5f});
  EXPECT_FLOAT_EQ(middle.x, 0.5f);
  EXPECT_FLOAT_EQ(middle.y, 0.5f);
  EXPECT_FLOAT_EQ(middle.z, 0.25f);
}

TEST(Texture, RepeatsOutsideTheUnitSquare) {
  const Texture texture = four_texels();
  EXPECT_EQ(sample(texture, {-2.75f, 7.75f}), sample(texture, {0.25f, 0.75f}));
  EXPECT_EQ(sample(texture, {0, 0}), sample(texture, {1, 1}));
}

TEST(Texture, AnyCoordinateIsSafe) {
  const Texture texture = four_texels();
  for (float c : {1e30f, -1e30f, -1e-30f, std::numeric_limits<float>::infinity(),
                  std::numeric_limits<float>::quiet_NaN()}) {
    const Color color = sample(texture, {c, c});
    EXPECT_GE(color.x, 0);
    EXPECT_LE(color.x, 1);
  }
}

TEST(Texture, EmptyIsWhite) { EXPECT_EQ(sample(Texture{}, {0.3f, 0.4f}), (Color{1, 1, 1})); }

}  // namespace
}  // namespace penumbra
