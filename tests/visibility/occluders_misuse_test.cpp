// SPDX-License-Identifier: MIT
// Every misuse of Occluders throws an Error that says what is wrong, and changes nothing; threads
// see what was committed before or after, and nothing in between.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <functional>
#include <limits>
#include <string>
#include <thread>

#include "penumbra/penumbra.h"
#include "tests/visibility/callers_arrays.h"

namespace penumbra {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float inf = std::numeric_limits<float>::infinity();

void expect_error(const std::function<void()>& call, const std::string& part) {
  try {
    call();
    ADD_FAILURE() << "no error: " << part;
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    EXPECT_FALSE(error.hint.empty());
  }
}

/// Spheres that were committed, and what is seen then.
class OccludersMisuse : public testing::Test {
 protected:
  void SetUp() override {
    balls = occluders.add_spheres(rows_of(arrays.centers), rows_of(arrays.radii));
    occluders.commit();
    before = occluders.visible_fraction(points, light);
    ASSERT_NE(*std::min_element(before.begin(), before.end()), 1);
  }

  /// The next commit fails, and nothing has changed.
  void expect_failing_commit(const std::string& part) {
    expect_error([&] { occluders.commit(); }, part);
    EXPECT_EQ(occluders.visible_fraction(points, light), before);
  }

  CallersArrays arrays;
  const Points points{.positions = rows_of(arrays.points), .normals = rows_of(arrays.normals)};
  const BallLight light{{1, 6, 0.5f}, 0.75f};
  Occluders occluders, shapes;
  GeometryId balls;
  std::vector<float> before;
};

TEST_F(OccludersMisuse, NothingIsAskedBeforeTheFirstCommit) {
  const Occluders fresh;
  const Box box{{0, 0, 0}, {1, 1, 1}};
  const auto expect_refusal = [](const std::function<void()>& call) {
    expect_error(call, "before they were committed");
  };
  std::vector<Visibility> seen(arrays.points.size());
  std::vector<std::uint32_t> samples(arrays.points.size());
  expect_refusal([&] { fresh.classify(points, light); });
  expect_refusal([&] { fresh.visible_fraction(points, light); });
  expect_refusal([&] { fresh.visible_samples(points, light, samples); });
  expect_refusal([&] { fresh.visibility(points, light, seen); });
  expect_refusal([&] { fresh.blockers({}, {}, light); });
  expect_refusal([&] { fresh.shaft(box, light); });
  expect_refusal([&] { fresh.bounds(); });
  expect_refusal([&] { fresh.memory_bytes(); });
}

TEST_F(OccludersMisuse, ArraysThatDisagreeAreNotAdded) {
  const std::vector<float> few{1, 1};
  const VectorRows three = rows_of(arrays.centers);
  expect_error([&] { occluders.add_spheres(three, rows_of(few)); }, "2 radii for 3 spheres");
  expect_error([&] { occluders.add_disks(three, {}, rows_of(arrays.radii)); }, "0 normals for 3");
  expect_error([&] { occluders.add_cones(three, three, rows_of(arrays.radii), rows_of(few)); },
               "2 apex radii for 3");
  expect_error([&] { occluders.update(balls, VectorRows()); }, "0 positions for 3");
  occluders.commit();
  EXPECT_EQ(occluders.visible_fraction(points, light), before);
}

TEST_F(OccludersMisuse, WhatWasMovedElsewhereIsNotAsked) {
  Occluders elsewhere = std::move(occluders);
  expect_error([&] { occluders.commit(); }, "the occluders were moved elsewhere");
  expect_error([&] { occluders.bounds(); }, "the occluders were moved elsewhere");
  elsewhere.commit();
  elsewhere.bounds();
}

TEST_F(OccludersMisuse, WhatWasNeverAddedOrWasRemovedIsNotNamed) {
  const GeometryId mesh = occluders.add_triangles(arrays.positions(), rows_of(arrays.triangles));
  const GroupId group = occluders.add_group(shapes);
  const InstanceId instance = occluders.add_instance(group, {});
  expect_error([&] { occluders.remove(GeometryId{9}); }, "there is no geometry 9");
  expect_error([&] { occluders.remove(InstanceId{9}); }, "there is no instance 9");
  expect_error([&] { occluders.remove(GroupId{9}); }, "there is no group 9");
  expect_error([&] { occluders.add_instance({9}, {}); }, "there is no group 9");
  expect_error([&] { occluders.update(group, GeometryId{0}, {}); }, "there is no geometry 0");
  expect_error([&] { occluders.remove(group); }, "group 0 is placed by instances");
  occluders.remove(instance);
  occluders.remove(group);
  occluders.remove(mesh);
  expect_error([&] { occluders.remove(mesh); }, "geometry 1 was removed");
  expect_error([&] { occluders.update(mesh, VectorRows()); }, "geometry 1 was removed");
  expect_error([&] { occluders.remove(instance); }, "instance 0 was removed");
  expect_error([&] { occluders.update(instance, {}); }, "instance 0 was removed");
  expect_error([&] { occluders.remove(group); }, "group 0 was removed");
  expect_error([&] { occluders.add_instance(group, {}); }, "group 0 was removed");
  occluders.commit();
  EXPECT_EQ(occluders.visible_fraction(points, light), before);
}

TEST_F(OccludersMisuse, GroupsAreOfOthersWithoutInstances) {
  expect_error([&] { occluders.add_group(occluders); }, "a group of itself");
  occluders.add_instance(occluders.add_group(shapes), {});
  expect_error([&] { shapes.add_group(occluders); }, "a group has instances");
}

TEST_F(OccludersMisuse, CommitsOfNumbersThatCannotBeMeantFail) {
  for (const float bad : {nan, inf, -inf, 1.1e15f}) {
    arrays.centers[1].y = bad;
    expect_failing_commit("geometry 0: sphere 1 has a coordinate");
  }
  arrays.centers[1].y = 1.5f;
  for (const float bad : {nan, inf, 0.0f, -1.0f}) {
    arrays.radii[2] = bad;
    expect_failing_commit("geometry 0: sphere 2 has a radius");
  }
  arrays.radii[2] = 0.75f;
  const GeometryId mesh = occluders.add_triangles(arrays.positions(), rows_of(arrays.triangles));
  arrays.triangles[5][1] = 64;
  expect_failing_commit("geometry 1: triangle 5 has a vertex that does not exist");
  arrays.triangles[5][1] = ~0u;
  expect_failing_commit("geometry 1: triangle 5 has a vertex that does not exist");
  arrays.triangles[5][1] = 0;
  arrays.vertices[63].position.x = nan;
  expect_failing_commit("geometry 1: vertex 63 has a coordinate");
  occluders.remove(mesh);
  occluders.commit();
  EXPECT_EQ(occluders.visible_fraction(points, light), before);
}

TEST_F(OccludersMisuse, CommitsOfShapesThatAreNoneFail) {
  const auto expect_bad_cone = [&](const std::string& part) {
    const GeometryId cone =
        occluders.add_cones(rows_of(arrays.bases), rows_of(arrays.apexes),
                            rows_of(arrays.base_radii), rows_of(arrays.apex_radii));
    expect_failing_commit(part);
    occluders.remove(cone);
  };
  arrays.base_radii[0] = -1;
  expect_bad_cone("cone 0 has a radius");
  arrays.base_radii[0] = arrays.apex_radii[0] = 0;
  expect_bad_cone("cone 0 has a radius");
  arrays.base_radii[0] = 1;
  arrays.apexes = arrays.bases;
  expect_bad_cone("cone 0 has its base where its apex is");
  arrays.disk_normals[0] = {0, 0, 0};
  occluders.add_disks(rows_of(arrays.disk_centers), rows_of(arrays.disk_normals),
                      rows_of(arrays.disk_radii));
  expect_failing_commit("disk 0 has no normal");
}

TEST_F(OccludersMisuse, CommitsOfPlacementsThatCannotBeFail) {
  shapes.add_spheres(rows_of(arrays.centers), rows_of(arrays.radii));
  const InstanceId instance = occluders.add_instance(occluders.add_group(shapes), {});
  const auto expect_bad = [&](const Transform& placement, const std::string& part) {
    occluders.update(instance, placement);
    expect_failing_commit(part);
  };
  expect_bad({{0, 0, 0}, {0, 1, 0}, {0, 0, 1}, {}}, "flattens");
  expect_bad({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {double(nan), 0, 0}}, "instance 0");
  expect_bad({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1e16, 0, 0}}, "instance 0");
  expect_bad({{2, 0, 0}, {0, 1, 0}, {0, 0, 1}, {}}, "stretches spheres, cones or disks");
  expect_bad({{1e15, 0, 0}, {0, 1e15, 0}, {0, 0, 1e15}, {}}, "beyond 1e15");
}

TEST_F(OccludersMisuse, QuestionsThatCannotBeMeantAreRefused) {
  std::vector<float> few(3);
  expect_error([&] { occluders.visible_fraction(points, light, few); },
               "room for 3 answers where 400 are to come");
  Points bad = points;
  bad.normals = rows_of(arrays.centers);
  expect_error([&] { occluders.visible_fraction(bad, light); }, "3 normals for 400 points");
  bad = points;
  bad.keys = Rows<std::uint64_t>(arrays.keys.data(), 7);
  expect_error([&] { occluders.visible_fraction(bad, light); }, "7 keys for 400 points");
  bad = points;
  bad.offset = nan;
  expect_error([&] { occluders.visible_fraction(bad, light); }, "offset");
  for (const std::uint32_t d : {0u, 65537u, ~0u})
    expect_error([&] { occluders.visible_fraction(points, light, {.shadow_samples = d}); },
                 "shadow samples");
  expect_error([&] { occluders.visible_fraction(points, light, {.method = Method::umbra}); },
               "the methods shaft and stochastic alone");
  expect_error([&] { occluders.visible_fraction(points, light, {.threads = ~0u}); }, "threads");
  std::vector<std::uint32_t> samples(points.positions.size());
  expect_error([&] { occluders.visible_samples(points, light, samples, {.shadow_samples = 33}); },
               "room for 400 answers where 800 are to come");
  expect_error([&] { occluders.shaft(Box(), light); }, "the box of a shaft is empty");
}

TEST_F(OccludersMisuse, LightsThatAreNoneAreRefusedByEveryQuestion) {
  std::vector<Visibility> seen(arrays.points.size());
  for (const LightShape& none :
       {LightShape(BallLight{{0, 9, 0}, 0}), LightShape(BallLight{{0, nan, 0}, 1}),
        LightShape(ParallelogramLight{{0, 9, 0}, {1, 0, 0}, {2, 0, 0}}),
        LightShape(DiskLight{{0, 9, 0}, {0, 0, 0}, 1}), LightShape(LineLight{{0, 9, 0}, {}}),
        LightShape(PolygonLight{{0, 9, 0}, {{0, 9, 0}}}), LightShape(SunLight{{0, 1, 0}, 2})}) {
    expect_error([&] { occluders.visible_fraction(points, none); }, "the light ");
    expect_error([&] { occluders.visibility(points, none, seen); }, "the light ");
    expect_error([&] { occluders.classify(points, none); }, "the light ");
    expect_error([&] { occluders.blockers({}, {}, none); }, "the light ");
    expect_error([&] { occluders.shaft({{0, 0, 0}, {1, 1, 1}}, none); }, "the light ");
    expect_error([&] { light_samples(none, {}, 0, 4); }, "the light ");
  }
}

TEST_F(OccludersMisuse, PointsThatAreNoNumbersAreAnswered) {
  arrays.points[3] = {nan, 0, 0};
  arrays.points[4] = {inf, -inf, 0};
  arrays.points[5] = {3e38f, 0, 0};
  arrays.normals[6] = {nan, nan, nan};
  arrays.normals[7] = {0, 0, 0};
  const std::vector<float> fast = occluders.visible_fraction(points, light);
  EXPECT_EQ(fast, occluders.visible_fraction(points, light, {.method = Method::stochastic}));
  EXPECT_TRUE(std::all_of(fast.begin(), fast.end(), [](float v) { return v >= 0 && v <= 1; }));
  EXPECT_TRUE(std::equal(fast.begin() + 8, fast.end(), before.begin() + 8));
}

// The centres that one thread commits are those of one array or the other, and so is what all see.
TEST_F(OccludersMisuse, ThreadsSeeWhatWasCommittedBeforeOrAfter) {
  std::vector<Vec3f> elsewhere = arrays.centers;
  for (Vec3f& center : elsewhere) center.x += 1;
  occluders.update(balls, rows_of(elsewhere));
  occluders.commit();
  const std::vector<float> after = occluders.visible_fraction(points, light);
  ASSERT_NE(after, before);
  std::atomic<bool> is_done = false;
  std::atomic<int> others = 0, answers = 0;
  std::vector<std::thread> threads;
  for (int t = 0; t < 3; ++t)
    threads.emplace_back([&] {
      while (!is_done) {
        const std::vector<float> seen = occluders.visible_fraction(points, light);
        if (seen != before && seen != after) ++others;
        occluders.blockers({}, {}, light);
        occluders.bounds();
        ++answers;
      }
    });
  threads.emplace_back([&] {  // builds while the other refits
    while (!is_done) occluders.commit({.may_refit = false});
  });
  for (int i = 0; i < 100 || (answers < 30 && i < 100000); ++i) {
    occluders.update(balls, i % 2 ? rows_of(elsewhere) : rows_of(arrays.centers));
    const GeometryId more = occluders.add_spheres({}, {});
    occluders.commit();
    occluders.remove(more);
  }
  is_done = true;
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(others, 0);
  EXPECT_GT(answers, 0);
}

TEST_F(OccludersMisuse, TwoMayBeGroupsOfEachOtherAtOnce) {
  Occluders other;
  std::thread thread([&] {
    for (int i = 0; i < 200; ++i) other.add_group(occluders);
  });
  for (int i = 0; i < 200; ++i) occluders.add_group(other);
  thread.join();
  occluders.commit();
  EXPECT_EQ(occluders.visible_fraction(points, light), before);
}

}  // namespace
}  // namespace penumbra
