// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/light_spec.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <random>

#include "penumbra/scene/check_light.h"
#include "penumbra/scene_io/numbers.h"
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

TEST(LightSpec, knows_beams) {
  const Light spot = parse("point 1 2 3 0.5 0.5 0.5 beam 0 0 -2 30 60");
  EXPECT_EQ(spot.intensity, Color(0.5f, 0.5f, 0.5f));
  ASSERT_TRUE(spot.beam);
  EXPECT_EQ(spot.beam->axis, Vec3f(0, 0, -1));
  EXPECT_FLOAT_EQ(spot.beam->cos_full, std::sqrt(0.75f));
  EXPECT_FLOAT_EQ(spot.beam->cos_none, 0.5f);
  EXPECT_EQ(light_words(spot), "point 1 2 3 0.5 0.5 0.5 beam 0 0 -1 30 60");
  // A right angle is exactly one.
  EXPECT_EQ(parse("disk 0 0 5 0 0 -1 1 beam 0 0 -1 90 90").beam->cos_none, 0);
  EXPECT_TRUE(holds(error_for("point 0 0 0 beam 0 0 1 30"), "takes 5 numbers, but has 4"));
  EXPECT_TRUE(holds(error_for("point 0 0 0 beam 0 0 0 30 40"), "beam without direction"));
  EXPECT_TRUE(holds(error_for("point 0 0 0 beam 0 0 1 40 30"), "out of order"));
  EXPECT_TRUE(holds(error_for("point 0 0 0 beam 0 0 1 x 30"), "`x` of a beam"));
  EXPECT_TRUE(holds(error_for("sun 0 0 1 5 beam 0 0 1 20 30"), "a sun with a beam"));
}

TEST(LightSpec, knows_disks_lines_polygons_and_meshes) {
  const auto disk = std::get<DiskLight>(parse("disk 1 2 3 0 0 -7 0.5").shape);
  EXPECT_EQ(disk.center, Vec3f(1, 2, 3));
  EXPECT_EQ(disk.normal, Vec3f(0, 0, -1));
  EXPECT_EQ(disk.radius, 0.5f);
  const auto line = std::get<LineLight>(parse("line 1 2 3 3 2 4 1 1 0").shape);
  EXPECT_EQ(line.center, Vec3f(2, 2, 3.5f));
  EXPECT_EQ(line.half, Vec3f(1, 0, 0.5f));
  const Light polygon = parse("polygon 4 0 0 1  3 0 1  3 3 1  0 3 1  0.5 0.25 1");
  EXPECT_EQ(std::get<PolygonLight>(polygon.shape).center, Vec3f(1.5f, 1.5f, 1));
  EXPECT_EQ(std::get<PolygonLight>(polygon.shape).corners.size(), 4u);
  EXPECT_EQ(polygon.intensity, Color(0.5f, 0.25f, 1));
  // A cube with a point inside and one in a face.
  const auto mesh = std::get<MeshLight>(
      parse("mesh 10 0 0 0 1 0 0 0 1 0 1 1 0 0.5 0.25 0.5 0 0 1 1 0 1 0 1 1 1 1 1 0.5 0.5 0")
          .shape);
  EXPECT_EQ(mesh.corners.size(), 8u);
  EXPECT_EQ(mesh.triangles.size(), 12u);
  EXPECT_EQ(mesh.center, Vec3f(0.5f, 0.5f, 0.5f));
}

TEST(LightSpec, says_what_is_wrong_with_shapes) {
  EXPECT_TRUE(holds(error_for("disk 0 0 0 0 0 0 1"), "no normal"));
  EXPECT_TRUE(holds(error_for("disk 0 0 0 0 0 1 0"), "radius"));
  EXPECT_TRUE(holds(error_for("disk 0 0 0 0 0 1"), "disk cx cy cz nx ny nz r [r g b]"));
  EXPECT_TRUE(holds(error_for("line 1 2 3 1 2 3"), "no length"));
  EXPECT_TRUE(holds(error_for("line 1 2 3 1 2 1e20"), "1e15"));
  EXPECT_TRUE(holds(error_for("polygon"), "how many points"));
  EXPECT_TRUE(holds(error_for("polygon 3.5 0 0 0"), "how many points"));
  EXPECT_TRUE(holds(error_for("polygon -3 0 0 0"), "how many points"));
  EXPECT_TRUE(holds(error_for("polygon 99999999999999 0 0 0"), "how many points"));
  EXPECT_TRUE(holds(error_for("polygon 3 0 0 0 1 0 0"), "takes 10 numbers"));
  EXPECT_TRUE(holds(error_for("polygon 2 0 0 0 1 0 0"), "fewer than 3"));
  EXPECT_TRUE(holds(error_for("polygon 3 0 0 0 1 0 0 2 0 0"), "no area"));
  EXPECT_TRUE(holds(error_for("polygon 3 0 0 0 0 0 0 0 0 0"), "no area"));
  EXPECT_TRUE(holds(error_for("polygon 4 0 0 0 1 0 0 1 1 0.1 0 1 0"), "not planar"));
  EXPECT_TRUE(holds(error_for("polygon 4 0 0 0 1 0 0 0.2 0.2 0 0 1 0"), "not convex"));
  EXPECT_TRUE(holds(error_for("polygon 4 0 0 0 1 1 0 1 0 0 0 1 0"), "light"));
  EXPECT_TRUE(holds(error_for("polygon 5 1 0 0 -0.8 0.6 0 0.3 -0.95 0 0.3 0.95 0 -0.8 -0.6 0"),
                    "not convex"));
  EXPECT_TRUE(holds(error_for("mesh 3 0 0 0 1 0 0 0 1 0"), "no volume"));
  EXPECT_TRUE(holds(error_for("mesh 5 0 0 0 1 0 0 0 1 0 1 1 0 0.3 0.3 0"), "no volume"));
  EXPECT_TRUE(holds(error_for("mesh 4 0 0 0 1 0 0 0 1 0 0 0 nan"), "`nan`"));
  EXPECT_TRUE(holds(error_for("mesh 4 0 0 0 0 0 0 0 0 0 0 0 0"), "no volume"));
}

TEST(LightSpec, polygons_may_be_bent_by_rounding_and_have_corners_in_a_row) {
  EXPECT_EQ(parse("polygon 5 0 0 1 1 0 1 2 0 1 2 2 1 0 2 1").shape.index(),
            LightShape(PolygonLight{}).index());
  for (int corners = 3; corners < 40; ++corners) {
    std::string words = "polygon " + std::to_string(corners);
    for (int i = 0; i < corners; ++i) {
      const double t = 2 * 3.14159265358979 * i / corners;
      const Vec3f corner(Vec3d(1e3, -2e3, 3) + Vec3d(0.6, 0.3, 0.1) * std::cos(t) +
                         Vec3d(-0.3, 0.5, 0.3) * std::sin(t));
      for (int axis = 0; axis < 3; ++axis) words.append(" ").append(to_text(corner[axis]));
    }
    EXPECT_NO_THROW(parse(words)) << words;
  }
}

TEST(LightSpec, meshes_are_hulls_and_read_back_to_the_same_bits) {
  for (unsigned seed = 1; seed < 60; ++seed) {
    std::mt19937 random(seed);
    std::normal_distribution<float> normal;
    std::uniform_int_distribution<int> grid(0, 2);
    std::string words = "mesh 40";
    // Every other one with many points in the planes of its facets.
    for (int i = 0; i < 120; ++i)
      words.append(" ").append(to_text(seed % 2 ? normal(random) : grid(random) + 0.1f));
    const Light light = parse(words);
    const auto mesh = std::get<MeshLight>(light.shape);
    const auto back = std::get<MeshLight>(parse(light_words(light)).shape);
    EXPECT_EQ(back.corners, mesh.corners);
    EXPECT_EQ(back.triangles, mesh.triangles);
    EXPECT_EQ(back.center, mesh.center);
    // Euler: a closed surface of triangles.
    EXPECT_EQ(mesh.triangles.size(), 2 * mesh.corners.size() - 4);
    EXPECT_FALSE(problem_of(mesh));
    const std::vector<std::string> given = split_words(words);
    for (int i = 0; i < 40; ++i) {
      const auto number = [&](int axis) { return *parse_float(given[2 + 3 * i + axis]); };
      EXPECT_TRUE(contains(mesh, {number(0), number(1), number(2)}));
    }
  }
}

TEST(LightSpec, words_read_back_to_the_same_light) {
  for (int i = 1; i < 200; ++i) {
    const auto t = static_cast<float>(i);
    const Vec3f a(std::sin(t), std::cos(t) * 1e3f, t / 7), b(std::cos(t), t, 1 / t);
    for (const LightShape& shape :
         {LightShape(PointLight{a}), LightShape(BallLight{a, t / 3}),
          LightShape(ParallelogramLight{a, b, cross(a, b)}),
          LightShape(DiskLight{a, normalize(b), t / 3}), LightShape(LineLight{a, b}),
          LightShape(SunLight{normalize(b), t / 130})}) {
      const Light light{shape, {t / 9, 1, 0.1f}, Falloff::none};
      const Light back = parse(light_words(light));
      EXPECT_EQ(light_words(back), light_words(light));
      EXPECT_EQ(back.intensity, light.intensity);
      if (const auto* sun = std::get_if<SunLight>(&shape)) {
        EXPECT_EQ(std::get<SunLight>(back.shape).half_angle_rad, sun->half_angle_rad);
        EXPECT_EQ(std::get<SunLight>(back.shape).direction, sun->direction);
      }
      if (const auto* disk = std::get_if<DiskLight>(&shape)) {
        EXPECT_EQ(std::get<DiskLight>(back.shape).normal, disk->normal);
      }
      if (const auto* line = std::get_if<LineLight>(&shape)) {
        EXPECT_EQ(std::get<LineLight>(back.shape).center, line->center);
        EXPECT_EQ(std::get<LineLight>(back.shape).half, line->half);
      }
    }
  }
}

}  // namespace
}  // namespace penumbra
