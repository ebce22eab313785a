// SPDX-License-Identifier: MIT
// Every misuse of the C API has its code and its message, and changes nothing.
#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <limits>
#include <new>
#include <stdexcept>
#include <string>
#include <thread>

#include "tests/visibility/c_api_scene.h"

namespace penumbra {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

/// That the call that came to `code` told `part`.
void expect_error(penumbra_error code, penumbra_error expected, const std::string& part) {
  EXPECT_EQ(code, expected);
  EXPECT_EQ(penumbra_last_error(), expected);
  const std::string message = penumbra_last_error_message();
  EXPECT_NE(message.find(part), std::string::npos) << message;
}

void expect_invalid(penumbra_error code, const std::string& part) {
  expect_error(code, PENUMBRA_ERROR_INVALID_ARGUMENT, part);
}

void expect_bad_handle(penumbra_error code, const std::string& part) {
  expect_error(code, PENUMBRA_ERROR_INVALID_HANDLE, part);
}

/// Spheres that were committed, and a question of them.
class CApiMisuse : public testing::Test {
 protected:
  void SetUp() override {
    penumbra_add_spheres(scene, c_rows(arrays.centers), c_rows(arrays.radii), &balls);
    penumbra_add_group(scene, shapes, &group);
    penumbra_add_instance(scene, group, identity, &instance);
    ASSERT_EQ(penumbra_commit(scene, nullptr, nullptr), PENUMBRA_OK);
    seen.resize(arrays.points.size());
    penumbra_last_error();
  }

  penumbra_error ask(penumbra_occluders of) {
    return penumbra_visible_fraction(of, &points, &light, seen.data(), seen.size(), &options,
                                     nullptr);
  }

  CallersArrays arrays;
  CScene scene, shapes;
  penumbra_geometry balls{}, other{};
  penumbra_group group{}, other_group{};
  penumbra_instance instance{}, other_instance{};
  double identity[12]{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
  penumbra_points points = c_points(arrays);
  penumbra_light light = c_ball();
  penumbra_ask_options options = c_options();
  std::vector<float> seen;
};

TEST_F(CApiMisuse, QuestionsBeforeTheFirstCommitAreRefused) {
  expect_error(ask(shapes), PENUMBRA_ERROR_INVALID_OPERATION, "never committed");
  const Vec3f p;
  expect_error(penumbra_blockers(shapes, &p.x, nullptr, &light, nullptr, nullptr, 0, nullptr),
               PENUMBRA_ERROR_INVALID_OPERATION, "penumbra_blockers: ");
  std::uint64_t bytes = 0;
  expect_error(penumbra_memory_bytes(shapes, &bytes), PENUMBRA_ERROR_INVALID_OPERATION,
               "call penumbra_commit first");
}

TEST_F(CApiMisuse, ReleasedOccludersAreNoMore) {
  penumbra_occluders gone{};
  ASSERT_EQ(penumbra_create(&gone), PENUMBRA_OK);
  ASSERT_EQ(penumbra_release(gone), PENUMBRA_OK);
  expect_bad_handle(penumbra_release(gone), "released");
  expect_bad_handle(ask(gone), "penumbra_visible_fraction: ");
  expect_bad_handle(penumbra_commit(gone, nullptr, nullptr), "released");
  expect_bad_handle(penumbra_add_group(scene, gone, &other_group), "released");
  expect_bad_handle(penumbra_set_error_function(gone, nullptr, nullptr), "released");
  penumbra_occluders next{};
  ASSERT_EQ(penumbra_create(&next), PENUMBRA_OK);
  expect_bad_handle(penumbra_commit(gone, nullptr, nullptr), "released");
  penumbra_release(next);
}

TEST_F(CApiMisuse, HandlesThatWereNeverGivenAreRefused) {
  for (const std::uint64_t garbage : {0ull, 1ull, 0x7fffdeadbeefull, ~0ull, 0x1ull << 63})
    expect_bad_handle(penumbra_commit({garbage}, nullptr, nullptr), "never gave");
  expect_bad_handle(penumbra_commit({penumbra_occluders(scene).id + 1000}, nullptr, nullptr),
                    "never created");
  expect_bad_handle(penumbra_remove_geometry(scene, {balls.id + 1}), "never gave");
}

TEST_F(CApiMisuse, HandlesOfAnotherKindAreRefused) {
  expect_bad_handle(penumbra_commit({balls.id}, nullptr, nullptr),
                    "the handle of a geometry in the place of occluders");
  expect_bad_handle(penumbra_remove_geometry(scene, {instance.id}), "the handle of an instance");
  expect_bad_handle(penumbra_add_instance(scene, {balls.id}, identity, &other_instance),
                    "in the place of a group");
  expect_bad_handle(penumbra_move_instance(scene, {group.id}, identity), "the handle of a group");
}

TEST_F(CApiMisuse, HandlesOfOtherOccludersAreRefused) {
  ASSERT_EQ(penumbra_add_spheres(shapes, c_rows(arrays.centers), c_rows(arrays.radii), &other),
            PENUMBRA_OK);
  expect_bad_handle(penumbra_remove_geometry(scene, other), "of other occluders");
  expect_bad_handle(penumbra_move_group(scene, group, balls, {}), "of other occluders");
}

TEST_F(CApiMisuse, WhatWasRemovedIsNoMore) {
  expect_invalid(penumbra_remove_group(scene, group), "penumbra_remove_group: ");  // placed
  ASSERT_EQ(penumbra_remove_instance(scene, instance), PENUMBRA_OK);
  ASSERT_EQ(penumbra_remove_group(scene, group), PENUMBRA_OK);
  ASSERT_EQ(penumbra_remove_geometry(scene, balls), PENUMBRA_OK);
  expect_bad_handle(penumbra_remove_instance(scene, instance), "that was removed");
  expect_bad_handle(penumbra_move_instance(scene, instance, identity), "that was removed");
  expect_bad_handle(penumbra_remove_group(scene, group), "that was removed");
  expect_bad_handle(penumbra_add_instance(scene, group, identity, &other_instance), "removed");
  expect_bad_handle(penumbra_remove_geometry(scene, balls), "that was removed");
  expect_bad_handle(penumbra_move_geometry(scene, balls, c_rows(arrays.centers)), "removed");
  ASSERT_EQ(penumbra_add_spheres(scene, c_rows(arrays.centers), c_rows(arrays.radii), &other),
            PENUMBRA_OK);
  EXPECT_NE(other.id, balls.id);
}

TEST_F(CApiMisuse, EachHandleIsReleasedOnceByManyThreads) {
  for (int round = 0; round < 50; ++round) {
    penumbra_occluders shared{};
    ASSERT_EQ(penumbra_create(&shared), PENUMBRA_OK);
    std::array<penumbra_error, 4> codes{};
    std::vector<std::thread> threads;
    for (penumbra_error& code : codes)
      threads.emplace_back([&] { code = penumbra_release(shared); });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(std::count(codes.begin(), codes.end(), PENUMBRA_OK), 1);
    EXPECT_EQ(std::count(codes.begin(), codes.end(), PENUMBRA_ERROR_INVALID_HANDLE), 3);
  }
}

TEST_F(CApiMisuse, NullIsRefused) {
  expect_invalid(penumbra_create(nullptr), "out is NULL");
  expect_invalid(penumbra_add_spheres(scene, c_rows(arrays.centers), c_rows(arrays.radii), nullptr),
                 "out is NULL");
  expect_invalid(penumbra_add_spheres(scene, {nullptr, 3, 0}, c_rows(arrays.radii), &other),
                 "centers has NULL for data and a count of 3");
  expect_invalid(penumbra_add_instance(scene, group, nullptr, &other_instance),
                 "placement is NULL");
  const std::size_t count = seen.size();
  expect_invalid(
      penumbra_visible_fraction(scene, nullptr, &light, seen.data(), count, nullptr, nullptr),
      "points is NULL");
  expect_invalid(
      penumbra_visible_fraction(scene, &points, nullptr, seen.data(), count, nullptr, nullptr),
      "light is NULL");
  expect_invalid(
      penumbra_visible_fraction(scene, &points, &light, nullptr, count, nullptr, nullptr),
      "out is NULL");
  const Vec3f p;
  expect_invalid(penumbra_blockers(scene, nullptr, nullptr, &light, nullptr, nullptr, 0, nullptr),
                 "position is NULL");
  expect_invalid(penumbra_blockers(scene, &p.x, nullptr, &light, nullptr, nullptr, 4, nullptr),
                 "out is NULL");
  expect_invalid(penumbra_shaft(scene, &p.x, nullptr, &light, nullptr, nullptr, 0, nullptr),
                 "hi is NULL");
  expect_invalid(penumbra_light_samples(&light, &p.x, 0, 0, 0, nullptr, 4), "out is NULL");
  expect_invalid(penumbra_bounds(scene, nullptr, nullptr), "lo is NULL");
  expect_invalid(penumbra_memory_bytes(scene, nullptr), "out is NULL");
  expect_invalid(penumbra_default_ask_options(nullptr, sizeof options), "options is NULL");
}

TEST_F(CApiMisuse, NullWithoutCountIsAnEmptyArray) {
  EXPECT_EQ(penumbra_add_spheres(scene, {}, {}, &other), PENUMBRA_OK);
  EXPECT_EQ(penumbra_commit(scene, nullptr, nullptr), PENUMBRA_OK);
  points.positions = points.normals = {};
  EXPECT_EQ(penumbra_visible_fraction(scene, &points, &light, nullptr, 0, nullptr, nullptr),
            PENUMBRA_OK);
}

TEST_F(CApiMisuse, CountsThatDisagreeAreRefused) {
  arrays.radii.pop_back();
  expect_invalid(penumbra_add_spheres(scene, c_rows(arrays.centers), c_rows(arrays.radii), &other),
                 "penumbra_add_spheres: ");
  points.normals.count -= 1;
  expect_invalid(ask(scene), "penumbra_visible_fraction: ");
  points = c_points(arrays);
  const std::size_t count = seen.size() - 1;
  expect_invalid(
      penumbra_visible_fraction(scene, &points, &light, seen.data(), count, nullptr, nullptr),
      "penumbra_visible_fraction: ");
  std::vector<penumbra_visibility_row> rows(count);
  expect_invalid(penumbra_visibility(scene, &points, &light, rows.data(), count, nullptr, nullptr),
                 "out has room for 399 rows, but there are 400 points");
}

TEST_F(CApiMisuse, ArraysBeyondMemoryAreRefused) {
  const auto expect_beyond = [&](std::size_t count, std::ptrdiff_t stride) {
    expect_invalid(penumbra_add_spheres(scene, {arrays.centers.data(), count, stride},
                                        c_rows(arrays.radii), &other),
                   "beyond all memory");
  };
  expect_beyond(SIZE_MAX, 0);
  expect_beyond(3, PTRDIFF_MAX);
  expect_beyond(2, PTRDIFF_MIN + 1);
  expect_beyond(std::size_t{1} << 40, std::ptrdiff_t{1} << 30);
}

TEST_F(CApiMisuse, OutputThatIsNotAlignedIsRefused) {
  auto* const crooked = reinterpret_cast<float*>(reinterpret_cast<std::uintptr_t>(seen.data()) + 1);
  expect_invalid(
      penumbra_visible_fraction(scene, &points, &light, crooked, seen.size(), nullptr, nullptr),
      "out is not aligned");
}

TEST_F(CApiMisuse, StructsOfUnknownSizeAreRefused) {
  options.struct_size = 0;
  expect_invalid(ask(scene), "options has a struct_size of 0 instead of");
  options = c_options();
  points.struct_size += 8;
  expect_invalid(ask(scene), "or use the library of your header or later");
  points = c_points(arrays);
  light.struct_size = 4;
  expect_invalid(ask(scene), "light has a struct_size of 4");
  light = c_ball();
  penumbra_counters counters{};
  expect_invalid(penumbra_visible_fraction(scene, &points, &light, seen.data(), seen.size(),
                                           nullptr, &counters),
                 "counters has a struct_size of 0");
  penumbra_commit_report report{};
  expect_invalid(penumbra_commit(scene, nullptr, &report), "report has a struct_size of 0");
  expect_invalid(penumbra_default_ask_options(&options, 8), "struct_size of 8");
}

TEST_F(CApiMisuse, ConstantsThatAreNoneAreRefused) {
  options.method = 7;
  expect_invalid(ask(scene), "there is no method 7");
  options = c_options();
  light.kind = 0;
  expect_invalid(ask(scene), "there is no kind of light 0");
  light = c_ball();
  points.has_offset = 2;
  expect_invalid(ask(scene), "points.has_offset");
  expect_invalid(penumbra_add_cones(scene, {}, {}, {}, {}, 2, &other), "caps is neither");
  penumbra_commit_options commit_options{sizeof commit_options, 2};
  expect_invalid(penumbra_commit(scene, &commit_options, nullptr), "may_refit");
}

TEST_F(CApiMisuse, NumbersThatCannotBeMeantAreRefused) {
  for (const std::uint32_t d : {0u, 65537u, ~0u}) {
    options = c_options(d);
    expect_invalid(ask(scene), "penumbra_visible_fraction: ");
  }
  options = c_options();
  for (const float radius : {nan, 0.0f, -1.0f, std::numeric_limits<float>::infinity()}) {
    light.radius = radius;
    expect_invalid(ask(scene), "radius");
  }
  light = c_light(PENUMBRA_LIGHT_SUN);
  light.diameter_deg = 180;
  expect_invalid(ask(scene), "angular diameter");
  light = c_light(PENUMBRA_LIGHT_POLYGON);
  expect_invalid(ask(scene), "fewer than 3 corners");
  light = c_light(PENUMBRA_LIGHT_HULL);
  expect_invalid(ask(scene), "enclose no volume");
  identity[0] = double(nan);
  ASSERT_EQ(penumbra_move_instance(scene, instance, identity), PENUMBRA_OK);
  expect_invalid(penumbra_commit(scene, nullptr, nullptr), "penumbra_commit: instance 0");
}

TEST_F(CApiMisuse, ACommitThatFailsKeepsWhatWasCommittedBefore) {
  ASSERT_EQ(ask(scene), PENUMBRA_OK);
  const std::vector<float> before = seen;
  arrays.centers[1].y = nan;
  expect_invalid(penumbra_commit(scene, nullptr, nullptr), "penumbra_commit: ");
  ASSERT_EQ(ask(scene), PENUMBRA_OK);
  EXPECT_EQ(seen, before);

  arrays.centers[1].y = 1.5f;
  arrays.triangles[5][1] = 64;
  penumbra_geometry mesh{};
  ASSERT_EQ(penumbra_add_triangles(scene, c_positions(arrays), c_rows(arrays.triangles), &mesh),
            PENUMBRA_OK);
  expect_invalid(penumbra_commit(scene, nullptr, nullptr), "penumbra_commit: ");
  ASSERT_EQ(penumbra_remove_geometry(scene, mesh), PENUMBRA_OK);
  ASSERT_EQ(penumbra_commit(scene, nullptr, nullptr), PENUMBRA_OK);
  ASSERT_EQ(ask(scene), PENUMBRA_OK);
  EXPECT_EQ(seen, before);
}

TEST_F(CApiMisuse, TheLastErrorIsTheThreadsOwnAndAskedOnce) {
  EXPECT_EQ(penumbra_create(nullptr), PENUMBRA_ERROR_INVALID_ARGUMENT);
  std::thread([] {
    EXPECT_EQ(penumbra_last_error(), PENUMBRA_OK);
    EXPECT_STREQ(penumbra_last_error_message(), "");
  }).join();
  EXPECT_EQ(ask(scene), PENUMBRA_OK);  // takes nothing back
  EXPECT_EQ(penumbra_last_error(), PENUMBRA_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(penumbra_last_error(), PENUMBRA_OK);
  EXPECT_STREQ(penumbra_last_error_message(), "penumbra_create: out is NULL");
}

struct Told {
  penumbra_error code = PENUMBRA_OK;
  std::string message;
  int times = 0;
};

void tell(void* user, penumbra_error code, const char* message) {
  Told& told = *static_cast<Told*>(user);
  told = {code, message, told.times + 1};
}

TEST_F(CApiMisuse, ErrorFunctionsAreToldOfTheErrorsOfTheirOccluders) {
  Told of_scene, of_rest;
  ASSERT_EQ(penumbra_set_error_function(scene, tell, &of_scene), PENUMBRA_OK);
  ASSERT_EQ(penumbra_set_error_function({}, tell, &of_rest), PENUMBRA_OK);
  EXPECT_NE(penumbra_bounds(scene, nullptr, nullptr), PENUMBRA_OK);
  EXPECT_EQ(of_scene.code, PENUMBRA_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(of_scene.message, "penumbra_bounds: lo is NULL");
  EXPECT_EQ(of_rest.times, 0);
  EXPECT_NE(penumbra_bounds(shapes, nullptr, nullptr), PENUMBRA_OK);
  EXPECT_NE(penumbra_create(nullptr), PENUMBRA_OK);
  EXPECT_NE(penumbra_release({42}), PENUMBRA_OK);
  EXPECT_EQ(of_rest.times, 3);
  EXPECT_EQ(of_scene.times, 1);
  penumbra_set_error_function({}, nullptr, nullptr);
  EXPECT_NE(penumbra_create(nullptr), PENUMBRA_OK);
  EXPECT_EQ(of_rest.times, 3);
}

TEST_F(CApiMisuse, ErrorFunctionsMayCallAndThrow) {
  const auto call_and_throw = [](void* user, penumbra_error, const char*) {
    penumbra_release({*static_cast<std::uint64_t*>(user)});
    throw std::runtime_error("lost");
  };
  penumbra_occluders own{};
  ASSERT_EQ(penumbra_create(&own), PENUMBRA_OK);
  ASSERT_EQ(penumbra_set_error_function(own, call_and_throw, &own.id), PENUMBRA_OK);
  expect_error(penumbra_memory_bytes(own, nullptr), PENUMBRA_ERROR_INVALID_OPERATION, "commit");
  expect_bad_handle(penumbra_release(own), "released");
}

TEST_F(CApiMisuse, CallsFromAProgressFunctionAreRefused) {
  struct Call {
    penumbra_occluders of;
    penumbra_error code;
  } call{scene, PENUMBRA_OK};
  options.progress_user = &call;
  options.progress = [](void* user, double) {
    Call& made = *static_cast<Call*>(user);
    made.code = penumbra_commit(made.of, nullptr, nullptr);
    return 1;
  };
  EXPECT_EQ(ask(scene), PENUMBRA_OK);
  EXPECT_EQ(call.code, PENUMBRA_ERROR_INVALID_OPERATION);
  options.progress = nullptr;
  EXPECT_EQ(ask(scene), PENUMBRA_OK);
  EXPECT_EQ(penumbra_commit(scene, nullptr, nullptr), PENUMBRA_OK);
}

TEST_F(CApiMisuse, WhatCallbacksThrowEndsAtTheBoundary) {
  options.progress = [](void*, double) -> int { throw std::runtime_error("from the callback"); };
  expect_error(ask(scene), PENUMBRA_ERROR_INTERNAL, "from the callback");
  options.progress = [](void*, double) -> int { throw 7; };
  expect_error(ask(scene), PENUMBRA_ERROR_INTERNAL, "a callback threw");
  options.progress = [](void*, double) -> int { throw std::bad_alloc(); };
  expect_error(ask(scene), PENUMBRA_ERROR_OUT_OF_MEMORY, "out of memory");
}

}  // namespace
}  // namespace penumbra
