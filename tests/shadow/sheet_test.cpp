// SPDX-License-Identifier: MIT
#include "penumbra/shadow/sheet.h"

#include <gtest/gtest.h>

#include <limits>
#include <memory>

#include "penumbra/kernel/kernel.h"
#include "tests/shadow/group_trials.h"
#include "tests/shadow/sheet_meshes.h"

namespace penumbra {
namespace {

using Member = TriangleSheet::Member;

/// A mesh, its sheet, and where its triangles went.
struct Sheet {
  explicit Sheet(const Mesh& mesh, std::vector<bool> clear = {})
      : shapes{{}, {}, {}, {mesh}},
        kernel(shapes, {KernelKind::wide, std::move(clear)}),
        sheet(shapes, kernel.records()) {}
  std::uint32_t record_of(std::uint32_t triangle) const {
    for (std::uint32_t i = 0; i < kernel.records().size(); ++i)
      if (kernel.records()[i].id == triangle) return i;
    return no_record;
  }
  Member across(std::uint32_t triangle, int edge, bool is_turned = false) const {
    return sheet.part_of(kernel.records().run_of(0)).across({record_of(triangle), is_turned}, edge);
  }

  ShapeSet shapes;
  Kernel kernel;
  TriangleSheet sheet;
};

Mesh two_triangles(const Triangle& second) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 1, 1}};
  mesh.triangles = {{0, 1, 2}, second};
  return mesh;
}

TEST(TriangleSheet, NeighboursLieAcrossEdges) {
  const Sheet one(two_triangles({2, 1, 3}));
  EXPECT_EQ(one.across(0, 1).record, one.record_of(1));
  EXPECT_FALSE(one.across(0, 1).is_turned);
  EXPECT_TRUE(one.across(0, 1, true).is_turned);
  EXPECT_EQ(one.across(1, 0).record, one.record_of(0));
  EXPECT_EQ(one.across(0, 0).record, no_record);
  EXPECT_EQ(one.across(1, 2).record, no_record);
}

TEST(TriangleSheet, ATurnedNeighbourIsSaidToBe) {
  const Sheet one(two_triangles({1, 2, 3}));
  EXPECT_TRUE(one.across(0, 1).is_turned);
  EXPECT_FALSE(one.across(0, 1, true).is_turned);
}

TEST(TriangleSheet, ThreeAtAnEdgeAreNoNeighbours) {
  Mesh mesh = two_triangles({2, 1, 3});
  mesh.triangles.push_back({2, 1, 4});
  const Sheet one(mesh);
  EXPECT_EQ(one.across(0, 1).record, no_record);
}

TEST(TriangleSheet, WhatCastsNoShadowIsNoNeighbour) {
  Mesh mesh = two_triangles({2, 1, 3});
  mesh.surfaces = {0, 1};
  const Sheet one(mesh, {false, true});
  EXPECT_EQ(one.across(0, 1).record, no_record);
}

/// Whether the sheet around what stands before the light's centre covers it for the receivers.
bool covers(const Sheet& sheet, const LightShape& light, const std::vector<ShadowQuery>& queries,
            std::uint32_t most = SheetScratch::most) {
  const trials::Watchers watchers(light, queries, sheet.kernel.bounds());
  if (watchers.count() != queries.size()) return false;
  const SeenLight sight = queries.size() == 1
                              ? seen_by_one(watchers.form, watchers.rows, 0)
                              : seen_by_all(watchers.form, watchers.group(0, queries.size()));
  Ray ray{sight.p, sight.way};
  ray.t_max = 1;
  const std::uint32_t start = sheet.kernel.closest_record(ray);
  SheetScratch scratch;
  std::uint64_t tests = 0;
  const bool result = start != no_record && sheet_covers(sheet.sheet, sheet.kernel.records(), sight,
                                                         start, most, scratch, tests);
  EXPECT_LE(tests, std::max(most, 16u));
  return result;
}

const ShadowQuery below{{{0, 0, -4}, {0, 0, 1}}, 0};

TEST(SheetCovers, OneTriangleHidesASmallLight) {
  Mesh mesh;
  mesh.positions = {{-3, -3, 0}, {3, -3, 0}, {0, 3, 0}};
  mesh.triangles = {{0, 1, 2}};
  const Sheet one(mesh);
  EXPECT_TRUE(covers(one, BallLight{{0, 0, 4}, 1}, {below}));
  EXPECT_FALSE(covers(one, BallLight{{0, 0, 4}, 5}, {below}));
  EXPECT_FALSE(covers(one, BallLight{{3, 3, 4}, 1}, {below}));     // passes by
  EXPECT_FALSE(covers(one, BallLight{{0, 0, 0.5f}, 1}, {below}));  // reaches through
  const ShadowQuery on_it{{{0, 0, 0}, {0, 0, 1}}, 0};
  EXPECT_FALSE(covers(one, BallLight{{0, 0, 4}, 1}, {on_it}));
}

TEST(SheetCovers, NothingIsProvenBesideALightTooFarForFloat) {
  Mesh mesh;
  mesh.positions = {{-3e-3f, -3e-3f, 0}, {3e-3f, -3e-3f, 0}, {0, 3e-3f, 0}};
  mesh.triangles = {{0, 1, 2}};
  const Sheet tiny(mesh);
  const ShadowQuery close{{{0, 0, -4e-3f}, {0, 0, 1}}, 0};
  EXPECT_TRUE(covers(tiny, BallLight{{0, 0, 1e6f}, 1e5f}, {close}));
  EXPECT_FALSE(covers(tiny, BallLight{{0, 0, 2e7f}, 2e6f}, {close}));
}

/// A cloth at z = 0 over [-1, 1]², 8 x 8 quads.
Mesh flat_cloth() {
  nasty::Random random(4);
  return nasty::cloth(8, 0, 0, random);
}

TEST(SheetCovers, AHoleInTheShaftIsAnOutline) {
  const BallLight light{{0, 0, 4}, 0.6f};
  Mesh mesh = flat_cloth();
  EXPECT_TRUE(covers(Sheet(mesh), light, {below}));
  const auto hole = [&](std::uint32_t triangle) {
    Mesh holed = mesh;
    holed.triangles.erase(holed.triangles.begin() + triangle);
    return covers(Sheet(holed), light, {below});
  };
  EXPECT_TRUE(hole(0));                 // in a corner
  EXPECT_FALSE(hole(2 * (3 * 8 + 4)));  // next to the middle
  EXPECT_FALSE(hole(2 * (3 * 8 + 4) + 1));
}

TEST(SheetCovers, AFoldInTheShaftProvesNothing) {
  Mesh mesh = flat_cloth();
  const BallLight light{{0, 0, 4}, 0.6f};
  for (Vec3f& p : mesh.positions)
    if (p.x > 0) p = {-p.x, p.y, 0.1f};
  EXPECT_FALSE(covers(Sheet(mesh), light, {below}));
}

TEST(SheetCovers, ATurnedTriangleIsNoFold) {
  Mesh mesh = flat_cloth();
  std::swap(mesh.triangles[2 * (3 * 8 + 4)][0], mesh.triangles[2 * (3 * 8 + 4)][1]);
  EXPECT_TRUE(covers(Sheet(mesh), BallLight{{0, 0, 4}, 0.6f}, {below}));
}

TEST(SheetCovers, ThreeTrianglesAtAnEdgeAreAnOutline) {
  Mesh mesh = flat_cloth();
  mesh.triangles.push_back(Triangle(mesh.triangles[2 * (3 * 8 + 4)]));
  EXPECT_FALSE(covers(Sheet(mesh), BallLight{{0, 0, 4}, 0.6f}, {below}));
}

TEST(SheetCovers, NoMoreTrianglesThanAllowed) {
  const Sheet one(flat_cloth());
  const BallLight light{{0, 0, 4}, 1.2f};
  EXPECT_TRUE(covers(one, light, {below}));
  EXPECT_FALSE(covers(one, light, {below}, 4));
}

TEST(SheetCovers, OtherKindsAndNumbersThatAreNone) {
  ShapeSet shapes;
  shapes.meshes.push_back(flat_cloth());
  shapes.spheres.push_back({{0, 0, -1}, 0.8f, 0});
  const Kernel kernel(shapes, {});
  const TriangleSheet sheet(shapes, kernel.records());
  const trials::Watchers watchers(BallLight{{0, 0, 4}, 0.3f}, {below}, kernel.bounds());
  SeenLight sight = seen_by_one(watchers.form, watchers.rows, 0);
  SheetScratch scratch;
  std::uint64_t tests = 0;
  for (std::uint32_t i = 0; i < kernel.records().size(); ++i)
    if (kernel.records()[i].kind == ShapeKind::sphere) {
      EXPECT_FALSE(sheet_covers(sheet, kernel.records(), sight, i, 99, scratch, tests));
    }
  sight.p.x = std::numeric_limits<float>::quiet_NaN();
  for (std::uint32_t i = 0; i < kernel.records().size(); ++i)
    EXPECT_FALSE(sheet_covers(sheet, kernel.records(), sight, i, 99, scratch, tests));
}

/// Receivers around a point, as a tile has them.
std::vector<ShadowQuery> group_at(Vec3f p, float radius, Vec3f towards, nasty::Random& random) {
  std::vector<ShadowQuery> queries;
  for (std::uint64_t i = 0; i < 16; ++i)
    queries.push_back({{p + random.in_cube() * (radius * 0.577f), normalize(towards - p)}, i});
  return queries;
}

/// A light that fills `share` of what a ball of radius 1 hides from p, behind it and off its
/// centre by what is left.
LightShape light_behind_ball(const char* kind, Vec3d p, double share, nasty::Random& random) {
  const double angle = std::asin(1 / length(p));
  const Frame<double> frame = frame_around(normalize(-p));
  const double off = std::tan(angle * (0.95 - share)), turn = double(random.uniform(0, 6.28f));
  const Vec3d way = frame.n + (frame.u * std::cos(turn) + frame.v * std::sin(turn)) * off;
  const double distance = length(p) + 3, size = distance * std::sin(angle * share);
  const LightFigure figure = random_figure(random);
  const auto of_size = [&](double s) {
    return make_light(kind, figure, p + normalize(way) * distance, s, Vec3f(p));
  };
  const LightHull hull(of_size(size), {Vec3f(p), Vec3f(p)});  // skew ones reach out farther
  return hull.is_sun() ? of_size(size) : of_size(size * size / hull.size());
}

TEST(SheetCovers, AFineBallHidesLightsWellBehindIt) {
  nasty::Random random(11);
  const Sheet ball(solid_meshes::globe(24));
  for (const char* kind : {"ball", "parallelogram", "disk", "line", "polygon", "mesh", "sun"}) {
    int proven = 0, proven_for_all = 0, of = 0;
    for (; of < 300; ++of) {
      const Vec3d p = random.direction() * double(random.uniform(1.5f, 5));
      const LightShape light =
          light_behind_ball(kind, p, double(random.uniform(0.02f, 0.6f)), random);
      proven += covers(ball, light, {{{Vec3f(p), Vec3f(normalize(-p))}, 0}});
      proven_for_all += covers(ball, light, group_at(Vec3f(p), 0.02f, {}, random));
    }
    EXPECT_EQ(proven, of) << kind;
    EXPECT_GT(proven_for_all, of * 9 / 10) << kind;
  }
}

/// The projective plane, laid nearly flat: every edge belongs to two triangles, and seen from below
/// only folds tell that the sheet does not go on to the shaft's outline.
TEST(SheetCovers, AOneSidedSheetProvesNothingItDoesNotHide) {
  Mesh mesh;
  const float at[6][2] = {{1.58169f, -3.1072f}, {2.9647f, 2.91471f},      {-3.15569f, 1.57614f},
                          {0.38578f, 2.11332f}, {-0.0385395f, -1.20195f}, {0.562786f, 0.108024f}};
  for (int i = 0; i < 6; ++i) mesh.positions.push_back({at[i][0], at[i][1], i > 2 ? -0.01f : 0});
  mesh.triangles = {{0, 1, 3}, {1, 2, 3}, {3, 2, 4}, {2, 0, 4}, {0, 1, 4},
                    {4, 1, 5}, {1, 2, 5}, {2, 0, 5}, {5, 0, 3}, {3, 4, 5}};
  const Sheet one_sided(mesh);
  for (const float radius : {4.0f, 5.0f, 6.0f, 8.0f})
    EXPECT_FALSE(covers(one_sided, BallLight{{0.303336f, 0.339835f, 10}, radius},
                        {{{{0.303336f, 0.339835f, -10}, {0, 0, 1}}, 0}}));
}

TEST(SheetScratch, SaysWhetherARecordWasThereTurnedTheSameWay) {
  auto scratch = std::make_unique<SheetScratch>();
  using Insert = SheetScratch::Insert;
  for (int search = 0; search < 3; ++search) {
    scratch->clear();
    EXPECT_EQ(scratch->insert({0, false}), Insert::added);
    EXPECT_EQ(scratch->insert({0, false}), Insert::known);
    EXPECT_EQ(scratch->insert({0, true}), Insert::contradicts);
    EXPECT_EQ(scratch->found().size(), 1u);
  }
}

}  // namespace
}  // namespace penumbra
