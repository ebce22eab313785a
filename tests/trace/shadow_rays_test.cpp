// SPDX-License-Identifier: MIT
// What the proofs save: shadow rays traced by each method, at the paper's settings.
#include <gtest/gtest.h>

#include <ostream>
#include <string>

#include "penumbra/scene/complete_scene.h"
#include "penumbra/scene/gallery.h"
#include "penumbra/shadow/classify.h"
#include "penumbra/trace/prepare.h"
#include "penumbra/trace/render.h"

namespace penumbra {
namespace {

/// The paper's Table 2, as `umbra` over plain stochastic tracing: 3.58, 6.56, 6.78, 3.94, 3.67.
struct Expectation {
  const char* scene;
  LightRadius radius;
  double umbra, shaft;  ///< at least so many times fewer rays
};

std::ostream& operator<<(std::ostream& out, const Expectation& e) { return out << e.scene; }

class ShadowRays : public testing::TestWithParam<Expectation> {};

INSTANTIATE_TEST_SUITE_P(OfTheBuiltInScenes, ShadowRays,
                         testing::Values(Expectation{"cylinders", {0.1, false}, 3.5, 20},
                                         Expectation{"balls:4", {1.0 / 162, false}, 6.5, 80},
                                         Expectation{"rings", {0.05, false}, 5, 15},
                                         Expectation{"molecule", {1, true}, 3.6, 30},
                                         Expectation{"bust", {1, true}, 3.6, 10}),
                         [](const auto& test) {
                           std::string name = test.param.scene;
                           std::erase(name, ':');
                           return name;
                         });

TEST_P(ShadowRays, AreFewerTheMoreIsProven) {
  SceneOptions with_radius;
  with_radius.light_radius = GetParam().radius;
  const Scene scene = complete_scene(*gallery_scene(GetParam().scene), with_radius);
  const Kernel kernel(scene.shapes, kernel_options(scene));
  RenderOptions options;
  options.width = options.height = 128;
  const auto rays = [&](Method method) {
    const ShadowScene shadows = prepare_shadows(scene, kernel, method);
    EXPECT_LE(shadows.memory_bytes(), kernel.memory_bytes());  // both: at most twice
    return static_cast<double>(render(scene, shadows, options).counters.shadow.rays);
  };
  const double stochastic = rays(Method::stochastic), offset = rays(Method::offset);
  const double reduced = rays(Method::reduced), umbra = rays(Method::umbra);
  EXPECT_GT(stochastic, offset);
  EXPECT_GE(offset, reduced);
  EXPECT_GE(reduced, umbra);
  EXPECT_GE(stochastic / umbra, GetParam().umbra);
  EXPECT_GE(stochastic / rays(Method::shaft), GetParam().shaft);
}

/// A large light over a fine mesh has thousands of candidates a point.
TEST(ShadowProofs, CostNoMoreThanTheirBudget) {
  SceneOptions with_radius;
  with_radius.light_radius = LightRadius{50, true};
  const Scene scene = complete_scene(*gallery_scene("bust"), with_radius);
  const Kernel kernel(scene.shapes, kernel_options(scene));
  RenderOptions options;
  options.width = options.height = 64;
  options.shadow_samples = 8;
  for (const Method method : {Method::offset, Method::reduced, Method::umbra}) {
    const ShadowCounters spent =
        render(scene, prepare_shadows(scene, kernel, method), options).counters.shadow;
    EXPECT_LE(spent.set_tests, spent.set_rays * (proof_budget(8).tests + 1));
  }
}

}  // namespace
}  // namespace penumbra
