// SPDX-License-Identifier: MIT
#include "penumbra/visibility/occluders.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <mutex>
#include <numeric>

#include <tbb/parallel_for.h>

#include "penumbra/geometry/placed_shape.h"
#include "penumbra/scene/complete_scene.h"
#include "penumbra/scene/error.h"
#include "penumbra/scene/gallery.h"
#include "penumbra/trace/prepare.h"
#include "penumbra/trace/render.h"
#include "penumbra/visibility/lights.h"
#include "penumbra/visibility/scene_occluders.h"
#include "tests/kernel/nasty_shapes.h"

namespace penumbra {
namespace {

using nasty::Random;

/// A square of two triangles at a height, and what lies on the floor under it.
struct Roof {
  std::vector<Vec3f> positions{{-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}};
  std::vector<Triangle> triangles{{0, 1, 2}, {0, 2, 3}};
  Occluders occluders;
  GeometryId id = occluders.add_triangles(positions, triangles);
  Roof() { occluders.commit(); }
};

const std::vector<Vec3f> up{{0, 0, 1}};
const BallLight lamp{{0, 0, 4}, 0.5f};

std::vector<Vec3f> floor_points(std::size_t count, float extent) {
  std::vector<Vec3f> points;
  Random random(5);
  for (std::size_t i = 0; i < count; ++i)
    points.push_back({random.uniform(-extent, extent), random.uniform(-extent, extent), 0});
  return points;
}

/// Points of the floor, all with the one normal.
Points on_floor(const std::vector<Vec3f>& points) {
  return {.positions = points, .normals = VectorRows(up.data(), points.size(), 0)};
}

TEST(Occluders, hide_what_lies_behind_them) {
  const Roof roof;
  const std::vector<Vec3f> points{{0, 0, 0}, {9, 9, 0}, {1.2f, 0, 0}};
  const auto classes = roof.occluders.classify(on_floor(points), lamp);
  const auto fractions = roof.occluders.visible_fraction(on_floor(points), lamp);
  EXPECT_EQ(classes[0], ShadowClass::umbra);
  EXPECT_EQ(classes[1], ShadowClass::lit);
  EXPECT_EQ(classes[2], ShadowClass::penumbra);
  EXPECT_EQ(fractions[0], 0);
  EXPECT_EQ(fractions[1], 1);
  EXPECT_TRUE(fractions[2] > 0 && fractions[2] < 1);
}

/// A picture's questions, and its answers.
struct RendererAnswers {
  std::vector<Vec3f> positions, normals;
  std::vector<std::uint64_t> keys;
  std::vector<Visibility> seen;
};

RendererAnswers answers_of_renderer(const Scene& scene, std::uint32_t light) {
  RendererAnswers all;
  std::mutex mutex;
  RenderOptions options;
  options.width = options.height = 64;
  options.observe = [&](const AnsweredBatch& batch) {
    if (batch.light != light) return;
    const std::lock_guard lock(mutex);
    for (std::size_t i = 0; i < batch.queries.size(); ++i) {
      all.positions.push_back(batch.queries[i].receiver.position);
      all.normals.push_back(batch.queries[i].receiver.normal);
      all.keys.push_back(batch.queries[i].key);
      all.seen.push_back(batch.seen[i]);
    }
  };
  const Kernel kernel(scene.shapes, kernel_options(scene));
  render(scene, prepare_shadows(scene, kernel, Method::stochastic), options);
  return all;
}

class OfRenderer : public testing::TestWithParam<const char*> {};

TEST_P(OfRenderer, answers_are_had_bit_for_bit) {
  SceneOptions clear;
  clear.clear_glass = true;
  const Scene scene = complete_scene(*gallery_scene(GetParam()), clear);
  const Occluders occluders = occluders_of(scene);
  for (std::uint32_t light = 0; light < scene.lights.size(); ++light) {
    const RendererAnswers asked = answers_of_renderer(scene, light);
    const Points points{
        .positions = asked.positions, .normals = asked.normals, .offset = 0.0f, .keys = asked.keys};
    std::vector<Visibility> seen(asked.seen.size());
    occluders.visibility(points, scene.lights[light].shape, seen, {.light_index = {}});
    for (std::size_t i = 0; i < seen.size(); ++i) {
      ASSERT_EQ(seen[i].fraction, asked.seen[i].fraction);
      ASSERT_EQ(seen[i].cosine_weighted, asked.seen[i].cosine_weighted);
    }
  }
}
INSTANTIATE_TEST_SUITE_P(, OfRenderer,
                         testing::Values("balls:2", "rings", "molecule", "cylinders", "bust"),
                         [](const auto& of) {
                           std::string name = of.param;
                           std::replace(name.begin(), name.end(), ':', '_');
                           return name;
                         });

TEST(Occluders, give_the_fractions_of_the_judge_under_every_light) {
  const Roof roof;
  const auto points = floor_points(3000, 3);
  const std::vector<LightShape> lights{
      PointLight{{0, 0, 4}},
      lamp,
      ParallelogramLight{{0, 0, 4}, {0.5f, 0, 0}, {0, 0.5f, 0}},
      DiskLight{{0, 0, 4}, {0, 0, -1}, 0.5f},
      LineLight{{0, 0, 4}, {0.5f, 0, 0}},
      polygon_light(std::vector<Vec3f>{{-1, -1, 4}, {1, -1, 4}, {0, 1, 4}}),
      hull_light(std::vector<Vec3f>{{-1, -1, 4}, {1, -1, 4}, {0, 1, 4}, {0, 0, 5}}),
      sun_light({0.2f, 0, 1}, 5)};
  for (const LightShape& light : lights)
    EXPECT_EQ(
        roof.occluders.visible_fraction(on_floor(points), light),
        roof.occluders.visible_fraction(on_floor(points), light, {.method = Method::stochastic}));
}

TEST(Occluders, say_which_samples_are_seen) {
  const Roof roof;
  const auto points = floor_points(500, 3);
  for (const std::uint32_t d : {1u, 31u, 32u, 33u, 100u}) {
    const std::size_t words = (d + 31) / 32;
    std::vector<std::uint32_t> seen(points.size() * words), truth(seen.size());
    roof.occluders.visible_samples(on_floor(points), lamp, seen, {.shadow_samples = d});
    roof.occluders.visible_samples(on_floor(points), lamp, truth,
                                   {.shadow_samples = d, .method = Method::stochastic});
    EXPECT_EQ(seen, truth);
    const auto fractions =
        roof.occluders.visible_fraction(on_floor(points), lamp, {.shadow_samples = d});
    for (std::size_t i = 0; i < points.size(); ++i) {
      int bits = 0;
      for (std::size_t word = 0; word < words; ++word)
        bits += std::popcount(seen[i * words + word]);
      ASSERT_EQ(fractions[i], static_cast<float>(bits) / static_cast<float>(d));
    }
  }
}

TEST(Occluders, give_the_ways_to_the_samples) {
  const Roof roof;
  const std::vector<Vec3f> points{{1.2f, 0, 0}};
  std::vector<std::uint32_t> seen(1);
  const Points asked{.positions = points, .offset = 0.0f, .first_key = 9};
  roof.occluders.visible_samples(asked, lamp, seen, {.light_index = 3});
  const auto ways = light_samples(lamp, points[0], 9, 32, 3);
  for (std::uint32_t i = 0; i < 32; ++i) {
    const Vec3f at_roof = points[0] + ways[i] * (1 / ways[i].z);
    const bool is_under = std::abs(at_roof.x) <= 1 && std::abs(at_roof.y) <= 1;
    EXPECT_EQ(seen[0] >> i & 1, is_under ? 0u : 1u);
  }
  EXPECT_EQ(light_samples(lamp, points[0], light_key(9, 3), 32, {}), ways);
}

TEST(Occluders, are_asked_by_floating_points_on_all_sides) {
  const Roof roof;
  const std::vector<Vec3f> points{{0, 0, 3}};
  const Points floating{.positions = points};
  const std::vector<Vec3f> down{{0, 0, -1}};
  const Points turned{.positions = points, .normals = down};
  EXPECT_EQ(roof.occluders.visible_fraction(floating, lamp)[0], 1);
  EXPECT_EQ(roof.occluders.visible_fraction(turned, lamp)[0], 0);
  EXPECT_EQ(roof.occluders.classify(floating, lamp)[0], ShadowClass::lit);
  EXPECT_EQ(roof.occluders.visible_fraction(floating, BallLight{{0, 0, -4}, 0.01f})[0], 0);
}

TEST(Occluders, do_not_block_points_on_their_own_surface) {
  Random random(6);
  for (int trial = 0; trial < 300; ++trial) {
    const float scale = random.power(-6, 6);
    const Vec3f shift = random.in_cube() * (scale * random.power(0, 3));
    std::vector<Vec3f> corners;
    for (int k = 0; k < 3; ++k) corners.push_back(shift + random.in_cube() * scale);
    const Vec3f normal = normalize(cross(corners[1] - corners[0], corners[2] - corners[0]));
    const std::vector<Triangle> triangle{{0, 1, 2}};
    Occluders occluders;
    occluders.add_triangles(corners, triangle);
    occluders.commit();
    std::vector<Vec3f> points;
    for (int k = 0; k < 50; ++k) {
      const float u = random.uniform(0, 1), v = random.uniform(0, 1 - u);
      points.push_back(corners[0] * (1 - u - v) + corners[1] * u + corners[2] * v);
    }
    const Points asked{.positions = points, .normals = VectorRows(&normal, points.size(), 0)};
    const Vec3f middle = (corners[0] + corners[1] + corners[2]) * (1.0f / 3);
    const BallLight light{middle + normal * (2 * scale), 0.5f * scale};
    for (const float fraction : occluders.visible_fraction(asked, light)) ASSERT_EQ(fraction, 1);
  }
}

TEST(Occluders, answer_points_outside_of_them_by_proof) {
  const Roof roof;
  const auto points = floor_points(4096, 400);  // most of them far from the roof
  ShadowCounters counters;
  std::vector<float> out(points.size());
  counters = roof.occluders.visible_fraction(on_floor(points), lamp, out);
  EXPECT_GT(counters.lit, points.size() * 9 / 10);
}

TEST(Occluders, are_not_lost_to_the_proofs_by_one_point_far_away) {
  const Roof roof;
  auto points = floor_points(4000, 3);
  const SunLight sun = sun_light({0.2f, 0.1f, 1}, 2);
  const auto proven = [&] {
    const auto classes = roof.occluders.classify(on_floor(points), sun);
    return classes.size() - static_cast<std::size_t>(
                                std::count(classes.begin(), classes.end(), ShadowClass::penumbra));
  };
  const std::size_t before = proven();
  EXPECT_GT(before, 3500u);
  points[7] = {1e12f, 0, 0};
  EXPECT_GE(proven() + 64, before);
}

TEST(Occluders, are_classed_alike_whatever_d_is) {
  const Roof roof;
  const auto points = floor_points(3000, 3);
  const auto classes = roof.occluders.classify(on_floor(points), lamp);
  for (const std::uint32_t d : {1u, 100u, 5000u})
    EXPECT_EQ(roof.occluders.classify(on_floor(points), lamp, {.shadow_samples = d}), classes);
}

TEST(Occluders, let_progress_run_tasks_of_its_own) {
  const Roof roof;
  const auto points = floor_points(60000, 3);
  std::atomic<int> done = 0;
  const auto work = [&](double) {
    tbb::parallel_for(0, 50, [&](int) { ++done; });
    return true;
  };
  const auto truth = roof.occluders.visible_fraction(on_floor(points), lamp);
  std::vector<float> out(points.size());
  for (int i = 0; i < 20; ++i) {
    std::fill(out.begin(), out.end(), -1.0f);
    roof.occluders.visible_fraction(on_floor(points), lamp, out, {.threads = 8, .progress = work});
    EXPECT_EQ(out, truth);
  }
  EXPECT_GT(done, 0);
}

TEST(Occluders, call_no_progress_again_that_has_thrown) {
  const Roof roof;
  const auto points = floor_points(100000, 3);
  std::atomic<int> calls = 0;
  const auto fail = [&](double) -> bool {
    ++calls;
    throw std::runtime_error("the caller's own");
  };
  EXPECT_THROW(
      roof.occluders.visible_fraction(on_floor(points), lamp, {.threads = 8, .progress = fail}),
      std::runtime_error);
  EXPECT_EQ(calls, 1);
}

TEST(Occluders, without_anything_in_them_hide_nothing) {
  Occluders none;
  EXPECT_EQ(none.commit().primitives, 0u);
  const auto points = floor_points(100, 3);
  for (const Method method : {Method::shaft, Method::stochastic})
    for (const float fraction : none.visible_fraction(on_floor(points), lamp, {.method = method}))
      EXPECT_EQ(fraction, 1);
  EXPECT_TRUE(none.blockers({}, {}, lamp).primitives.empty());
  EXPECT_TRUE(none.shaft({{0, 0, 0}, {1, 1, 1}}, lamp).primitives.empty());
  EXPECT_TRUE(none.bounds().is_empty());
  EXPECT_EQ(none.classify(on_floor(points), lamp),
            std::vector<ShadowClass>(points.size(), ShadowClass::lit));
  EXPECT_EQ(none.blockers({}, {}, lamp).shadow_class, ShadowClass::lit);
  EXPECT_EQ(none.shaft({{0, 0, 0}, {1, 1, 1}}, lamp).shadow_class, ShadowClass::lit);
}

TEST(Occluders, with_numbers_that_are_none_are_in_doubt) {
  const Roof roof;
  const float nan = std::nanf("");
  const std::vector<Vec3f> points{{nan, 0, 0}, {0, INFINITY, 0}, {1e30f, 0, 0}};
  for (const ShadowClass seen : roof.occluders.classify(on_floor(points), lamp))
    EXPECT_EQ(seen, ShadowClass::penumbra);
  const std::vector<Vec3f> here{{0, 0, 0}}, nowhere{{0, nan, 1}};
  const Points turned{.positions = here, .normals = nowhere};
  EXPECT_EQ(roof.occluders.classify(turned, lamp)[0], ShadowClass::penumbra);
}

TEST(Occluders, answer_alike_on_any_number_of_threads) {
  const Roof roof;
  const auto points = floor_points(40000, 3);
  const auto truth = roof.occluders.visible_fraction(on_floor(points), lamp, {.threads = 1});
  for (const std::uint32_t threads : {0u, 2u, 7u})
    EXPECT_EQ(roof.occluders.visible_fraction(on_floor(points), lamp, {.threads = threads}), truth);
}

TEST(Occluders, tell_their_progress_and_end_when_they_are_told_to) {
  const Roof roof;
  const auto points = floor_points(100000, 3);
  double last = 0;
  roof.occluders.visible_fraction(on_floor(points), lamp, {.progress = [&](double done) {
                                    EXPECT_GT(done, last);
                                    last = done;
                                    return true;
                                  }});
  EXPECT_EQ(last, 1);
  EXPECT_THROW(roof.occluders.visible_fraction(on_floor(points), lamp,
                                               {.progress = [](double) { return false; }}),
               Cancelled);
  EXPECT_THROW(
      roof.occluders.visible_fraction(on_floor(points), lamp, {.progress = [](double) -> bool {
                                        throw std::runtime_error("the caller's own");
                                      }}),
      std::runtime_error);
}

}  // namespace
}  // namespace penumbra
