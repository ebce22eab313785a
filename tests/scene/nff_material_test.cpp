// SPDX-License-Identifier: MIT
#include "penumbra/scene/nff_material.h"

#include <gtest/gtest.h>

#include "penumbra/scene/image.h"

namespace penumbra {
namespace {

TEST(NffMaterial, KdScalesTheLinearColour) {
  const Material material = nff_material({1, 0.5f, 0}, 0.5f, 0, 10, 0, 0);
  EXPECT_FLOAT_EQ(material.diffuse.x, 0.5f);
  EXPECT_FLOAT_EQ(material.diffuse.y, 0.5f * linear_from_srgb(0.5f));
  EXPECT_EQ(material.diffuse.z, 0);
}

TEST(NffMaterial, KsIsHighlightAndMirror) {
  const Material material = nff_material({1, 1, 1}, 0.5f, 0.25f, 12, 0, 0);
  EXPECT_EQ(material.highlight, (Color{0.25f, 0.25f, 0.25f}));
  EXPECT_EQ(material.mirror, material.highlight);
  EXPECT_EQ(material.shininess, 12);
}

TEST(NffMaterial, SentinelShineMeansNoHighlight) {
  const Material material = nff_material({1, 1, 1}, 0.5f, 0.25f, 100000, 0, 0);
  EXPECT_EQ(material.highlight, Color{});
  EXPECT_EQ(material.mirror, (Color{0.25f, 0.25f, 0.25f}));
}

TEST(NffMaterial, RefractionIndexCountsOnlyWithTransmission) {
  EXPECT_EQ(nff_material({1, 1, 1}, 1, 0, 1, 0, 0).refraction_index, 1);
  const Material glass = nff_material({1, 1, 1}, 0.1f, 0.1f, 100, 0.9f, 1.5f);
  EXPECT_EQ(glass.refraction_index, 1.5f);
  EXPECT_EQ(glass.transmission, (Color{0.9f, 0.9f, 0.9f}));
}

TEST(NffMaterial, LightsTogetherGiveHalfTheRootOfTheirNumber) {
  EXPECT_FLOAT_EQ(nff_light_intensity(1), 0.5f);
  EXPECT_FLOAT_EQ(nff_light_intensity(4), 0.25f);
  EXPECT_EQ(nff_light_intensity(0), 0);
}

}  // namespace
}  // namespace penumbra
