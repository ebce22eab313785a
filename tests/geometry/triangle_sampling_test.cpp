// SPDX-License-Identifier: MIT
#include "penumbra/geometry/triangle_sampling.h"

#include "penumbra/geometry/light_sampling.h"
#include "tests/geometry/chi_squared.h"
#include "tests/geometry/light_shapes.h"
#include "tests/geometry/sample_counts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace penumbra {
namespace {

constexpr double limit = 3.9;
constexpr int side = 8;

/// The triangles that a light is sampled on, each cut into side x side cells.
struct Cells {
  std::vector<SeenTriangle> triangles;

  /// Cell (i, j): from i to i + 1 of the way from `corner` to the other side, from j to j + 1
  /// along.
  double angle(const SeenTriangle& t, int i, int j) const {
    const auto at = [&](int a, int b) {
      const double out = double(a) / side, along = double(b) / side;
      return t.corner + (t.to_second * (1 - along) + t.to_third * along) * out;
    };
    const Vec3d a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
    return solid_angle(SeenTriangle{a, b - a, c - a}) + solid_angle(SeenTriangle{a, c - a, d - a});
  }

  std::vector<double> angles() const {
    std::vector<double> result;
    for (const SeenTriangle& t : triangles)
      for (int i = 0; i < side; ++i)
        for (int j = 0; j < side; ++j) result.push_back(angle(t, i, j));
    return result;
  }

  std::vector<double> areas() const {
    std::vector<double> result;
    for (const SeenTriangle& t : triangles)
      for (int i = 0; i < side; ++i)
        for (int j = 0; j < side; ++j)
          result.push_back(length(cross(t.to_second, t.to_third)) * (2 * i + 1));
    return result;
  }

  std::size_t bin_of(Vec3d way) const {
    std::size_t best = 0;
    double least = INFINITY;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      const double distance = distance_to_triangle(way, triangles[i].corners());
      if (distance < least) least = distance, best = i;
    }
    const SeenTriangle& t = triangles[best];
    const Vec3d w = way - t.corner, n = cross(t.to_second, t.to_third);
    const double b = dot(cross(w, t.to_third), n) / length_squared(n);
    const double c = dot(cross(t.to_second, w), n) / length_squared(n);
    const auto place = [](double x) {
      return static_cast<std::size_t>(std::clamp(x * side, 0.0, side - 1.0));
    };
    return (best * side + place(b + c)) * side + place(c / (b + c));
  }
};

double deviate(const LightShape& light, Vec3f p, const Cells& cells,
               const std::vector<double>& shares) {
  const auto bin_of = [&](Vec3d way) { return cells.bin_of(way); };
  return chi_squared_deviate(sample_counts(light, p, 4, shares.size(), 100'000, bin_of), shares);
}

Cells cells_of(const auto& light, Vec3f p, const auto& is_wanted) {
  Cells cells;
  for (std::size_t i = 0; i < triangle_count(light); ++i)
    if (const SeenTriangle t = seen_triangle(light, i, p); is_wanted(t))
      cells.triangles.push_back(t);
  return cells;
}

double polygon_deviate(const PolygonLight& light, Vec3f p) {
  const Cells cells = cells_of(light, p, [](const SeenTriangle&) { return true; });
  return deviate(light, p, cells, cells.angles());
}

TEST(TriangleSampling, PolygonsAreUniformInSolidAngle) {
  const PolygonLight hexagon = polygon_around({0, 0, 2}, {1, 0, 0}, {0, 1, 0}, 6);
  EXPECT_LT(std::abs(polygon_deviate(hexagon, {0, 0, 0})), limit) << "straight above";
  EXPECT_LT(std::abs(polygon_deviate(hexagon, {0.3f, 0.2f, 1.9f})), limit) << "near";
  EXPECT_LT(std::abs(polygon_deviate(hexagon, {-3, 2, 4})), limit) << "oblique, behind";
  EXPECT_LT(std::abs(polygon_deviate(hexagon, {1.2f, 0, 1.97f})), limit) << "grazing";
  EXPECT_LT(std::abs(polygon_deviate(hexagon, {0, 0, -998})), limit) << "far";
  const PolygonLight triangle{{0, 0, 0}, {{-1, -1, 0}, {2, -1, 0}, {-1, 2, 0}}};
  EXPECT_LT(std::abs(polygon_deviate(triangle, {0.5f, 0, 1})), limit) << "triangle";
  const PolygonLight turned = polygon_around({1, 2, 3}, {0.4f, 0, 1}, {0, 2, 0.1f}, 5);
  EXPECT_LT(std::abs(polygon_deviate(turned, {0, 1, 2})), limit) << "turned";
}

TEST(TriangleSampling, EdgeOnAndTouchedPolygonsAreSampledByArea) {
  const PolygonLight hexagon = polygon_around({0, 0, 2}, {1, 0, 0}, {0, 1, 0}, 6);
  for (const Vec3f p : {Vec3f(3, 0, 2), Vec3f(0.25f, 0.125f, 2)}) {
    const Cells cells = cells_of(hexagon, p, [](const SeenTriangle&) { return true; });
    EXPECT_LT(std::abs(deviate(hexagon, p, cells, cells.areas())), limit);
  }
}

TEST(TriangleSampling, MeshesAreUniformOverTheirFacingTriangles) {
  const MeshLight box = box_around({1, 2, 3}, {1, 0.5f, 0.25f});
  for (const Vec3f p :
       {Vec3f(0, 0, 0), Vec3f(1, 2, 3.5f), Vec3f(3, 2.125f, 2.9f), Vec3f(40, -20, 7)}) {
    const Cells cells = cells_of(box, p, [](const SeenTriangle& t) { return t.volume() < 0; });
    EXPECT_LE(cells.triangles.size(), 6u);
    EXPECT_LT(std::abs(deviate(box, p, cells, cells.angles())), limit) << p.x;
  }
}

TEST(TriangleSampling, InsideAMeshDirectionsAreUniform) {
  const MeshLight box = box_around({1, 2, 3}, {1, 0.5f, 0.25f});
  const Cells cells = cells_of(box, {1.5f, 2, 3.125f}, [](const SeenTriangle&) { return true; });
  EXPECT_LT(std::abs(deviate(box, {1.5f, 2, 3.125f}, cells, cells.angles())), limit);
}

TEST(TriangleSampling, LiesOnTheSideOfTheMeshThatPSees) {
  const MeshLight box = box_around({0, 0, 5}, {1, 1, 1});
  LightSamples samples;
  sample_light(box, {0.25f, 0.5f, 0}, SamplePattern(256), 1, samples);
  for (int i = 0; i < 256; ++i) EXPECT_NEAR(samples.z[i], 4, 1e-6);
}

double distance_from(const auto& light, Vec3d l) {
  double nearest = INFINITY;
  for (std::size_t i = 0; i < triangle_count(light); ++i)
    nearest = std::min(nearest, distance_to_triangle(l, seen_triangle(light, i, {}).corners()));
  return nearest;
}

TEST(TriangleSampling, LiesOnTheLight) {
  const SamplePattern pattern(32);
  LightSamples samples;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> exponent(-20, 20);
  std::normal_distribution<double> normal;
  const auto check = [&](const auto& light, double size) {
    for (std::uint64_t key = 0; key < 1000; ++key) {
      const Vec3d way(normal(random), normal(random), normal(random));
      const Vec3f p(Vec3d(light.center) + way * std::exp2(exponent(random)));
      sample_light(light, p, pattern, key, samples);
      const double distance = length(Vec3d(p) - Vec3d(light.center));
      const double ulp = 0x1p-23 * (length(Vec3d(p)) + distance + size);
      for (int i = 0; i < 32; ++i) {
        const Vec3d l = Vec3d(p) + Vec3d(samples.x[i], samples.y[i], samples.z[i]);
        ASSERT_LE(distance_from(light, l), 2 * ulp) << "key " << key << ", sample " << i;
      }
    }
  };
  check(polygon_around({1, 2, 3}, {1, 0, 0}, {0, 3, 0}, 7), 3);
  check(polygon_around({-300, 2e5f, 3}, {1, 0, 0}, {0, 3, 0.5f}, 5), 3);
  check(polygon_around({1, 2, 3}, {1e4f, 0, 0}, {0, 1e-4f, 0}, 5), 1e4);
  check(box_around({1, 2, 3}, {1, 0.5f, 0.25f}), 1.2);
  check(box_around({1, 2, 3}, {1e5f, 1e-2f, 3}), 1e5);
}

TEST(TriangleSampling, DegeneratePlacesGiveFiniteSamples) {
  const SamplePattern pattern(64);
  LightSamples samples;
  const std::vector<LightShape> lights = {
      polygon_around({1, 2, 3}, {1, 0, 0}, {0, 1, 0}, 6),
      polygon_around({1, 2, 3}, {1e-30f, 0, 0}, {0, 1e-30f, 0}, 3),
      polygon_around({1, 2, 3}, {1e15f, 0, 0}, {0, 1e15f, 0}, 4),
      box_around({1, 2, 3}, {1, 1, 1}),
      PolygonLight{{1, 2, 3}, {}},
      MeshLight{{1, 2, 3}, {}, {}},
      PolygonLight{{1, 2, 3}, {{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}}};
  for (const LightShape& light : lights)
    for (const Vec3f p : {Vec3f(1, 2, 3), Vec3f(2, 2, 3), Vec3f(2, 3, 4), Vec3f(1, 2, 4),
                          Vec3f(2, 2, std::nextafter(3.f, 4.f)), Vec3f(9, 2, 3),
                          Vec3f(2, 3, std::nextafter(4.f, 5.f)), Vec3f(2, 3, 9), Vec3f(1e18f, 0, 0),
                          Vec3f(-3e38f, 3e38f, 3e38f)}) {
      sample_light(light, p, pattern, 1, samples);
      for (std::size_t i = 0; i < samples.x.size(); ++i)
        ASSERT_TRUE(is_finite(Vec3f(samples.x[i], samples.y[i], samples.z[i])));
    }
}

TEST(TriangleSampling, PaddingRepeatsTheLastSample) {
  LightSamples samples;
  for (const LightShape& light :
       {LightShape(polygon_around({1, 2, 3}, {1, 0, 0}, {0, 1, 0}, 6)),
        LightShape(box_around({1, 2, 3}, {1, 1, 1})), LightShape(DiskLight{{1, 2, 3}}),
        LightShape(LineLight{{1, 2, 3}, {1, 0, 0}})}) {
    sample_light(light, {}, SamplePattern(5), 3, samples);
    for (std::size_t i = 5; i < samples.x.size(); ++i)
      EXPECT_EQ(Vec3f(samples.x[i], samples.y[i], samples.z[i]),
                Vec3f(samples.x[4], samples.y[4], samples.z[4]));
  }
}

}  // namespace
}  // namespace penumbra
