// SPDX-License-Identifier: MIT
#include "penumbra/trace/shadow_work.h"

#include <gtest/gtest.h>

#include <cmath>

#include "penumbra/scene/complete_scene.h"
#include "penumbra/scene/gallery.h"
#include "penumbra/trace/pixel.h"
#include "penumbra/trace/prepare.h"

namespace penumbra {
namespace {

/// A built-in scene with what asks and answers.
struct Case {
  explicit Case(const char* name, float radius_percent = 10)
      : scene(complete_scene(*gallery_scene(name), with_radius(radius_percent))),
        kernel(scene.shapes, kernel_options(scene)) {
    options.width = 50, options.height = 40;  // blocks that are cut, too
    options.samples_per_pixel = 2;
    options.shadow_samples = 9;
  }

  static SceneOptions with_radius(float percent) {
    SceneOptions options;
    options.light_radius = LightRadius{percent, true};
    return options;
  }

  ShadowWork record(std::uint32_t threads = 1) {
    options.threads = threads;
    return record_shadow_work(scene, kernel, options);
  }

  Scene scene;
  Kernel kernel;
  RenderOptions options;
};

bool same_questions(const ShadowWork& a, const ShadowWork& b) {
  if (a.blocks != b.blocks || a.queries.size() != b.queries.size()) return false;
  for (std::size_t i = 0; i < a.queries.size(); ++i)
    if (a.queries[i].key != b.queries[i].key) return false;
  return true;
}

TEST(ShadowWork, IsTheSameForAnyNumberOfThreads) {
  Case one("balls:2");
  const ShadowWork work = one.record();
  EXPECT_EQ(work.blocks.size(), 4u * 3 + 1);
  EXPECT_GT(work.queries.size(), 50u * 40 * 2);  // a sample a pixel and light, and reflections
  EXPECT_TRUE(same_questions(work, one.record(3)));
}

class AnswerAll : public testing::TestWithParam<Method> {};
INSTANTIATE_TEST_SUITE_P(ByEveryMethod, AnswerAll,
                         testing::Values(Method::hard, Method::stochastic, Method::offset,
                                         Method::reduced, Method::umbra, Method::shaft));

TEST_P(AnswerAll, CostsExactlyWhatThePictureCosts) {
  for (const char* name : {"balls:2", "molecule"}) {
    Case one(name);
    const ShadowWork work = one.record();
    const ShadowScene shadows = prepare_shadows(one.scene, one.kernel, GetParam());
    const ShadowCounters picture = render(one.scene, shadows, one.options).counters.shadow;
    for (const std::size_t threads : {1u, 3u}) {
      std::vector<MethodWorker> workers(threads, MethodWorker(shadows, 9));
      const WorkDone done = answer_all(work, std::span(workers), {});
      EXPECT_GT(done.seconds, 0);
      EXPECT_EQ(done.counters.lit, picture.lit);
      EXPECT_EQ(done.counters.penumbra, picture.penumbra);
      EXPECT_EQ(done.counters.umbra, picture.umbra);
      EXPECT_EQ(done.counters.rays, picture.rays);
      EXPECT_EQ(done.counters.tests, picture.tests);
      EXPECT_EQ(done.counters.cache_decided, picture.cache_decided);
    }
  }
}

/// Mean difference of the visible fractions.
double difference(const std::vector<Visibility>& a, const std::vector<Visibility>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    sum += std::abs(double{a[i].fraction} - double{b[i].fraction});
  return sum / static_cast<double>(a.size());
}

TEST(ShadowWork, EmbreeAnswersTheSameInEveryVariant) {
  for (const char* name : {"balls:2", "rings", "molecule", "cylinders"}) {
    Case one(name);
    const EmbreeBaseline embree(one.scene.shapes);
    const ShadowWork work = one.record();
    std::vector<Visibility> ours(work.queries.size()), theirs(ours.size());
    for (const Method method : {Method::hard, Method::stochastic})
      for (const std::uint32_t d : {1u, 5u, 8u, 32u, 40u}) {
        const ShadowScene shadows = prepare_shadows(one.scene, one.kernel, method);
        std::vector<MethodWorker> workers(1, MethodWorker(shadows, d));
        const WorkDone by_us = answer_all(work, std::span(workers), ours);
        for (const EmbreeVariant variant : embree.variants()) {
          std::vector<EmbreeWorker> packets(2, EmbreeWorker(embree, variant, shadows, d));
          const WorkDone by_them = answer_all(work, std::span(packets), theirs);
          EXPECT_LT(difference(ours, theirs), 1e-4)
              << name << ", d = " << d << ", " << name_of(variant);
          EXPECT_EQ(by_them.counters.rays, by_us.counters.rays + by_us.counters.cache_decided);
        }
      }
  }
}

TEST(ShadowWork, PartOfItIsEverySoManyBlocks) {
  Case one("cylinders");
  const ShadowWork work = one.record(), part = part_of(work, 5), all = part_of(work, 1);
  EXPECT_TRUE(same_questions(work, all));
  EXPECT_EQ(part.blocks.size(), 3u + 1);
  const std::size_t fifth = work.batches[work.blocks[5]].first;
  EXPECT_EQ(part.queries[part.batches[part.blocks[1]].first].key, work.queries[fifth].key);
}

TEST(FindSample, LeadsFromAKeyToItsPixel) {
  Case one("cylinders");
  const std::uint64_t path = 5;
  const std::uint64_t pixel = hash(one.options.seed, std::uint64_t{31} << 32 | 7);
  const std::uint64_t key = light_key(hash(hash(pixel, 1), path), 2);
  const auto found = find_sample(one.options, path, 2, key);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->x, 7u);
  EXPECT_EQ(found->y, 31u);
  EXPECT_EQ(found->sample, 1u);
  EXPECT_FALSE(find_sample(one.options, path, 1, key));
}

}  // namespace
}  // namespace penumbra
