// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/light_spec.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "tests/scene_io/text_source.h"

namespace penumbra {
namespace {

Light parse(const std::string& text) { return parse_light(split_words(text)); }

std::string error_for(const std::string& text) {
  return error_of([&] { parse(text); });
}

TEST(LightSpec, knows_its_forms) {
  EXPECT_EQ(std::get<PointLight>(parse("point 1 2 3").shape).center, Vec3f(1, 2, 3));
  const Light ball = parse("sphere 1 2 3 0.5 4 5 6");
  EXPECT_EQ(std::get<BallLight>(ball.shape).radius, 0.5f);
  EXPECT_EQ(ball.intensity, Color(4, 5, 6));
  EXPECT_EQ(std::get<ParallelogramLight>(parse("rect 0 0 5 1 0 0 0 2 0").shape).v, Vec3f(0, 2, 0));
  const auto sun = std::get<SunLight>(parse("sun 0 0 10 0.53").shape);
  EXPECT_EQ(sun.direction, Vec3f(0, 0, 1));
  EXPECT_NEAR(sun.half_angle_rad, 0.265 * 3.14159265 / 180, 1e-9);
  EXPECT_EQ(parse("point 0 0 0").intensity, Color(1, 1, 1));
}

TEST(LightSpec, says_what_is_wrong) {
  EXPECT_TRUE(holds(error_for(""), "needs words"));
  EXPECT_TRUE(holds(error_for("laser 1 2 3"), "no light called `laser`"));
  for (const char* later : {"disk 0 0 0 0 0 1 1", "line 0 0 0 1 1 1", "polygon 3 0 0 0"})
    EXPECT_TRUE(holds(error_for(later), "does not know")) << later;
  EXPECT_TRUE(holds(error_for("sphere 1 2 3"), "sphere cx cy cz r [r g b]"));
  EXPECT_TRUE(holds(error_for("sphere 1 2 3 4 5"), "has 5"));
  EXPECT_TRUE(holds(error_for("sphere 1 2 3 0"), "above 0"));
  EXPECT_TRUE(holds(error_for("sphere 1 2 3 nan"), "`nan`"));
  EXPECT_TRUE(holds(error_for("sphere 1 2 1e999 1"), "`1e999`"));
  EXPECT_TRUE(holds(error_for("sphere 1 2 x 1"), "`x`"));
  EXPECT_TRUE(holds(error_for("rect 0 0 0 1 0 0 2 0 0"), "parallel"));
  EXPECT_TRUE(holds(error_for("sun 0 0 0 1"), "direction"));
  EXPECT_TRUE(holds(error_for("sun 0 0 1 180"), "[0, 180)"));
  EXPECT_TRUE(holds(error_for("sun 0 0 1 -1"), "[0, 180)"));
  EXPECT_TRUE(holds(error_for("point 0 0 0 1 -1 1"), "below 0"));
}

TEST(LightSpec, words_read_back_to_the_same_light) {
  for (int i = 1; i < 200; ++i) {
    const auto t = static_cast<float>(i);
    const Vec3f a(std::sin(t), std::cos(t) * 1e3f, t / 7), b(std::cos(t), t, 1 / t);
    for (const LightShape& shape : {LightShape(PointLight{a}), LightShape(BallLight{a, t / 3}),
                                    LightShape(ParallelogramLight{a, b, cross(a, b)}),
                                    LightShape(SunLight{normalize(b), t / 130})}) {
      const Light light{shape, {t / 9, 1, 0.1f}, Falloff::none};
      const Light back = parse(light_words(light));
      EXPECT_EQ(light_words(back), light_words(light));
      EXPECT_EQ(back.intensity, light.intensity);
      if (const auto* sun = std::get_if<SunLight>(&shape)) {
        EXPECT_EQ(std::get<SunLight>(back.shape).half_angle_rad, sun->half_angle_rad);
        EXPECT_EQ(std::get<SunLight>(back.shape).direction, sun->direction);
      }
    }
  }
}

}  // namespace
}  // namespace penumbra
