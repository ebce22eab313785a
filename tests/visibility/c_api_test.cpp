// SPDX-License-Identifier: MIT
// C gets the answers of C++, bit for bit.
#include <gtest/gtest.h>

#include <cstring>
#include <string>
#include <thread>

#include "penumbra/penumbra.h"
#include "tests/visibility/c_api_scene.h"

namespace penumbra {
namespace {

const std::vector<Vec3f> square_corners{{0, 6, 0}, {2, 6, 0}, {2, 6, 2}, {0, 6, 2}};
const std::vector<Vec3f> hull_corners{{0, 6, 0}, {2, 6, 0}, {1, 7, 0}, {1, 6, 2}, {1, 6.5f, 1}};
constexpr double placement[12]{0.5, 0, 0, 2, 0, 0.5, 0, 1.5, 0, 0, 0.5, 2};
const Transform transform{{0.5, 0, 0}, {0, 0.5, 0}, {0, 0, 0.5}, {2, 1.5, 2}};

struct Pair {
  penumbra_light c;
  LightShape cpp;
};

std::vector<Pair> all_lights() {
  const Vec3f center{1, 6, 0.5f}, u{1, 0.25f, 0}, v{0, 0, 0.75f};
  std::vector<Pair> all{
      {c_light(PENUMBRA_LIGHT_POINT), PointLight{center}},
      {c_light(PENUMBRA_LIGHT_BALL), BallLight{center, 0.75f}},
      {c_light(PENUMBRA_LIGHT_PARALLELOGRAM), ParallelogramLight{center, u, v}},
      {c_light(PENUMBRA_LIGHT_DISK), DiskLight{center, u, 0.75f}},
      {c_light(PENUMBRA_LIGHT_LINE), LineLight{center, u}},
      {c_light(PENUMBRA_LIGHT_SUN), sun_light(u, 5)},
      {c_light(PENUMBRA_LIGHT_POLYGON), polygon_light(square_corners)},
      {c_light(PENUMBRA_LIGHT_HULL), hull_light(hull_corners)},
  };
  all[6].c.corners = c_rows(square_corners);
  all[7].c.corners = c_rows(hull_corners);
  return all;
}

template <class Row>
bool same_bits(const std::vector<Row>& a, const std::vector<Row>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Row)) == 0;
}

/// The same occluders in both languages.
class CApi : public testing::Test {
 protected:
  void SetUp() override {
    cpp.add_triangles(arrays.positions(), rows_of(arrays.triangles));
    cpp.add_spheres(rows_of(arrays.centers), rows_of(arrays.radii));
    cpp.add_cones(rows_of(arrays.bases), rows_of(arrays.apexes), rows_of(arrays.base_radii),
                  rows_of(arrays.apex_radii), Caps::capped);
    cpp.add_disks(rows_of(arrays.disk_centers), rows_of(arrays.disk_normals),
                  rows_of(arrays.disk_radii));
    cpp_shapes.add_spheres(rows_of(arrays.centers), rows_of(arrays.radii));
    cpp.add_instance(cpp.add_group(cpp_shapes), transform);

    expect_ok(penumbra_add_triangles(c, c_positions(arrays), c_rows(arrays.triangles), &mesh));
    expect_ok(penumbra_add_spheres(c, c_rows(arrays.centers), c_rows(arrays.radii), &balls));
    expect_ok(penumbra_add_cones(c, c_rows(arrays.bases), c_rows(arrays.apexes),
                                 c_rows(arrays.base_radii), c_rows(arrays.apex_radii), 1, &cone));
    expect_ok(penumbra_add_disks(c, c_rows(arrays.disk_centers), c_rows(arrays.disk_normals),
                                 c_rows(arrays.disk_radii), {}, &disk));
    expect_ok(
        penumbra_add_spheres(c_shapes, c_rows(arrays.centers), c_rows(arrays.radii), &group_balls));
    expect_ok(penumbra_add_group(c, c_shapes, &group));
    expect_ok(penumbra_add_instance(c, group, placement, &instance));
    commit();
  }

  static void expect_ok(penumbra_error code) {
    EXPECT_EQ(code, PENUMBRA_OK) << penumbra_last_error_message();
  }

  void commit() {
    cpp.commit();
    expect_ok(penumbra_commit(c, nullptr, nullptr));
  }

  std::vector<float> c_fractions(const penumbra_light& light) {
    const penumbra_points points = c_points(arrays);
    std::vector<float> seen(arrays.points.size());
    expect_ok(
        penumbra_visible_fraction(c, &points, &light, seen.data(), seen.size(), nullptr, nullptr));
    return seen;
  }

  std::vector<float> cpp_fractions(const LightShape& light) {
    return cpp.visible_fraction(cpp_points, light);
  }

  /// C and C++ see the same, and something else than `before`.
  void expect_changed(const std::vector<float>& before) {
    commit();
    const std::vector<float> now = c_fractions(c_ball());
    EXPECT_TRUE(same_bits(now, cpp_fractions(cpp_ball)));
    EXPECT_FALSE(same_bits(now, before));
  }

  CallersArrays arrays;
  const Points cpp_points{.positions = rows_of(arrays.points), .normals = rows_of(arrays.normals)};
  const BallLight cpp_ball{{1, 6, 0.5f}, 0.75f};
  Occluders cpp, cpp_shapes;
  CScene c, c_shapes;
  penumbra_geometry mesh{}, balls{}, cone{}, disk{}, group_balls{};
  penumbra_group group{};
  penumbra_instance instance{};
};

TEST_F(CApi, IsOfTheVersionOfItsHeader) {
  EXPECT_EQ(penumbra_c_api_version(), std::uint32_t{PENUMBRA_C_API_VERSION});
}

TEST_F(CApi, SeesTheSameFractionsOfEveryLight) {
  for (const auto& [light, shape] : all_lights()) {
    const std::vector<float> seen = c_fractions(light);
    EXPECT_TRUE(same_bits(seen, cpp_fractions(shape))) << light.kind;
    EXPECT_NE(*std::max_element(seen.begin(), seen.end()),
              *std::min_element(seen.begin(), seen.end()));
  }
}

TEST_F(CApi, FindsTheSameClassesOfEveryLight) {
  const penumbra_points points = c_points(arrays);
  for (const auto& [light, shape] : all_lights()) {
    std::vector<std::uint8_t> classes(arrays.points.size());
    expect_ok(
        penumbra_classify(c, &points, &light, classes.data(), classes.size(), nullptr, nullptr));
    const std::vector<ShadowClass> expected = cpp.classify(cpp_points, shape);
    EXPECT_EQ(std::memcmp(classes.data(), expected.data(), classes.size()), 0) << light.kind;
  }
}

TEST_F(CApi, SeesTheSameSamplesByTheSameOptions) {
  penumbra_points points = c_points(arrays);
  points.keys = c_rows(arrays.keys);
  points.has_offset = 1;
  points.offset = 0.125f;
  Points same_points = cpp_points;
  same_points.keys = rows_of(arrays.keys);
  same_points.offset = 0.125f;
  penumbra_ask_options options = c_options(70);
  options.method = PENUMBRA_METHOD_STOCHASTIC;
  options.light_index = 3;
  options.threads = 2;
  const AskOptions same_options{
      .shadow_samples = 70, .method = Method::stochastic, .light_index = 3, .threads = 2};
  std::vector<std::uint32_t> seen(3 * arrays.points.size()), expected(seen.size());
  const penumbra_light light = c_ball();
  penumbra_counters counters{};
  counters.struct_size = sizeof counters;
  expect_ok(
      penumbra_visible_samples(c, &points, &light, seen.data(), seen.size(), &options, &counters));
  const ShadowCounters cost = cpp.visible_samples(same_points, cpp_ball, expected, same_options);
  EXPECT_EQ(seen, expected);
  EXPECT_EQ(counters.rays, cost.rays);
  EXPECT_EQ(counters.tests, cost.tests);
  EXPECT_EQ(counters.lit + counters.penumbra + counters.umbra,
            cost.lit + cost.penumbra + cost.umbra);
  EXPECT_GT(counters.rays, 0u);
}

TEST_F(CApi, TakesKeysThatAreFinal) {
  const penumbra_light light = c_ball();
  penumbra_points points = c_points(arrays);
  std::vector<std::uint64_t> keys;
  for (std::size_t i = 0; i < arrays.points.size(); ++i) keys.push_back(penumbra_light_key(i, 3));
  penumbra_ask_options options = c_options();
  options.light_index = 3;
  std::vector<float> by_index(keys.size()), by_key(keys.size());
  expect_ok(penumbra_visible_fraction(c, &points, &light, by_index.data(), by_index.size(),
                                      &options, nullptr));
  points.keys = c_rows(keys);
  options.keys_are_final = 1;
  expect_ok(penumbra_visible_fraction(c, &points, &light, by_key.data(), by_key.size(), &options,
                                      nullptr));
  EXPECT_EQ(by_key, by_index);
}

TEST_F(CApi, TellsTheWholeVisibility) {
  const penumbra_points points = c_points(arrays);
  const penumbra_light light = c_ball();
  std::vector<penumbra_visibility_row> rows(arrays.points.size());
  expect_ok(penumbra_visibility(c, &points, &light, rows.data(), rows.size(), nullptr, nullptr));
  std::vector<Visibility> expected(rows.size());
  cpp.visibility(cpp_points, cpp_ball, expected);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i].fraction, expected[i].fraction);
    EXPECT_EQ(rows[i].cosine_weighted, expected[i].cosine_weighted);
    EXPECT_EQ(rows[i].shadow_class, static_cast<std::uint32_t>(expected[i].shadow_class));
    EXPECT_EQ(rows[i].rays, expected[i].rays);
  }
}

TEST_F(CApi, ListsTheSameBlockersAndAsManyAsThereIsRoomFor) {
  const penumbra_light light = c_ball();
  const Box box{{-1, 0, -1}, {1, 0.25f, 1}};
  const Vec3f point{0, 0, 0}, up{0, 1, 0};
  const Blockers of_point = cpp.blockers(point, up, cpp_ball), of_box = cpp.shaft(box, cpp_ball);
  ASSERT_GT(of_point.primitives.size(), 3u);
  std::vector<penumbra_primitive> found(of_box.primitives.size() + of_point.primitives.size());
  const auto expect_same = [&](const Blockers& blockers, std::uint32_t shadow_class) {
    EXPECT_EQ(shadow_class, static_cast<std::uint32_t>(blockers.shadow_class));
    for (std::size_t i = 0; i < blockers.primitives.size(); ++i) {
      const PrimitiveId id{found[i].geometry, found[i].primitive, found[i].instance};
      EXPECT_EQ(id, blockers.primitives[i]);
    }
  };
  std::uint32_t shadow_class = 9;
  std::size_t count = 0;
  expect_ok(penumbra_blockers(c, &point.x, &up.x, &light, &shadow_class, found.data(), found.size(),
                              &count));
  EXPECT_EQ(count, of_point.primitives.size());
  expect_same(of_point, shadow_class);
  expect_ok(penumbra_shaft(c, &box.lo.x, &box.hi.x, &light, &shadow_class, found.data(),
                           found.size(), &count));
  EXPECT_EQ(count, of_box.primitives.size());
  expect_same(of_box, shadow_class);

  found.assign(found.size(), {7, 7, 7});
  expect_ok(penumbra_blockers(c, &point.x, &up.x, &light, nullptr, found.data(), 2, &count));
  EXPECT_EQ(count, of_point.primitives.size());
  EXPECT_NE(found[1].primitive, 7u);
  EXPECT_EQ(found[2].primitive, 7u);
  expect_ok(penumbra_blockers(c, &point.x, nullptr, &light, &shadow_class, nullptr, 0, nullptr));
}

TEST_F(CApi, GivesTheWaysToSamples) {
  const Vec3f position{0.5f, 0, 0.25f};
  for (const auto& [light, shape] : all_lights()) {
    std::vector<Vec3f> ways(33);
    expect_ok(penumbra_light_samples(&light, &position.x, 17, 2, 0, &ways[0].x, ways.size()));
    std::vector<Vec3f> same(ways.size());
    expect_ok(penumbra_light_samples(&light, &position.x, penumbra_light_key(17, 2), 0, 1,
                                     &same[0].x, same.size()));
    EXPECT_TRUE(same == ways && same_bits(ways, light_samples(shape, position, 17, 33, 2)));
  }
}

TEST_F(CApi, TellsTheSameFacts) {
  Box box;
  std::uint64_t bytes = 0;
  expect_ok(penumbra_bounds(c, &box.lo.x, &box.hi.x));
  expect_ok(penumbra_memory_bytes(c, &bytes));
  EXPECT_EQ(box.lo, cpp.bounds().lo);
  EXPECT_EQ(box.hi, cpp.bounds().hi);
  EXPECT_EQ(bytes, cpp.memory_bytes());
  penumbra_commit_options options;
  expect_ok(penumbra_default_commit_options(&options, sizeof options));
  EXPECT_EQ(options.may_refit, 1u);
  options.may_refit = 0;
  penumbra_commit_report report{};
  report.struct_size = sizeof report;
  expect_ok(penumbra_commit(c, &options, &report));
  EXPECT_EQ(report.primitives, arrays.triangles.size() + 3 + 1 + 1 + 3);
  EXPECT_EQ(report.degenerate_triangles, 0u);
  EXPECT_EQ(report.is_refitted, 0u);
}

TEST_F(CApi, NumbersPartsByTheLowerHalfOfTheirHandles) {
  EXPECT_EQ(static_cast<std::uint32_t>(mesh.id), 0u);
  EXPECT_EQ(static_cast<std::uint32_t>(disk.id), 3u);
  EXPECT_EQ(static_cast<std::uint32_t>(group.id), 0u);
  EXPECT_EQ(static_cast<std::uint32_t>(instance.id), 0u);
}

TEST_F(CApi, MovesAndRemovesWhatWasAdded) {
  std::vector<float> before = c_fractions(c_ball());
  std::vector<Vec3f> elsewhere = arrays.centers;
  for (Vec3f& center : elsewhere) center.x += 1;
  expect_ok(penumbra_move_geometry(c, balls, c_rows(elsewhere)));
  cpp.update(GeometryId{1}, rows_of(elsewhere));
  expect_changed(before);

  before = c_fractions(c_ball());
  for (Vertex& vertex : arrays.vertices) vertex.position.z += 0.5f;
  expect_changed(before);

  before = c_fractions(c_ball());
  double moved[12];
  std::copy(placement, placement + 12, moved);
  moved[3] = -2;
  Transform same = transform;
  same.offset.x = -2;
  expect_ok(penumbra_move_instance(c, instance, moved));
  cpp.update(InstanceId{0}, same);
  expect_changed(before);

  before = c_fractions(c_ball());
  arrays.radii = {0.25f, 0.5f, 0.5f};
  expect_changed(before);

  before = c_fractions(c_ball());
  expect_ok(penumbra_move_group(c, group, group_balls, c_rows(elsewhere)));
  cpp.update(GroupId{0}, GeometryId{0}, rows_of(elsewhere));
  expect_changed(before);

  before = c_fractions(c_ball());
  expect_ok(penumbra_remove_instance(c, instance));
  expect_ok(penumbra_remove_group(c, group));
  expect_ok(penumbra_remove_geometry(c, mesh));
  cpp.remove(InstanceId{0});
  cpp.remove(GroupId{0});
  cpp.remove(GeometryId{0});
  expect_changed(before);
}

TEST_F(CApi, ReadsRowsBackwardsAndOneForAll) {
  const std::vector<float> seen = c_fractions(c_ball());
  penumbra_points points = c_points(arrays);
  const Vec3f up{0, 1, 0};
  points.positions = {&arrays.points.back(), arrays.points.size(), -12};
  points.normals = {&up, arrays.points.size(), PENUMBRA_STRIDE_REPEAT};
  std::vector<std::uint64_t> keys(arrays.points.size());
  for (std::size_t i = 0; i < keys.size(); ++i) keys[i] = keys.size() - 1 - i;
  points.keys = c_rows(keys);
  std::vector<float> backwards(seen.size());
  const penumbra_light light = c_ball();
  expect_ok(penumbra_visible_fraction(c, &points, &light, backwards.data(), backwards.size(),
                                      nullptr, nullptr));
  EXPECT_TRUE(std::equal(seen.begin(), seen.end(), backwards.rbegin()));
}

TEST_F(CApi, TellsProgressAndIsCancelled) {
  struct Watch {
    int calls = 0, end_after = 0;
    double last = -1;
  };
  const auto watch = [](void* user, double share) {
    Watch& told = *static_cast<Watch*>(user);
    EXPECT_GE(share, told.last);
    told.last = share;
    return ++told.calls == told.end_after ? 0 : 1;
  };
  const penumbra_points points = c_points(arrays);
  const penumbra_light light = c_ball();
  std::vector<float> seen(arrays.points.size());
  penumbra_ask_options options = c_options();
  Watch whole;
  options.progress = watch;
  options.progress_user = &whole;
  expect_ok(
      penumbra_visible_fraction(c, &points, &light, seen.data(), seen.size(), &options, nullptr));
  EXPECT_GT(whole.calls, 0);
  EXPECT_EQ(whole.last, 1);
  Watch cut{.end_after = 1};
  options.progress_user = &cut;
  EXPECT_EQ(
      penumbra_visible_fraction(c, &points, &light, seen.data(), seen.size(), &options, nullptr),
      PENUMBRA_ERROR_CANCELLED);
  EXPECT_EQ(cut.calls, 1);
}

TEST_F(CApi, TakesReleasedShapesAsAGroup) {
  const std::vector<float> before = c_fractions(c_ball());
  penumbra_occluders shapes{};
  expect_ok(penumbra_create(&shapes));
  penumbra_geometry one{};
  expect_ok(penumbra_add_spheres(shapes, c_rows(arrays.centers), c_rows(arrays.radii), &one));
  penumbra_group short_lived{};
  expect_ok(penumbra_add_group(c, shapes, &short_lived));
  expect_ok(penumbra_release(shapes));
  double identity[12]{1, 0, 0, 0, 0, 1, 0, 2, 0, 0, 1, 0};
  penumbra_instance placed{};
  expect_ok(penumbra_add_instance(c, short_lived, identity, &placed));
  expect_ok(penumbra_commit(c, nullptr, nullptr));
  EXPECT_FALSE(same_bits(c_fractions(c_ball()), before));
}

TEST_F(CApi, AnswersManyThreadsAtOnceAlsoWhileReleased) {
  const std::vector<float> expected = cpp_fractions(cpp_ball);
  penumbra_occluders scene{};
  expect_ok(penumbra_create(&scene));
  penumbra_geometry added{};
  expect_ok(penumbra_add_triangles(scene, c_positions(arrays), c_rows(arrays.triangles), &added));
  expect_ok(penumbra_commit(scene, nullptr, nullptr));
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t)
    threads.emplace_back([&] {
      const penumbra_points points = c_points(arrays);
      const penumbra_light light = c_ball();
      std::vector<float> first(arrays.points.size()), seen(first.size());
      penumbra_error code = PENUMBRA_OK;
      for (int round = 0; round < 1000 && code == PENUMBRA_OK; ++round) {
        code = penumbra_visible_fraction(scene, &points, &light, seen.data(), seen.size(), nullptr,
                                         nullptr);
        if (round == 0) first = seen;
        EXPECT_TRUE(code != PENUMBRA_OK || same_bits(seen, first));
      }
      EXPECT_TRUE(code == PENUMBRA_OK || code == PENUMBRA_ERROR_INVALID_HANDLE);
    });
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  expect_ok(penumbra_release(scene));
  for (std::thread& thread : threads) thread.join();
}

}  // namespace
}  // namespace penumbra
