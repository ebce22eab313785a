// SPDX-License-Identifier: MIT
#include "penumbra/trace/bake.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "penumbra/shadow/visibility.h"
#include "penumbra/trace/prepare.h"
#include "tests/shadow/light_kinds.h"
#include "tests/trace/same_bits.h"
#include "tests/trace/uv_meshes.h"

namespace penumbra {
namespace {

constexpr Method proving[] = {Method::offset, Method::reduced, Method::umbra, Method::shaft};

BakeOptions small(std::uint32_t size) {
  BakeOptions options;
  options.width = options.height = size;
  options.shadow_samples = 16;
  options.padding = 2;
  options.has_classes = true;
  return options;
}

/// All meshes that have coordinates, but the ground.
Bake bake_scene(const Scene& scene, const BakeOptions& options, Method method = Method::shaft) {
  std::vector<std::uint32_t> meshes(scene.shapes.meshes.size());
  std::iota(meshes.begin(), meshes.end(), 0u);
  const Kernel kernel(scene.shapes, kernel_options(scene));
  const UvAtlas atlas = make_atlas(scene, meshes, UvSet::first, options.width, options.height);
  return bake(scene, prepare_shadows(scene, kernel, method), atlas, options);
}

/// Without the classes, which are what a method proves.
Image values(const Bake& baked) {
  Image image = baked.image;
  std::erase_if(image.channels, [](const Channel& c) { return c.name.starts_with("class"); });
  return image;
}

float value_at(const Bake& baked, const char* channel, std::uint32_t x, std::uint32_t y) {
  return find_channel(baked.image, channel)->values[std::size_t(y) * baked.image.width + x];
}

Scene tube_scene(LightShape light) {
  return scene_to_bake({tube_mesh(24, 0.1f, 0.9f)}, {{2, 0, 1}, 0.4f}, std::move(light));
}

class BakeUnder : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(EveryLight, BakeUnder, testing::ValuesIn(light_kinds));

TEST_P(BakeUnder, IsTheSameByEveryMethod) {
  const LightShape light = light_of_kind(GetParam(), {4, 1, 2}, 0.5f, {0, 0, 1});
  for (const Scene& scene :
       {tube_scene(light), scene_to_bake({floor_mesh(0.1f, 0.9f)}, {{2, 2, 1}, 0.5f}, light)}) {
    for (const BakeValue value : {BakeValue::fraction, BakeValue::cosine_weighted}) {
      BakeOptions options = small(30);
      options.value = value;
      const Bake judge = bake_scene(scene, options, Method::stochastic);
      for (const Method method : proving) {
        const Bake other = bake_scene(scene, options, method);
        EXPECT_TRUE(same_bits(values(judge), values(other))) << static_cast<int>(method);
        EXPECT_EQ(other.counters.covered, judge.counters.covered);
      }
    }
  }
}

TEST(Bake, IsTheSameForAnyNumberOfThreads) {
  const Scene scene = tube_scene(BallLight{{4, 1, 2}, 0.5f});
  BakeOptions options = small(70);
  options.threads = 1;
  const Bake one = bake_scene(scene, options);
  for (const std::uint32_t threads : {2u, 7u}) {
    options.threads = threads;
    const Bake many = bake_scene(scene, options);
    EXPECT_TRUE(same_bits(one.image, many.image));
    EXPECT_EQ(one.counters.shadow.rays, many.counters.shadow.rays);
    EXPECT_EQ(one.counters.proven_samples, many.counters.proven_samples);
  }
  options.seed = 1;
  EXPECT_FALSE(same_bits(one.image, bake_scene(scene, options).image));
}

TEST(Bake, HasClassesWhereTheyAreAskedFor) {
  BakeOptions options = small(30);
  const Scene scene = tube_scene(BallLight{{4, 1, 2}, 0.5f});
  const Bake with = bake_scene(scene, options);
  options.has_classes = false;
  const Bake without = bake_scene(scene, options);
  EXPECT_EQ(with.image.channels.size(), 3u);
  EXPECT_EQ(without.image.channels.size(), 2u);
  EXPECT_TRUE(same_bits(values(with), without.image));
  EXPECT_EQ(with.counters.penumbra, without.counters.penumbra);
}

TEST(Bake, PutsShadowsWhereTheTextureHasThem) {
  const Bake baked = bake_scene(floor_scene(), small(64));
  // The ball stands over (1, 1) of [0, 4]^2: a quarter from the left, a quarter from the bottom.
  EXPECT_EQ(value_at(baked, "visibility.light0", 16, 47), 0);
  EXPECT_EQ(value_at(baked, "class.light0", 16, 47), 2);
  for (const auto& [x, y] : {std::pair{16, 16}, {47, 47}, {63, 0}}) {
    EXPECT_EQ(value_at(baked, "visibility.light0", x, y), 1);
    EXPECT_EQ(value_at(baked, "class.light0", x, y), 0);
  }
  EXPECT_EQ(baked.counters.covered, 64u * 64u);
  EXPECT_EQ(baked.counters.overlapping, 0u);
  EXPECT_EQ(baked.counters.lit + baked.counters.penumbra + baked.counters.umbra, 64u * 64u);
}

TEST(Bake, ProvesWholeFootprintsByOneQueryEach) {
  const Bake baked = bake_scene(floor_scene(), small(64));
  EXPECT_GT(baked.counters.proven_samples, 4 * baked.counters.asked_samples);
  EXPECT_GT(baked.counters.umbra, 0u);
}

TEST(Bake, IsTheMeanOfTheVisibleFractionOverTheTexel) {
  const Scene scene = floor_scene();
  BakeOptions options = small(32);
  options.texel_samples = 64, options.shadow_samples = 64;
  const Bake baked = bake_scene(scene, options);
  const Kernel kernel(scene.shapes, kernel_options(scene));
  const ShadowScene shadows = prepare_shadows(scene, kernel, Method::stochastic);
  OccluderQueue queue;
  VisibilityScratch scratch(256);
  ShadowCounters counters;
  double largest = 0;
  for (std::uint32_t y = 20; y < 28; ++y)
    for (std::uint32_t x = 4; x < 12; ++x) {
      double sum = 0;
      for (int i = 0; i < 64; ++i) {
        const float px = (x + (i % 8 + 0.5f) / 8) / 8, py = 4 - (y + (i / 8 + 0.5f) / 8) / 8;
        sum += double(visibility(shadows, 0, {{px, py, 1e-5f}, {0, 0, 1}}, hash(i, x + 64 * y),
                                 queue, scratch, counters)
                          .fraction);
      }
      const double error = sum / 64 - double(value_at(baked, "visibility.light0", x, y));
      largest = std::max(largest, std::abs(error));
    }
  EXPECT_LT(largest, 0.01);
}

TEST(Bake, WeighsByTheCosineWhatIsAboveTheHorizon) {
  // Half of the light is below the wall's horizon, and nothing stands before the other half.
  const Scene scene = scene_to_bake({floor_mesh()}, {{100, 0, 0}, 1}, BallLight{{30, 2, 0}, 1.5f});
  BakeOptions options = small(8);
  EXPECT_NEAR(value_at(bake_scene(scene, options), "visibility.light0", 4, 4), 0.5, 0.05);
  options.value = BakeValue::cosine_weighted;
  EXPECT_EQ(value_at(bake_scene(scene, options), "visibility.light0", 4, 4), 1);
}

TEST(Bake, MixesTheTrianglesOfATexelByArea) {
  // Half of the texture lies under a roof, whose edge cuts a row of texels at a quarter.
  Mesh lit = floor_mesh(), dark = floor_mesh();
  constexpr float edge = 8.25f / 16;
  for (Vec2f& uv : lit.uvs) uv.u *= edge;
  for (Vec2f& uv : dark.uvs) uv.u = edge + uv.u * (1 - edge);
  for (Vec3f& p : dark.positions) p.z = -5;
  BakeOptions options = small(16);
  options.texel_samples = 256;
  const Bake baked =
      bake_scene(scene_to_bake({lit, dark}, {{100, 0, 0}, 1}, BallLight{{2, 2, 3}, 0.2f}), options);
  EXPECT_EQ(value_at(baked, "visibility.light0", 7, 8), 1);
  EXPECT_NEAR(value_at(baked, "visibility.light0", 8, 8), 0.25, 0.01);
  EXPECT_EQ(value_at(baked, "visibility.light0", 9, 8), 0);
}

TEST(Bake, LooksToTheSideThatIsOutside) {
  Mesh mesh = floor_mesh();
  const auto brightest = [&](const Mesh& m) {
    const Bake baked =
        bake_scene(scene_to_bake({m}, {{100, 0, 0}, 1}, BallLight{{2, 2, 3}, 0.2f}), small(8));
    return value_at(baked, "visibility.light0", 4, 4);
  };
  EXPECT_EQ(brightest(mesh), 1);
  for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  EXPECT_EQ(brightest(mesh), 0);
  mesh.normals.assign(4, {0, 0, 1});
  EXPECT_EQ(brightest(mesh), 1);
}

TEST(Bake, HasNoSeamWhereASurfaceIsCutOpen) {
  BakeOptions options = small(192);
  options.texel_samples = 16, options.shadow_samples = 64;
  // The shadow falls on the seam.
  const Bake baked = bake_scene(tube_scene(BallLight{{5, 0.1f, 1}, 0.5f}), options);
  const Texture texture = texture_of(baked.image, "visibility.light0");
  float least = 1, most = 0, largest = 0;
  for (int i = 0; i <= 400; ++i) {
    const float v = 0.1f + 0.8f * static_cast<float>(i) / 400;
    const float left = sample(texture, {0.1f, v}).x, right = sample(texture, {0.9f, v}).x;
    least = std::min(least, left), most = std::max(most, left);
    largest = std::max(largest, std::abs(left - right));
  }
  EXPECT_LT(least, 0.05f);
  EXPECT_GT(most, 0.95f);
  EXPECT_LT(largest, 0.04f);
}

TEST(Bake, PadsSoThatFilteringInAChartReadsNoEmptyTexel) {
  BakeOptions options = small(61);
  options.padding = 2, options.background = -100;
  const Bake baked = bake_scene(tube_scene(BallLight{{4, 1, 2}, 0.5f}), options);
  const Texture texture = texture_of(baked.image, "visibility.light0");
  for (int i = 0; i <= 100; ++i)
    for (int k = 0; k <= 100; ++k) {
      const auto at = [](int n) { return 0.1f + 0.8f * static_cast<float>(n) / 100; };
      EXPECT_GE(sample(texture, {at(i), at(k)}).x, 0);
    }
  EXPECT_EQ(value_at(baked, "visibility.light0", 0, 0), -100);
  EXPECT_EQ(value_at(baked, "coverage", 0, 0), 0);
  EXPECT_EQ(value_at(baked, "coverage", 30, 30), 1);
  const std::vector<float>& coverage = find_channel(baked.image, "coverage")->values;
  EXPECT_EQ(std::count(coverage.begin(), coverage.end(), 1.0f),
            std::ptrdiff_t(baked.counters.covered));
  EXPECT_EQ(std::count(coverage.begin(), coverage.end(), 0.5f),
            std::ptrdiff_t(baked.counters.padded));
  EXPECT_GT(baked.counters.padded, 0u);
}

TEST(Bake, CountsTexelsThatSeveralTrianglesClaim) {
  const Scene scene = scene_to_bake({floor_mesh(0, 0.5f), floor_mesh(0.25f, 0.75f)},
                                    {{100, 0, 0}, 1}, BallLight{{1, 1, 5}, 0.6f});
  EXPECT_EQ(bake_scene(scene, small(64)).counters.overlapping, 16u * 16u);
}

TEST(Bake, OfTrianglesSmallerThanTexelsIsTheSameByEveryMethod) {
  const Scene scene =
      scene_to_bake({tube_mesh(400, 0.1f, 0.9f)}, {{2, 0, 1}, 0.4f}, BallLight{{5, 0.1f, 1}, 0.5f});
  const Bake judge = bake_scene(scene, small(24), Method::stochastic);
  EXPECT_TRUE(same_bits(values(judge), values(bake_scene(scene, small(24)))));
}

TEST(Bake, TellsHowFarItIs) {
  BakeOptions options = small(40);
  double last = 0;
  int calls = 0;
  options.progress = [&](double share) {
    EXPECT_GE(share, last);
    last = share, ++calls;
  };
  bake_scene(floor_scene(), options);
  EXPECT_EQ(last, 1);
  EXPECT_GT(calls, 4);
}

}  // namespace
}  // namespace penumbra
