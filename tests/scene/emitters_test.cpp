// SPDX-License-Identifier: MIT
#include "penumbra/scene/emitters.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

#include "penumbra/scene/check_light.h"
#include "penumbra/scene/glowing_surface.h"
#include "tests/scene/emitter_meshes.h"
#include "tests/scene/emitter_sums.h"

namespace penumbra {
namespace {

/// Squares in a row, each of edge 1 with a gap.
Mesh squares(int count) {
  Mesh mesh;
  for (int i = 0; i < count; ++i) append(mesh, rectangle(2 * static_cast<float>(i), 0, 1, 1));
  return mesh;
}

template <typename Shape>
std::size_t count_of(const Scene& scene) {
  return static_cast<std::size_t>(
      std::count_if(scene.lights.begin(), scene.lights.end(),
                    [](const Light& light) { return std::holds_alternative<Shape>(light.shape); }));
}

TEST(Emitters, a_square_becomes_a_light_of_its_radiance) {
  Scene scene = glowing(squares(1), {1, 2, 3}, true);
  EXPECT_EQ(add_emitter_lights(scene).lights, 1u);
  ASSERT_EQ(scene.lights.size(), 1u);
  const auto& shape = std::get<ParallelogramLight>(scene.lights[0].shape);
  EXPECT_EQ(shape.center, (Vec3f{0.5f, 0.5f, 0}));
  EXPECT_FLOAT_EQ(4 * length(cross(shape.u, shape.v)), 1);
  EXPECT_EQ(scene.lights[0].intensity, (Color{1, 2, 3}));
  EXPECT_EQ(scene.lights[0].falloff, Falloff::inverse_square);
  EXPECT_FALSE(scene.lights[0].beam);
  const Mesh& mesh = scene.shapes.meshes[0];
  EXPECT_FALSE(scene.materials[surface_of(mesh, 0)].casts_shadow);
  EXPECT_FALSE(scene.materials[surface_of(mesh, 1)].casts_shadow);
}

TEST(Emitters, one_side_is_the_front) {
  Scene scene = glowing(squares(1));
  add_emitter_lights(scene);
  ASSERT_TRUE(scene.lights[0].beam);
  EXPECT_EQ(scene.lights[0].beam->axis, (Vec3f{0, 0, 1}));
  EXPECT_EQ(scene.lights[0].beam->cos_full, 0);
  EXPECT_EQ(scene.lights[0].beam->cos_none, 0);
  EXPECT_EQ(scene.lights[0].intensity, (Color{1, 2, 3}));

  Mesh turned = squares(1);
  for (Triangle& t : turned.triangles) std::swap(t[1], t[2]);
  scene = glowing(turned);
  add_emitter_lights(scene);
  EXPECT_EQ(scene.lights[0].beam->axis, (Vec3f{0, 0, -1}));
}

TEST(Emitters, a_face_and_its_back_are_two_sides) {
  Mesh both = squares(1), back = squares(1);
  for (Triangle& t : back.triangles) std::swap(t[1], t[2]);
  append(both, back);
  Scene one_sided = glowing(both), two_sided = glowing(both, {1, 2, 3}, true);
  for (Scene* scene : {&one_sided, &two_sided}) {
    add_emitter_lights(*scene);
    ASSERT_EQ(scene->lights.size(), 1u);
    EXPECT_FALSE(scene->lights[0].beam);
    EXPECT_EQ(scene->lights[0].intensity, (Color{1, 2, 3}));
  }
}

TEST(Emitters, flat_forms_become_few_polygons) {
  const auto lights = [](const Mesh& mesh) {
    Scene scene = glowing(mesh);
    return add_emitter_lights(scene).lights;
  };
  EXPECT_EQ(lights(regular_polygon(5)), 1u);
  EXPECT_EQ(lights(grid(50, 50, Closing::none, [](double u, double v) { return Vec3d(u, 0, v); })),
            1u);
  EXPECT_EQ(lights(letter_l()), 2u);
  EXPECT_EQ(lights(letter_e()), 4u);
  EXPECT_EQ(lights(flat_ring(4, 1, 2)), 4u);
  EXPECT_EQ(lights(flat_ring(64, 1, 2)), 8u);
}

TEST(Emitters, regular_polygons_of_many_corners_are_disks) {
  Scene disk = glowing(regular_polygon(32, 2));
  add_emitter_lights(disk);
  const auto& shape = std::get<DiskLight>(disk.lights.at(0).shape);
  EXPECT_NEAR(shape.radius, 2, 0.02f);
  // Others keep the 16 corners that matter most.
  Mesh ellipse = regular_polygon(64);
  for (Vec3f& p : ellipse.positions) p.x *= 3;
  Scene scene = glowing(ellipse);
  add_emitter_lights(scene);
  EXPECT_EQ(std::get<PolygonLight>(scene.lights.at(0).shape).corners.size(), 16u);
}

TEST(Emitters, fine_balls_are_balls_and_coarse_ones_hulls) {
  Scene fine = glowing(moved(ball_mesh(32, 16, 2), {1, 2, 3}));
  add_emitter_lights(fine);
  const auto& ball = std::get<BallLight>(fine.lights.at(0).shape);
  EXPECT_FLOAT_EQ(ball.radius, 2);
  EXPECT_LT(length(ball.center - Vec3f{1, 2, 3}), 1e-5f);
  Scene coarse = glowing(ball_mesh(6, 4)), box = glowing(box_mesh(1, 2, 3));
  add_emitter_lights(coarse), add_emitter_lights(box);
  EXPECT_EQ(std::get<MeshLight>(coarse.lights.at(0).shape).corners.size(), 20u);
  EXPECT_EQ(std::get<MeshLight>(box.lights.at(0).shape).corners.size(), 8u);
}

TEST(Emitters, thin_slabs_are_two_sides_of_a_plane) {
  Scene scene = glowing(box_mesh(1, 1, 0.0002f));
  add_emitter_lights(scene);
  ASSERT_EQ(count_of<ParallelogramLight>(scene), 1u);
  EXPECT_FALSE(scene.lights[0].beam);
  EXPECT_NEAR(scene.lights[0].intensity.x, 1, 1e-3f);
}

TEST(Emitters, only_what_glows_stops_casting_shadows) {
  Scene scene = glowing(squares(2));
  scene.materials.emplace_back();
  scene.shapes.meshes[0].surfaces = {0, 0, 1, 1};
  EXPECT_EQ(add_emitter_lights(scene).lights, 1u);
  const Mesh& mesh = scene.shapes.meshes[0];
  EXPECT_FALSE(scene.materials[surface_of(mesh, 1)].casts_shadow);
  EXPECT_TRUE(scene.materials[surface_of(mesh, 2)].casts_shadow);
  // Others may share the material: spheres get their lights from readers.
  EXPECT_TRUE(scene.materials[0].casts_shadow);
  EXPECT_EQ(scene.materials.size(), 3u);
}

TEST(Emitters, materials_and_meshes_are_told_apart_by_how_they_glow) {
  Scene scene = glowing(squares(1));
  scene.materials.push_back(scene.materials[0]);
  scene.materials[1].emission = {9, 9, 9};
  // A second half of the square, in a mesh of its own, of another glow and then of the same.
  Mesh half = scene.shapes.meshes[0];
  half.triangles = {half.triangles[1]};
  scene.shapes.meshes[0].triangles.pop_back();
  half.surface = 1;
  scene.shapes.meshes.push_back(half);
  Scene same = scene;
  EXPECT_EQ(add_emitter_lights(scene).lights, 2u);
  same.materials[1].emission = same.materials[0].emission;
  EXPECT_EQ(add_emitter_lights(same).lights, 1u);
}

TEST(Emitters, dark_scenes_stay_as_they_are) {
  Scene scene = glowing(squares(1), {0, 0, 0});
  const EmitterReport report = add_emitter_lights(scene);
  EXPECT_EQ(report.surfaces, 0u);
  EXPECT_TRUE(scene.lights.empty());
  EXPECT_EQ(scene.materials.size(), 1u);
}

TEST(Emitters, do_not_depend_on_the_order_of_triangles) {
  std::mt19937 random(5);
  Mesh mesh = torus_mesh(16, 8, 3, 1);
  append(mesh, moved(letter_e(), {5, 0, 0}));
  append(mesh, moved(squares(40), {0, 9, 0}));
  Scene scene = glowing(mesh);
  add_emitter_lights(scene);
  for (int i = 0; i < 3; ++i) {
    std::shuffle(mesh.triangles.begin(), mesh.triangles.end(), random);
    for (Triangle& t : mesh.triangles)
      std::rotate(t.begin(), t.begin() + static_cast<std::ptrdiff_t>(random() % 3), t.end());
    Scene again = glowing(mesh);
    add_emitter_lights(again);
    ASSERT_EQ(again.lights.size(), scene.lights.size());
    for (std::size_t k = 0; k < scene.lights.size(); ++k) {
      EXPECT_EQ(center(again.lights[k].shape), center(scene.lights[k].shape));
      EXPECT_EQ(again.lights[k].intensity, scene.lights[k].intensity);
      EXPECT_EQ(corners(again.lights[k].shape), corners(scene.lights[k].shape));
    }
  }
}

TEST(Emitters, dirt_changes_nothing) {
  const Mesh clean = letter_l();
  Mesh dirty = clean;
  dirty.triangles.insert(dirty.triangles.end(), clean.triangles.begin(), clean.triangles.end());
  dirty.triangles.push_back({0, 0, 1});
  dirty.triangles.push_back({0, 1, 99});
  dirty.positions.emplace_back(std::numeric_limits<float>::quiet_NaN(), 0.0f, 0.0f);
  dirty.triangles.push_back({0, 1, static_cast<std::uint32_t>(dirty.positions.size()) - 1});
  dirty.positions.emplace_back(std::numeric_limits<float>::infinity(), 0.0f, 0.0f);
  dirty.triangles.push_back({0, 1, static_cast<std::uint32_t>(dirty.positions.size()) - 1});
  Scene a = glowing(clean), b = glowing(dirty);
  add_emitter_lights(a), add_emitter_lights(b);
  ASSERT_EQ(a.lights.size(), b.lights.size());
  for (std::size_t i = 0; i < a.lights.size(); ++i) {
    EXPECT_EQ(a.lights[i].intensity, b.lights[i].intensity);
    EXPECT_EQ(corners(a.lights[i].shape), corners(b.lights[i].shape));
  }
  Scene broken = glowing(clean);
  broken.shapes.meshes[0].surface = 77;
  EXPECT_EQ(add_emitter_lights(broken).lights, 0u);
  broken.shapes.meshes[0].surfaces = {0};  // too few
  EXPECT_EQ(add_emitter_lights(broken).surfaces, 1u);
  for (const Color none : {Color{std::numeric_limits<float>::infinity(), 0, 0}, Color{-1, 0, 1}}) {
    for (Material& material : broken.materials) material.emission = none;
    EXPECT_EQ(add_emitter_lights(broken).surfaces, 0u);
  }
}

TEST(Emitters, many_faces_with_their_backs_are_there_once) {
  Mesh doubled = squares(200);
  const std::size_t count = doubled.triangles.size();
  for (std::size_t t = 0; t < count; ++t) {
    const Triangle front = doubled.triangles[t];
    doubled.triangles.push_back({front[0], front[2], front[1]});
  }
  std::size_t found = 0;
  for (const GlowingSurface& surface : glowing_surfaces(glowing(doubled, {1, 2, 3}, true)))
    found += surface.triangles.size();
  EXPECT_EQ(found, count);
}

TEST(Emitters, are_lights_that_methods_take) {
  std::mt19937 random(9);
  std::normal_distribution<float> normal;
  for (int trial = 0; trial < 60; ++trial) {
    // Soups of a few triangles, squeezed to planes and lines, far from the origin, tiny and huge.
    const float scale = std::pow(10.0f, 3 * normal(random)), shift = trial % 3 == 0 ? 100 : 0;
    const float flat = trial % 2 == 0 ? 1 : std::pow(10.0f, -3 * std::abs(normal(random)));
    const float thin = trial % 5 == 0 ? 1e-6f : 1;
    Mesh mesh;
    for (int i = 0; i < 3 + trial % 30; ++i)
      mesh.positions.emplace_back(scale * (normal(random) + shift), scale * thin * normal(random),
                                  scale * flat * normal(random));
    const auto n = static_cast<std::uint32_t>(mesh.positions.size());
    for (std::uint32_t i = 0; i < 2 * n; ++i)
      mesh.triangles.push_back({static_cast<std::uint32_t>(random() % n),
                                static_cast<std::uint32_t>(random() % n),
                                static_cast<std::uint32_t>(random() % n)});
    Scene scene = glowing(mesh, {1, 2, 3}, trial % 4 == 0);
    const EmitterReport report = add_emitter_lights(scene);
    EXPECT_LE(scene.lights.size(), 32u);
    for (const Light& light : scene.lights) {
      const auto problem = problem_of(light.shape);
      EXPECT_FALSE(problem) << trial << ": " << problem->what;
      EXPECT_TRUE(is_finite(light.intensity));
    }
    if (!scene.lights.empty()) {
      EXPECT_NO_THROW(validate(scene)) << trial;
    }
    EXPECT_EQ(report.lights, scene.lights.size());
  }
}

}  // namespace
}  // namespace penumbra
