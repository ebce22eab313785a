// SPDX-License-Identifier: MIT
#include "penumbra/render.h"

#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <stdexcept>
#include <string>

#include "penumbra/kernel/kernel.h"
#include "penumbra/trace/prepare.h"
#include "penumbra/trace/render.h"

namespace penumbra {
namespace {

Scene cylinders() { return complete_scene(find_scene("cylinders").scene, {}); }

std::vector<float> values(const Picture& picture) {
  std::vector<float> all;
  for (const Channel& channel : picture.image.channels)
    all.insert(all.end(), channel.values.begin(), channel.values.end());
  return all;
}

TEST(Renderer, DrawsThePictureOfTheLayersBelow) {
  const Scene scene = cylinders();
  const RenderOptions options{.width = 40, .height = 30, .aovs = {Aov::depth}};
  const Kernel kernel(scene.shapes, kernel_options(scene));
  const Picture expected =
      render(scene, prepare_shadows(scene, kernel, Method::stochastic), options);
  EXPECT_EQ(values(Renderer(scene, Method::stochastic).render(options)), values(expected));
  EXPECT_EQ(values(Renderer(scene).render(options)), values(expected));
}

TEST(Renderer, CanBeMovedAndKeepsItsScene) {
  Renderer first(cylinders(), Method::umbra);
  const std::vector<float> before = values(first.render({.width = 16, .height = 16}));
  const Renderer second = std::move(first);
  EXPECT_EQ(second.method(), Method::umbra);
  EXPECT_EQ(second.scene().lights.size(), cylinders().lights.size());
  EXPECT_GT(second.memory_bytes(), 0u);
  EXPECT_EQ(values(second.render({.width = 16, .height = 16})), before);
}

TEST(Renderer, IsEndedByWhatItsProgressThrows) {
  const Renderer renderer(cylinders());
  std::atomic<int> calls = 0;
  RenderOptions options{.width = 2048, .height = 2048};
  options.progress = [&calls](double) {
    if (++calls == 3) throw std::runtime_error("enough");
  };
  EXPECT_THROW(renderer.render(options), std::runtime_error);
  EXPECT_LT(calls, 100);
  EXPECT_NO_THROW(renderer.render({.width = 16, .height = 16}));
}

TEST(Renderer, RefusesWhatMakesNoPicture) {
  const Renderer renderer(cylinders());
  EXPECT_THROW(renderer.render({.width = 0}), Error);
  EXPECT_THROW(renderer.render({.width = 65536, .height = 65536}), Error);
  EXPECT_THROW(renderer.render({.shadow_samples = 0}), Error);
  EXPECT_THROW(renderer.render({.samples_per_pixel = 0}), Error);
  EXPECT_THROW(renderer.render({.depth = 65}), Error);
  EXPECT_THROW(renderer.render({.tile = 0}), Error);
  EXPECT_THROW(renderer.render({.threads = 1025}), Error);
  EXPECT_THROW(Renderer{Scene{}}, Error);
}

TEST(FindScene, NamesTheBuiltInScenesWhereThereIsNoFile) {
  try {
    find_scene("no/such.obj");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.place.file, "no/such.obj");
    EXPECT_NE(error.hint.find("cylinders"), std::string::npos);
  }
}

TEST(RenderFile, WritesThePictureWholeOrNotAtAll) {
  const std::filesystem::path folder =
      std::filesystem::path(testing::TempDir()) / "penumbra_render_file";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  RenderFileOptions options{.render = {.width = 24, .height = 16}, .keeps_file_size = false};
  const Picture drawn = render_file("cylinders", folder / "a.exr", options);
  const Image read = read_image(folder / "a.exr");
  EXPECT_EQ(read.width, 24u);
  EXPECT_EQ(find_channel(read, "G")->values, find_channel(drawn.image, "G")->values);

  EXPECT_THROW(render_file("cylinders", folder / "a.gif", options), Error);
  EXPECT_THROW(render_file("no/such.obj", folder / "b.png", options), Error);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 1);
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace penumbra
