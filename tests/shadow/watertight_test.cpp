// SPDX-License-Identifier: MIT
// Umbra behind meshes rests on no ray slipping through a closed surface, not even one that runs in
// the plane of a face.
#include <gtest/gtest.h>

#include <vector>

#include "penumbra/shadow/visibility.h"
#include "tests/kernel/nasty_shapes.h"

namespace penumbra {
namespace {

/// A prism over a profile in (x, z) of which corner 3 sees all others.
Mesh prism(const std::vector<Vec3d>& profile) {
  const auto n = static_cast<std::uint32_t>(profile.size());
  Mesh mesh;
  for (const Vec3d p : profile)
    for (const double y : {-1.0, 1.0}) mesh.positions.push_back(Vec3f(Vec3d{p.x, y, p.z}));
  for (std::uint32_t k = 0; k < n; ++k) {
    const std::uint32_t a = 2 * k, b = 2 * ((k + 1) % n);
    mesh.triangles.push_back({a, b, b + 1});
    mesh.triangles.push_back({a, b + 1, a + 1});
  }
  for (std::uint32_t side = 0; side < 2; ++side)
    for (std::uint32_t k = 4; k < n + 2; ++k)
      mesh.triangles.push_back({6 + side, 2 * (k % n) + side, 2 * ((k + 1) % n) + side});
  return mesh;
}

TEST(Watertight, NoRayLeaksThroughAStepSeenAlongItsTread) {
  nasty::Random random(1);
  std::uint64_t hidden[2] = {};  // by volumes, by sheets
  for (int round = 0; round < 60; ++round) {
    const Frame<double> turn = frame_around(normalize(Vec3d(random.in_cube())));
    const Vec3d offset(random.in_cube());
    const auto place = [&](Vec3d p) { return turn.u * p.x + turn.v * p.y + turn.n * p.z + offset; };
    // Steps at (2, 0)-(2, 1), (1, 1)-(1, 2); the tread lies at z = 1.
    Mesh steps = prism({{0, 0, 0}, {2, 0, 0}, {2, 0, 1}, {1, 0, 1}, {1, 0, 2}, {0, 0, 2}});
    for (Vec3f& p : steps.positions) p = Vec3f(place(Vec3d(p)));
    ShapeSet shapes;
    shapes.meshes.push_back(steps);
    for (const Vec3d corner : {Vec3d{-8, 8, 5}, Vec3d{8, -8, -5}})  // makes room for receivers
      shapes.spheres.push_back({Vec3f(place(corner)), 0.01f, 0});

    const Vec3d middle = place({5.0 + double(random.uniform(0, 3)), 0, 1});
    const LightShape light = LineLight{Vec3f(middle), Vec3f(turn.v * 0.3)};
    const KernelOptions by_brute{KernelKind::brute, {}};
    const Kernel wide(shapes, {}), brute(shapes, by_brute);
    const ShadowScene judge =
        prepare_shadows(brute, shapes, by_brute, {&light, 1}, Method::stochastic);
    const ShadowScene methods[] = {prepare_shadows(wide, shapes, {}, {&light, 1}, Method::umbra),
                                   prepare_shadows(wide, shapes, {}, {&light, 1}, Method::shaft)};
    VisibilityScratch scratch(64);
    ShadowCounters ignored, counters[2];
    for (std::uint64_t point = 0; point < 100; ++point) {
      const Vec3d p =
          place({double(random.uniform(0.1f, 0.9f)), double(random.uniform(-0.3f, 0.3f)), 1});
      const Receiver receiver{Vec3f(p), Vec3f(normalize(middle - p))};
      OccluderQueue a;
      const Visibility truth = visibility(judge, 0, receiver, point, a, scratch, ignored);
      for (int i = 0; i < 2; ++i) {
        OccluderQueue b;
        ASSERT_EQ(visibility(methods[i], 0, receiver, point, b, scratch, counters[i]).fraction,
                  truth.fraction);
      }
    }
    for (int i = 0; i < 2; ++i) hidden[i] += counters[i].umbra;
  }
  EXPECT_GT(hidden[0], 1000u);
}

}  // namespace
}  // namespace penumbra
