// SPDX-License-Identifier: MIT
// The contract: every method but `hard` draws the picture of `stochastic`, bit for bit.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "penumbra/scene/complete_scene.h"
#include "penumbra/scene/gallery.h"
#include "penumbra/scene_io/read_scene.h"
#include "penumbra/trace/prepare.h"
#include "penumbra/trace/render.h"
#include "tests/shadow/light_kinds.h"
#include "tests/trace/same_bits.h"

namespace penumbra {
namespace {

constexpr Method proving[] = {Method::offset, Method::reduced, Method::umbra, Method::shaft};

RenderOptions picture(std::uint32_t size, std::uint32_t d) {
  RenderOptions options;
  options.width = options.height = size;
  options.shadow_samples = d;
  options.aovs = {Aov::visibility};
  return options;
}

/// What a method's proofs claimed, to see that a test is not empty.
struct Proofs {
  std::uint64_t lit = 0, umbra = 0;
};

/// All methods against the judge.
Proofs expect_identity(const Scene& scene, const RenderOptions& options) {
  const Kernel kernel(scene.shapes, kernel_options(scene));
  const auto draw = [&](Method method) {
    return render(scene, prepare_shadows(scene, kernel, method), options);
  };
  const Picture judge = draw(Method::stochastic);
  Proofs proofs;
  for (const Method method : proving) {
    const Picture other = draw(method);
    EXPECT_TRUE(same_bits(judge.image, other.image)) << "method " << static_cast<int>(method);
    EXPECT_EQ(other.counters.reflected, judge.counters.reflected);
    proofs.lit += other.counters.shadow.lit, proofs.umbra += other.counters.shadow.umbra;
  }
  return proofs;
}

/// One ray after the other: other counters, the same picture.
void expect_identity_of_single_rays(const Scene& scene, const RenderOptions& options) {
  const Kernel kernel(scene.shapes, kernel_options(scene));
  for (const Method method :
       {Method::hard, Method::stochastic, Method::offset, Method::reduced, Method::umbra}) {
    ShadowScene shadows = prepare_shadows(scene, kernel, method);
    const Picture packets = render(scene, shadows, options);
    shadows.rays = RayGrouping::single;
    const Picture single = render(scene, shadows, options);
    EXPECT_TRUE(same_bits(packets.image, single.image)) << "method " << static_cast<int>(method);
    EXPECT_LE(single.counters.shadow.rays, packets.counters.shadow.rays * 11 / 10);
  }
}

/// The scene with all its lights in another shape, `growth` times as large.
Scene with_lights(Scene scene, std::string_view kind, float growth) {
  const Box box = object_bounds(scene.shapes);
  for (Light& light : scene.lights) {
    const auto* ball = std::get_if<BallLight>(&light.shape);
    const std::optional<Vec3f> at = center(light.shape);
    const float radius = ball ? ball->radius : 0.05f * box.largest_extent();
    if (at) light.shape = light_of_kind(kind, *at, radius * growth, box.center());
  }
  return scene;
}

Scene built_in(const std::string& name) { return complete_scene(*gallery_scene(name), {}); }

class Identity : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(BuiltIn, Identity,
                         testing::Values("balls:2", "rings", "molecule", "cylinders", "bust"));

TEST_P(Identity, OfTheBuiltInScene) {
  const Proofs proofs = expect_identity(built_in(GetParam()), picture(48, 8));
  EXPECT_GT(proofs.lit, 100u);
  EXPECT_GT(proofs.umbra, 0u);
}

TEST_P(Identity, OfRaysTracedOneByOne) {
  expect_identity_of_single_rays(built_in(GetParam()), picture(32, 40));
}

class IdentityUnder : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(EveryLight, IdentityUnder, testing::ValuesIn(light_kinds));

TEST_P(IdentityUnder, ALightOfThisShape) {
  for (const char* name : {"cylinders", "rings", "balls:1"})
    expect_identity(with_lights(built_in(name), GetParam(), 1.5f), picture(32, 8));
  expect_identity_of_single_rays(with_lights(built_in("rings"), GetParam(), 1.5f), picture(32, 40));
}

TEST(IdentityUnderBeams, OfASceneLitInParts) {
  Scene scene = built_in("rings");
  for (const char* kind : {"point", "ball", "disk"}) {
    scene = with_lights(scene, kind, 1);
    for (Light& light : scene.lights) {
      const Vec3f axis = -towards_center(light.shape, Vec3f(object_bounds(scene.shapes).center()));
      light.beam = Beam{normalize(axis), 0.995f, 0.98f};
    }
    scene.camera->parallel_height = 2 * object_bounds(scene.shapes).largest_extent();
    expect_identity(scene, picture(48, 8));
  }
}

class SlowIdentity : public testing::TestWithParam<std::tuple<const char*, const char*>> {};
INSTANTIATE_TEST_SUITE_P(Matrix, SlowIdentity,
                         testing::Combine(testing::Values("balls:3", "rings", "molecule",
                                                          "cylinders", "bust"),
                                          testing::ValuesIn(light_kinds)));

TEST_P(SlowIdentity, OfEveryLightAndNumberOfSamples) {
  const auto& [name, kind] = GetParam();
  for (const float growth : {0.2f, 1.0f, 5.0f})
    for (const std::uint32_t d : {1u, 8u, 32u, 100u})
      expect_identity(with_lights(built_in(name), kind, growth), picture(96, d));
}

/// Files of others: every scene below the folder that PENUMBRA_DATA names.
TEST(SlowIdentityOfFiles, OfEverySceneThatCanBeRead) {
  const char* folder = std::getenv("PENUMBRA_DATA");
  if (!folder) GTEST_SKIP() << "PENUMBRA_DATA names no folder of scenes";
  int scenes = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    Scene scene;
    try {
      scene = complete_scene(read_scene(entry.path().string(), {}).scene, {});
    } catch (const std::exception&) {
      continue;  // no scene, or none that can be drawn
    }
    SCOPED_TRACE(entry.path().string());
    std::fprintf(stderr, "%s\n", entry.path().c_str());
    for (const char* kind : {"ball", "parallelogram", "sun"})
      expect_identity(with_lights(scene, kind, 1), picture(96, 32));
    ++scenes;
  }
  EXPECT_GT(scenes, 0);
}

}  // namespace
}  // namespace penumbra
