// SPDX-License-Identifier: MIT
#include "class_map.h"

#include <gtest/gtest.h>

#include "penumbra/scene/error.h"

namespace penumbra::reproduce {
namespace {

/// sRGB codes of one pixel's colour.
std::vector<int> color(const Image& map, std::size_t pixel) {
  std::vector<int> codes;
  for (const Channel& channel : map.channels)
    codes.push_back(srgb_from_linear(channel.values[pixel]));
  return codes;
}

TEST(ClassMap, OneColourAClass) {
  const Image map = class_map({3, 1, {{"class.light0", {0, 1, 2}}}, {}});
  EXPECT_EQ(color(map, 0), (std::vector{255, 242, 194}));
  EXPECT_EQ(color(map, 1), (std::vector{224, 84, 30}));
  EXPECT_EQ(color(map, 2), (std::vector{22, 38, 96}));
}

TEST(ClassMap, OfSeveralLightsTheMean) {
  const Image map = class_map(
      {2, 1, {{"class.light0", {0, 2}}, {"depth.Z", {5, 5}}, {"class.light1", {2, 2}}}, {}});
  EXPECT_NEAR(color(map, 0)[0], (255 + 22) / 2, 1);
  EXPECT_NEAR(color(map, 0)[2], (194 + 96) / 2, 1);
  EXPECT_EQ(color(map, 1), (std::vector{22, 38, 96}));
}

TEST(ClassMap, NeedsClasses) { EXPECT_THROW(class_map({1, 1, {{"R", {0}}}, {}}), Error); }

}  // namespace
}  // namespace penumbra::reproduce
