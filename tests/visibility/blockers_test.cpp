// SPDX-License-Identifier: MIT
// What may block a light, by name: all that does is there, and what proves the class.
#include "penumbra/visibility/blockers.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "penumbra/scene/gallery.h"
#include "penumbra/visibility/occluders.h"
#include "penumbra/visibility/scene_occluders.h"
#include "tests/kernel/nasty_shapes.h"

namespace penumbra {
namespace {

using nasty::Random;

const Mesh& bust() {
  static const Mesh mesh = gallery_scene("bust")->shapes.meshes.front();
  return mesh;
}

/// The triangles of the bust, with some that have no area between them, and a few balls.
struct BustAndBalls {
  Mesh mesh = bust();
  std::vector<Triangle> triangles;
  std::vector<Vec3f> centers;
  std::vector<float> radii;
  Occluders occluders;
  Box box = bounds(mesh);
  float size = box.largest_extent();

  BustAndBalls() {
    Random random(8);
    for (std::size_t i = 0; i < mesh.triangles.size(); i += 40) {
      if (i % 3 == 0) triangles.push_back({1, 1, 2});
      triangles.push_back(mesh.triangles[i]);
    }
    for (int i = 0; i < 300; ++i) {
      centers.push_back(box.center() + random.in_cube() * size);
      radii.push_back(random.uniform(0.001f, 0.05f) * size);
    }
    occluders.add_triangles(mesh.positions, triangles);
    occluders.add_spheres(centers, radii);
    occluders.commit();
  }

  /// Of what is named alone.
  Occluders only(const std::vector<PrimitiveId>& names) {
    few_triangles.clear(), few_centers.clear(), few_radii.clear();
    for (const PrimitiveId& id : names)
      if (id.geometry == 0)
        few_triangles.push_back(triangles[id.primitive]);
      else
        few_centers.push_back(centers[id.primitive]), few_radii.push_back(radii[id.primitive]);
    Occluders few;
    few.add_triangles(mesh.positions, few_triangles);
    few.add_spheres(few_centers, few_radii);
    few.commit();
    return few;
  }
  std::vector<Triangle> few_triangles;
  std::vector<Vec3f> few_centers;
  std::vector<float> few_radii;
};

std::vector<std::uint32_t> samples_seen(const Occluders& occluders, const Points& points,
                                        const LightShape& light) {
  std::vector<std::uint32_t> seen(8 * points.positions.size());
  occluders.visible_samples(points, light, seen, {.shadow_samples = 256});
  return seen;
}

TEST(Blockers, of_a_point_hold_all_that_block_a_sample) {
  BustAndBalls scene;
  Random random(2);
  int found = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const Vec3f p = scene.box.center() + random.in_cube() * scene.size;
    const Vec3f normal = random.one_in(3) ? Vec3f{} : normalize(random.in_cube());
    const BallLight light{scene.box.center() + random.in_cube() * (2 * scene.size),
                          scene.size * random.power(-3, -0.5f)};
    const Blockers blockers = scene.occluders.blockers(p, normal, light);
    const Points asked{.positions = {&p, 1}, .normals = {&normal, 1}, .offset = 0.0f};
    ASSERT_EQ(samples_seen(scene.only(blockers.primitives), asked, light),
              samples_seen(scene.occluders, asked, light));
    found += blockers.primitives.empty() ? 0 : 1;
    EXPECT_TRUE(std::is_sorted(blockers.primitives.begin(), blockers.primitives.end(),
                               [](const PrimitiveId& a, const PrimitiveId& b) {
                                 return std::pair(a.geometry, a.primitive) <
                                        std::pair(b.geometry, b.primitive);
                               }));
  }
  EXPECT_GT(found, 20);
}

TEST(Blockers, of_a_box_hold_those_of_its_points) {
  BustAndBalls scene;
  Random random(4);
  for (int trial = 0; trial < 60; ++trial) {
    const Vec3f lo = scene.box.center() + random.in_cube() * scene.size;
    const Vec3f size = (random.in_cube() + Vec3f{1, 1, 1}) * (scene.size * random.power(-3, -1));
    const Box box{lo, lo + size};
    const BallLight light{scene.box.center() + random.in_cube() * (2 * scene.size),
                          scene.size * random.power(-3, -1)};
    const Blockers all = scene.occluders.shaft(box, light);
    for (int k = 0; k < 10; ++k) {
      const Vec3f t = (random.in_cube() + Vec3f{1, 1, 1}) * 0.5f;
      const Vec3f p{lo.x + t.x * size.x, lo.y + t.y * size.y, lo.z + t.z * size.z};
      const Points asked{.positions = {&p, 1}};
      const float seen = scene.occluders.visible_fraction(asked, light)[0];
      if (all.shadow_class == ShadowClass::lit) {
        ASSERT_EQ(seen, 1);
      }
      if (all.shadow_class == ShadowClass::umbra) {
        ASSERT_EQ(seen, 0);
      }
      // By the names alone, the points see the same.
      const Occluders few = scene.only(all.primitives);
      ASSERT_EQ(few.visible_fraction(asked, light)[0], seen);
    }
  }
}

TEST(Blockers, are_named_by_instance_as_well) {
  const std::vector<Vec3f> centers{{0, 0, 0}, {0, 0, 5}};
  const std::vector<float> radii{1, 1};
  Occluders balls, occluders;
  balls.add_spheres(centers, radii);
  const GroupId group = occluders.add_group(balls);
  const Transform aside{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {10, 0, 0}};
  occluders.remove(occluders.add_instance(group, {}));
  occluders.add_instance(group, {});
  const InstanceId far = occluders.add_instance(group, aside);
  occluders.add_spheres({centers.data() + 1, 1}, {radii.data(), 1});
  occluders.commit();
  const Blockers blockers =
      occluders.blockers({10, 0, -3}, {0, 0, 1}, BallLight{{10, 0, 20}, 0.1f});
  ASSERT_EQ(blockers.shadow_class, ShadowClass::umbra);
  EXPECT_EQ(blockers.primitives, (std::vector<PrimitiveId>{{0, 0, far.index}, {0, 1, far.index}}));
  const Blockers own = occluders.blockers({0, 0, 3}, {0, 0, 1}, BallLight{{0, 0, 20}, 0.1f});
  EXPECT_EQ(own.primitives, (std::vector<PrimitiveId>{{0, 0}, {0, 1, 1}}));
}

// A sliver of the light that is above the horizon, which most sets of samples miss.
TEST(Blockers, prove_nothing_by_samples_that_miss_what_is_above_the_horizon) {
  Occluders occluders;
  const std::vector<Vec3f> centers{{0, 0, 100}};
  const std::vector<float> radii{1};
  occluders.add_spheres(centers, radii);
  occluders.commit();
  for (const float above : {0.3f, 1e-2f, 1e-3f, 1e-4f}) {
    const BallLight light{{0, above - 1, 5}, 1};
    const Blockers blockers = occluders.blockers({0, 0, 0}, {0, 1, 0}, light);
    EXPECT_NE(blockers.shadow_class, ShadowClass::umbra) << above;
  }
  EXPECT_EQ(occluders.blockers({0, 0, 0}, {0, 1, 0}, BallLight{{0, -2, 5}, 1}).shadow_class,
            ShadowClass::umbra);
}

TEST(Blockers, of_what_is_wholly_lit_are_none) {
  const BustAndBalls scene;
  const Vec3f high = scene.box.center() + Vec3f{0, 0, 20 * scene.size};
  const Blockers blockers =
      scene.occluders.blockers(high, {0, 0, 1}, BallLight{high + Vec3f{0, 0, scene.size}, 0.1f});
  EXPECT_EQ(blockers.shadow_class, ShadowClass::lit);
  EXPECT_TRUE(blockers.primitives.empty());
}

}  // namespace
}  // namespace penumbra
