// SPDX-License-Identifier: MIT
#include "penumbra/scene/image.h"

#include <limits>

#include <gtest/gtest.h>

namespace penumbra {
namespace {

TEST(Image, ChannelsAreFoundByName) {
  Image image;
  image.channels = {{"R", {1}}, {"class.light0", {2}}};
  ASSERT_NE(find_channel(image, "class.light0"), nullptr);
  EXPECT_EQ(find_channel(image, "class.light0")->values.front(), 2);
  EXPECT_EQ(find_channel(image, "G"), nullptr);
}

TEST(Image, EverySrgbCodeSurvivesTheRoundTrip) {
  for (int code = 0; code < 256; ++code)
    EXPECT_EQ(srgb_from_linear(linear_from_srgb(static_cast<float>(code) / 255)), code);
}

TEST(Image, SrgbKnowsTheStandardsMiddleGrey) {
  EXPECT_EQ(srgb_from_linear(0.5f), 188);
  EXPECT_NEAR(linear_from_srgb(0.5f), 0.21404f, 1e-5f);
  EXPECT_NEAR(linear_from_srgb(0.04f), 0.04f / 12.92f, 1e-7f);
}

TEST(Image, SrgbTakesAnyFloat) {
  EXPECT_EQ(srgb_from_linear(std::numeric_limits<float>::quiet_NaN()), 0);
  EXPECT_EQ(srgb_from_linear(-1), 0);
  EXPECT_EQ(srgb_from_linear(-std::numeric_limits<float>::infinity()), 0);
  EXPECT_EQ(srgb_from_linear(7), 255);
  EXPECT_EQ(srgb_from_linear(std::numeric_limits<float>::infinity()), 255);
}

}  // namespace
}  // namespace penumbra
