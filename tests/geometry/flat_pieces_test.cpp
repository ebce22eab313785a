// SPDX-License-Identifier: MIT
#include "penumbra/geometry/flat_pieces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "penumbra/geometry/planar_hull.h"

namespace penumbra {
namespace {

std::vector<PlaneTriangle> rectangle(double x, double y, double width, double height) {
  const PlanePoint a{x, y}, b{x + width, y}, c{x + width, y + height}, d{x, y + height};
  return {{a, b, c}, {a, c, d}};
}

std::vector<PlaneTriangle> together(std::initializer_list<std::vector<PlaneTriangle>> parts) {
  std::vector<PlaneTriangle> all;
  for (const std::vector<PlaneTriangle>& part : parts)
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

double area_of(const std::vector<PlaneTriangle>& triangles) {
  double sum = 0;
  for (const PlaneTriangle& t : triangles) sum += 0.5 * std::abs(twice_area(t[0], t[1], t[2]));
  return sum;
}

/// Areas add up, and pieces are convex polygons that are full.
void expect_exact(const std::vector<PlaneTriangle>& triangles, std::size_t count) {
  const std::vector<FlatPiece> pieces = flat_pieces(triangles, 8);
  EXPECT_EQ(pieces.size(), count) << "area " << area_of(triangles);
  double sum = 0;
  for (const FlatPiece& piece : pieces) {
    sum += piece.area;
    EXPECT_NEAR(area(piece.ring), piece.area, 1e-4 * piece.area);
  }
  EXPECT_NEAR(sum, area_of(triangles), 1e-9 * sum);
}

TEST(FlatPieces, of_a_convex_surface_are_one) {
  expect_exact(rectangle(0, 0, 3, 1), 1);
  // T-junctions: one long edge meets two short ones.
  expect_exact(together({rectangle(0, 0, 2, 1), rectangle(0, 1, 1, 1), rectangle(1, 1, 1, 1)}), 1);
}

TEST(FlatPieces, make_letters) {
  const auto stem = rectangle(0, 0, 1, 5), low = rectangle(1, 0, 2, 1),
             high = rectangle(1, 4, 2, 1), middle = rectangle(1, 2, 1, 1);
  expect_exact(together({stem, low}), 2);                                     // L
  expect_exact(together({stem, high, middle}), 3);                            // F
  expect_exact(together({stem, low, high, middle}), 4);                       // E
  expect_exact(together({rectangle(0, 0, 3, 1), rectangle(1, 1, 1, 3)}), 2);  // T
  expect_exact(together({rectangle(0, 1, 1, 1), rectangle(1, 0, 1, 3), rectangle(2, 1, 1, 1)}),
               3);  // +
}

TEST(FlatPieces, go_around_holes) {
  expect_exact(together({rectangle(0, 0, 1, 3), rectangle(2, 0, 1, 3), rectangle(1, 0, 1, 1),
                         rectangle(1, 2, 1, 1)}),
               4);
}

TEST(FlatPieces, bear_coordinates_that_files_rounded) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> noise(-1e-6, 1e-6);
  // A frame of 4 x 40 squares, moved a little.
  std::vector<PlaneTriangle> frame;
  const auto point = [&](int x, int y) {
    random.seed(static_cast<unsigned>(1000 * x + y));
    return PlanePoint{x * 0.1 + noise(random), y * 0.1 + noise(random)};
  };
  for (int x = 0; x < 40; ++x)
    for (int y = 0; y < 40; ++y) {
      if (x >= 5 && x < 35 && y >= 5 && y < 35) continue;
      const PlanePoint a = point(x, y), b = point(x + 1, y), c = point(x + 1, y + 1),
                       d = point(x, y + 1);
      frame.push_back({a, b, c}), frame.push_back({a, c, d});
    }
  expect_exact(frame, 4);
}

TEST(FlatPieces, are_no_more_than_asked_for) {
  std::vector<PlaneTriangle> ring;
  const auto at = [](int i, double radius) {
    const double angle = 2 * std::numbers::pi * i / 200;
    return PlanePoint{radius * std::cos(angle), radius * std::sin(angle)};
  };
  for (int i = 0; i < 200; ++i) {
    ring.push_back({at(i, 1), at(i, 2), at(i + 1, 2)});
    ring.push_back({at(i, 1), at(i + 1, 2), at(i + 1, 1)});
  }
  for (const std::size_t most : {1, 2, 5, 8}) {
    const std::vector<FlatPiece> pieces = flat_pieces(ring, most);
    EXPECT_LE(pieces.size(), most);
    double sum = 0, hulls = 0;
    for (const FlatPiece& piece : pieces) sum += piece.area, hulls += area(piece.ring);
    EXPECT_NEAR(sum, area_of(ring), 1e-9);
    EXPECT_LT(hulls, (most == 8 ? 1.05 : 1.4) * sum);
  }
}

TEST(FlatPieces, do_not_depend_on_the_order_of_triangles) {
  auto letter = together(
      {rectangle(0, 0, 1, 5), rectangle(1, 0, 2, 1), rectangle(1, 4, 2, 1), rectangle(1, 2, 1, 1)});
  const std::vector<FlatPiece> pieces = flat_pieces(letter, 8);
  std::mt19937 random(3);
  for (int i = 0; i < 10; ++i) {
    std::shuffle(letter.begin(), letter.end(), random);
    for (PlaneTriangle& t : letter) std::shuffle(t.begin(), t.end(), random);
    const std::vector<FlatPiece> again = flat_pieces(letter, 8);
    ASSERT_EQ(again.size(), pieces.size());
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      EXPECT_EQ(again[k].ring, pieces[k].ring);
      EXPECT_EQ(again[k].area, pieces[k].area);
    }
  }
}

TEST(FlatPieces, of_nothing_are_none) {
  EXPECT_TRUE(flat_pieces({}, 8).empty());
  const std::vector<PlaneTriangle> flat{{PlanePoint{0, 0}, PlanePoint{1, 1}, PlanePoint{2, 2}}};
  EXPECT_TRUE(flat_pieces(flat, 8).empty());
}

}  // namespace
}  // namespace penumbra
