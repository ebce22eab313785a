// SPDX-License-Identifier: MIT
#include "penumbra/geometry/separation.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace penumbra {
namespace {

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  double uniform(double lo, double hi) {
    return std::uniform_real_distribution<double>(lo, hi)(engine_);
  }
  Vec3d in_cube() { return {uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)}; }

 private:
  std::mt19937_64 engine_;
};

struct Polytope {
  std::vector<Vec3d> corners;
  Vec3d support(Vec3d n) const {
    Vec3d best = corners.front();
    for (Vec3d corner : corners)
      if (dot(corner, n) > dot(best, n)) best = corner;
    return best;
  }
};

/// A box with half edges u, v and a ball around it.
struct Cushion {
  Vec3d center, u, v;
  double radius;
  Vec3d support(Vec3d n) const {
    return center + (dot(u, n) < 0 ? -u : u) + (dot(v, n) < 0 ? -v : v) + normalize(n) * radius;
  }
};

struct Placement {
  Frame<double> frame;
  Vec3d offset;
  double scale;
  Vec3d operator()(Vec3d x) const {
    return offset + (frame.u * x.x + frame.v * x.y + frame.n * x.z) * scale;
  }
};

Placement random_placement(Random& random) {
  const double scale = std::pow(10, random.uniform(-6, 6));
  return {frame_around(normalize(random.in_cube())), random.in_cube() * (10 * scale), scale};
}

/// Corners on and above the plane z = 0 (sign 1), or on and below it, around a point of the plane.
Polytope random_polytope(Random& random, double sign, double height, const Placement& place) {
  Polytope result;
  const int free = 1 + int(random.uniform(0, 8)), flat = int(random.uniform(0, 4));
  result.corners.push_back(place({0, 0, height}));
  for (int i = 0; i < free; ++i) {
    const Vec3d x = random.in_cube();
    result.corners.push_back(place({x.x, x.y, height + sign * std::abs(x.z)}));
  }
  for (int i = 0; i < flat; ++i) {
    const Vec3d x = random.in_cube();
    result.corners.push_back(place({x.x, x.y, height}));
  }
  return result;
}

TEST(Separation, OfPolytopesIsExactToABillionth) {
  Random random(1);
  for (int i = 0; i < 100'000; ++i) {
    const Placement place = random_placement(random);
    const double gap = std::pow(10, random.uniform(-5, 1));
    const Polytope a = random_polytope(random, 1, 0, place),
                   b = random_polytope(random, -1, -gap, place);
    const double distance = gap * place.scale, doubt = 1e-9 * 30 * place.scale;
    const Vec3d hint = random.in_cube();
    ASSERT_TRUE(surely_apart(a, b, hint, distance - doubt)) << i;
    ASSERT_FALSE(surely_apart(a, b, hint, distance + 1e-9 * distance + 1e-14 * place.scale)) << i;
    ASSERT_TRUE(surely_apart(a, b, place.frame.n, distance - doubt));
  }
}

TEST(Separation, OfCurvedSetsIsExactToATenThousandth) {
  Random random(2);
  int proven = 0;
  constexpr int trials = 20'000;
  for (int i = 0; i < trials; ++i) {
    const Placement place = random_placement(random);
    const double gap = std::pow(10, random.uniform(-2, 1));
    const auto across = [&] {
      return place({random.uniform(-1, 1), random.uniform(-1, 1), 0}) - place({});
    };
    const auto cushion = [&](double height, double sign) {
      const double radius = random.uniform(0.01, 1);
      return Cushion{place({0, 0, height + sign * radius}), across(), across(),
                     radius * place.scale};
    };
    const Cushion a = cushion(0, 1), b = cushion(-gap, -1);
    const double distance = gap * place.scale;
    proven += surely_apart(a, b, random.in_cube(), distance - 1e-4 * place.scale);
    ASSERT_FALSE(surely_apart(a, b, random.in_cube(), distance + 1e-9 * place.scale)) << i;
  }
  EXPECT_EQ(proven, trials);
}

TEST(Separation, SetsThatMeetAreNotApart) {
  Random random(3);
  for (int i = 0; i < 50'000; ++i) {
    const Placement place = random_placement(random);
    Polytope a = random_polytope(random, 1, 0, place), b = random_polytope(random, 1, 0, place);
    const Vec3d common = place(random.in_cube());
    a.corners.push_back(common), b.corners.push_back(common);
    ASSERT_FALSE(surely_apart(a, b, random.in_cube(), 0));
  }
}

TEST(Separation, NotANumberProvesNothing) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Polytope a{{{0, 0, 1}, {1, 0, 1}}}, b{{{0, 0, 0}, {0, 1, 0}}};
  EXPECT_TRUE(surely_apart(a, b, {0, 0, 1}, 0.5));
  EXPECT_TRUE(surely_apart(a, b, {0, 0, 0}, 0.5));
  EXPECT_FALSE(surely_apart(a, b, {0, 0, 1}, nan));
  EXPECT_FALSE(surely_apart(a, b, {nan, 0, 1}, 1.5));
  const Polytope none{{{nan, 0, 0}, {0, nan, 0}}};
  EXPECT_FALSE(surely_apart(a, none, {0, 0, 1}, 0.5));
  EXPECT_FALSE(surely_apart(none, none, {0, 0, 1}, 0.5));
}

/// Nearest: all corners lie beyond the plane through it and across it.
TEST(Simplex, ExtendFindsTheNearestPointAndKeepsWhatItNeeds) {
  Random random(4);
  int inside = 0;
  for (int i = 0; i < 200'000; ++i) {
    Simplex simplex;
    Vec3d nearest = random.in_cube();
    std::vector<Vec3d> all;
    for (int corner = 0; corner < 12 && simplex.count < 4; ++corner) {
      const Vec3d point = random.in_cube() + Vec3d(0, 0, 0.2);
      // As the search does: only what lies nearer along the last nearest point.
      if (corner > 0 && dot(point, nearest) > length_squared(nearest) * (1 - 1e-9)) continue;
      all.assign(simplex.point, simplex.point + simplex.count);
      all.push_back(point);
      const double last = corner > 0 ? length_squared(nearest) : 100;
      nearest = extend(simplex, point);
      const double square = length_squared(nearest);
      ASSERT_LE(square, last);
      for (Vec3d x : all) ASSERT_GE(dot(x, nearest), square - 1e-9);
      for (int k = 0; k < simplex.count; ++k)
        ASSERT_NEAR(dot(simplex.point[k], nearest), square, 1e-9);
      if (square == 0) break;
    }
    inside += nearest == Vec3d{};
  }
  EXPECT_GT(inside, 1000);
}

}  // namespace
}  // namespace penumbra
