// SPDX-License-Identifier: MIT
#include "class_map.h"

#include <gtest/gtest.h>

#include <limits>

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

TEST(ClassMap, IsOfTheFirstLightWhereSomethingIsHit) {
  const float nothing = std::numeric_limits<float>::infinity();
  const Image map = class_map(
      {2, 1, {{"class.light0", {2, 0}}, {"depth.Z", {5, nothing}}, {"class.light1", {0, 0}}}, {}});
  EXPECT_EQ(color(map, 0), (std::vector{22, 38, 96}));
  EXPECT_EQ(color(map, 1), (std::vector{160, 160, 160}));
}

TEST(ClassMap, NeedsClasses) { EXPECT_THROW(class_map({1, 1, {{"R", {0}}}, {}}), Error); }

}  // namespace
}  // namespace penumbra::reproduce
