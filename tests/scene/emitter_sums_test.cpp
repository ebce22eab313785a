// SPDX-License-Identifier: MIT
// The lights of glowing surfaces against the surfaces themselves: power, place, and what they give
// to receivers all around.
#include "tests/scene/emitter_sums.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/scene/emitter_meshes.h"

namespace penumbra {
namespace {

/// What lights may be off: the irradiance of one receiver and of all, over the mean; how far the
/// surface sticks out of the lights.
struct Bounds {
  double most = 0, mean = 0, uncovered = 0;
};

/// `sides`: how many count of each triangle.
void expect_like(const char* name, Scene scene, Bounds bounds, double sides = 1) {
  const EmitterReport report = add_emitter_lights(scene);
  EXPECT_NEAR(power_of_lights(scene.lights), sides * power_of_triangles(scene),
              1e-5 * sides * power_of_triangles(scene))
      << name;
  const SumErrors errors = errors_of(scene);
  EXPECT_LE(errors.most, bounds.most) << name << ", lights " << report.lights;
  EXPECT_LE(errors.mean, bounds.mean) << name << ", lights " << report.lights;
  EXPECT_LE(uncovered(scene), bounds.uncovered) << name;
}

Mesh turned(Mesh mesh) {
  const Transform any{{0.36, 0.48, -0.8}, {-0.8, 0.6, 0}, {0.48, 0.64, 0.6}, {3, -2, 5}};
  return transformed(std::move(mesh), any);
}

TEST(EmitterSums, flat_surfaces_are_their_polygons) {
  constexpr Bounds exact{1e-4, 1e-5, 1e-5};
  for (const bool is_two_sided : {false, true}) {
    const auto expect_exact = [&](const char* name, const Mesh& mesh) {
      expect_like(name, glowing(turned(mesh), {1, 2, 3}, is_two_sided), exact,
                  is_two_sided ? 2 : 1);
    };
    expect_exact("rectangle", rectangle(0, 0, 3, 1));
    expect_exact("polygon", regular_polygon(7));
    expect_exact("L", letter_l());
    expect_exact("E", letter_e());
    expect_exact("frame", flat_ring(4, 1, 1.2f));
    expect_exact("grid", grid(30, 20, Closing::none,
                              [](double u, double v) { return Vec3d(u * u, v + 0.1 * u * u, 0); }));
  }
}

TEST(EmitterSums, flat_surfaces_with_round_outlines_are_near_it) {
  expect_like("disk", glowing(turned(regular_polygon(16))), {1e-3, 1e-4, 0.006});
  expect_like("fine disk", glowing(turned(regular_polygon(100))), {1e-4, 1e-5, 2e-4});
  Mesh ellipse = regular_polygon(100);
  for (Vec3f& p : ellipse.positions) p.x *= 3;
  expect_like("ellipse", glowing(turned(ellipse)), {0.03, 2e-3, 0.01});
  expect_like("ring", glowing(turned(flat_ring(64, 1, 1.5f))), {0.1, 0.01, 2e-3});
}

TEST(EmitterSums, convex_bodies_are_their_hulls) {
  constexpr Bounds exact{1e-4, 1e-5, 1e-5};
  expect_like("box", glowing(turned(box_mesh(1, 2, 3))), exact);
  expect_like("pillar", glowing(turned(prism(regular_polygon(12), 5))), exact);
  expect_like("coarse ball", glowing(turned(ball_mesh(8, 4))), exact);
}

TEST(EmitterSums, round_bodies_are_near_it) {
  expect_like("ball", glowing(turned(ball_mesh(32, 16))), {0.01, 1e-3, 1e-4});
  expect_like("fine ball", glowing(turned(ball_mesh(64, 48))), {2e-3, 3e-4, 1e-4});
  Mesh ellipsoid = ball_mesh(32, 16);
  for (Vec3f& p : ellipsoid.positions) p.z *= 2;
  expect_like("ellipsoid", glowing(turned(ellipsoid)), {0.1, 0.02, 0.03});
}

TEST(EmitterSums, tubes_shine_from_their_ends_too) {
  expect_like("tube", glowing(turned(open_cylinder(16, 1, 40))), {0.4, 0.05, 0.01});
  expect_like("wide tube", glowing(turned(open_cylinder(16, 1, 8))), {1.5, 0.2, 0.01});
}

TEST(EmitterSums, dented_bodies_are_cut) {
  expect_like("L", glowing(turned(prism(letter_l(), 1))), {0.4, 0.07, 1e-3});
  expect_like("E", glowing(turned(prism(letter_e(), 0.5f))), {0.3, 0.07, 1e-3});
  expect_like("torus", glowing(turned(torus_mesh(48, 12, 4, 0.4))), {0.2, 0.04, 0.02});
  expect_like("fat torus", glowing(turned(torus_mesh(32, 16, 2, 1))), {0.6, 0.15, 0.03});
}

TEST(EmitterSums, hollow_surfaces_that_shine_from_outside_are_cut) {
  expect_like("dome", glowing(turned(ball_mesh(32, 8, 1, 0.5))), {1, 0.12, 0.03});
}

TEST(EmitterSums, a_hollow_surface_that_shines_from_both_sides_looks_like_its_hull) {
  // Each direction in which rays meet the hull they meet the bowl, too: radiance is the same.
  Scene scene = glowing(ball_mesh(32, 8, 1, 0.5), {1, 2, 3}, true);
  add_emitter_lights(scene);
  ASSERT_EQ(scene.lights.size(), 1u);
  EXPECT_NEAR(power_of_lights(scene.lights), 2 * 3 * pi, 0.02 * 2 * 3 * pi);
  // From above, its disk.
  const Receiver far{{0, 0, 100}, {0, 0, -1}};
  EXPECT_NEAR(irradiance_of_lights(scene.lights, far) * 1e4, 2 * pi, 0.2 * 2 * pi);
}

TEST(EmitterSums, many_small_lights_are_joined) {
  Mesh strip;
  for (int i = 0; i < 300; ++i)
    append(strip, rectangle(0.05f * static_cast<float>(i), 0, 0.02f, 0.02f));
  expect_like("strip", glowing(turned(strip)), {2e-3, 1e-4, 1e-4});
  std::mt19937 random(4);
  std::uniform_real_distribution<float> unit(0, 1);
  Mesh cloud;
  for (int i = 0; i < 500; ++i)
    append(cloud, moved(rectangle(0, 0, 0.05f, 0.05f),
                        {4 * unit(random), 4 * unit(random), unit(random)}));
  expect_like("cloud", glowing(turned(cloud)), {0.5, 0.1, 0.06});
}

}  // namespace
}  // namespace penumbra
