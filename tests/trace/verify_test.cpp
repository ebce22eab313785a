// SPDX-License-Identifier: MIT
#include "penumbra/trace/verify.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "penumbra/scene/complete_scene.h"
#include "penumbra/scene/gallery.h"
#include "penumbra/trace/prepare.h"

namespace penumbra {
namespace {

/// A small picture of mirroring balls, and answers drawn from it.
struct Case {
  Case()
      : scene(complete_scene(*gallery_scene("balls:1"), {})),
        kernel(scene.shapes, kernel_options(scene)),
        brute(scene.shapes, {KernelKind::brute, {}}),
        judge(prepare_shadows(scene, brute, Method::stochastic)) {
    options.width = options.height = 40;
    options.shadow_samples = 8;
  }

  std::vector<GivenAnswer> draw(Method method, std::size_t count, std::uint32_t threads = 1) {
    AnswerDraw drawn(count, options.seed);
    options.threads = threads;
    options.observe = [&](const AnsweredBatch& batch) { drawn.add(batch); };
    render(scene, prepare_shadows(scene, kernel, method), options);
    options.observe = nullptr;
    return drawn.answers();
  }

  Scene scene;
  Kernel kernel, brute;
  ShadowScene judge;
  RenderOptions options;
};

class Verify : public testing::TestWithParam<Method> {};
INSTANTIATE_TEST_SUITE_P(EveryMethod, Verify,
                         testing::Values(Method::stochastic, Method::offset, Method::reduced,
                                         Method::umbra, Method::shaft));

TEST_P(Verify, FindsNothingWrong) {
  Case one;
  const std::vector<GivenAnswer> answers = one.draw(GetParam(), 500);
  EXPECT_EQ(answers.size(), 500u);
  EXPECT_FALSE(find_wrong_answer(one.judge, 8, answers));
}

TEST(Verify, FindsAndNamesTheFirstWrongAnswer) {
  Case one;
  std::vector<GivenAnswer> answers = one.draw(Method::umbra, 500);
  const auto is_wanted = [](const GivenAnswer& given) {
    return given.path == 2 && given.seen.shadow_class == ShadowClass::penumbra &&
           given.seen.fraction > 0;
  };
  const auto at = std::find_if(answers.begin(), answers.end(), is_wanted);
  ASSERT_NE(at, answers.end());
  at->seen = {0, 0, ShadowClass::umbra, 0};
  answers.back().seen.fraction = 2;
  const auto wrong = find_wrong_answer(one.judge, 8, answers);
  ASSERT_TRUE(wrong);
  EXPECT_EQ(wrong->given.query.key, at->query.key);
  EXPECT_GT(wrong->expected.fraction, 0);
  EXPECT_FALSE(is_same_answer(wrong->given.seen, wrong->expected));
  const std::string text = to_text(*wrong, one.options);
  for (const char* part : {"pixel ", "sample 0, camera ray > reflected, light ",
                           ": umbra, V = 0, fraction = 0; expected "})
    EXPECT_NE(text.find(part), text.npos) << text;
  EXPECT_EQ(text.find("pixel 0,0,"), text.npos) << text;  // the key was found
}

TEST(Verify, DrawsTheSameForAnyNumberOfThreads) {
  Case one;
  const auto first = one.draw(Method::shaft, 100), again = one.draw(Method::shaft, 100, 3);
  ASSERT_EQ(first.size(), again.size());
  for (std::size_t i = 0; i < first.size(); ++i) EXPECT_EQ(first[i].query.key, again[i].query.key);
  one.options.seed = 1;
  EXPECT_NE(one.draw(Method::shaft, 100).front().query.key, first.front().query.key);
}

TEST(Verify, DrawsAllWhenThereAreNoMore) {
  Case one;
  std::size_t asked = 0;
  one.draw(Method::shaft, 0);
  one.options.observe = [&](const AnsweredBatch& batch) { asked += batch.queries.size(); };
  render(one.scene, prepare_shadows(one.scene, one.kernel, Method::hard), one.options);
  EXPECT_EQ(one.draw(Method::shaft, 1'000'000).size(), asked);
  EXPECT_TRUE(one.draw(Method::shaft, 0).empty());
}

TEST(Verify, SignsOfZeroAndNanAreBits) {
  const Visibility zero{0, 0, ShadowClass::umbra, 0}, minus{-0.0f, 0, ShadowClass::umbra, 0};
  EXPECT_FALSE(is_same_answer(zero, minus));
  EXPECT_TRUE(is_same_answer(zero, {0, 0, ShadowClass::penumbra, 7}));
}

}  // namespace
}  // namespace penumbra
