// SPDX-License-Identifier: MIT
// How much larger than the exact Minkowski sum the set is in which offsets are not proven missed:
// the ratio of their volumes, by pair of shape and light (docs/method.md).
#include <gtest/gtest.h>

#include <optional>

#include "penumbra/geometry/separation.h"
#include "penumbra/shadow/light_box.h"
#include "penumbra/shadow/offset.h"
#include "penumbra/shadow/record_hull.h"
#include "tests/kernel/exact_shapes.h"
#include "tests/shadow/makers.h"

namespace penumbra {
namespace {

using nasty::Random;

// Distance from the solid (of rings: from the ring itself, hole and all).
double outside(const Sphere& s, exact::Vec x) {
  return std::max(0.0, double(length(x - exact::Vec(s.center)) - exact::Real(s.radius)));
}
double outside(const Ring& r, exact::Vec x) { return double(exact::distance(r, x)); }
double outside(const exact::Corners& t, exact::Vec x) { return double(exact::distance(t, x)); }
double outside(Cone c, exact::Vec x) {
  const exact::Vec q = exact::axis_of(c).profile_point(x);
  const exact::Real height = exact::height_of(c), share = q.x / height;
  if (share >= 0 && share <= 1 &&
      q.y <= exact::Real(c.base_radius) * (1 - share) + exact::Real(c.apex_radius) * share)
    return 0;
  c.caps = Caps::capped;
  return double(exact::distance(c, x));
}

/// The least value of a convex function on [lo, hi].
template <typename F>
double least(double lo, double hi, F&& f) {
  for (int i = 0; i < 40; ++i) {
    const double a = lo + (hi - lo) * 0.4, b = hi - (hi - lo) * 0.4;
    const double at_a = f(a), at_b = f(b);
    if (std::min(at_a, at_b) == 0) return 0;
    (at_a < at_b ? hi : lo) = at_a < at_b ? b : a;
  }
  return f((lo + hi) / 2);
}

/// The light as a flat set around x: x + a u + b v, a and b of a square or a unit disk; or a ball.
struct Flat {
  Vec3d u, v;
  bool is_round;
  double ball_radius;
};

template <typename Shape>
bool in_minkowski_sum(const Shape& shape, Vec3d x, const Flat& light, double t) {
  const auto at = [&](double a, double b) {
    return outside(shape, exact::Vec(x + (light.u * a + light.v * b) * t));
  };
  if (light.u == Vec3d{}) return at(0, 0) <= t * light.ball_radius;
  return least(-1, 1, [&](double a) {
           const double most = light.is_round ? std::sqrt(std::max(0.0, 1 - a * a)) : 1;
           return least(-most, most, [&](double b) { return at(a, b); });
         }) <= 1e-9;
}

/// A point that a light is drawn around: the thick segment of no length.
struct ThickPoint {
  const LightHull& light;
  Vec3d x;
  double t;
  Vec3d support(Vec3d n) const { return x + light.spread(n) * t; }
};

struct Light {
  const char* name;
  LightShape (*around)(Vec3f x);
  Flat flat;
  double t;
};

const Box scene{{-4, -4, -4}, {4, 4, 4}};

bool may_meet(const Record& record, const Light& light, Vec3f x) {
  const LightHull hull(light.around(x), scene);
  if (!hull.is_sun()) return !surely_misses_offset(record, hull, x, light.t);
  const double margin = hit_bound(record, x) + light.t * hull.doubt(x) +
                        (record.kind == ShapeKind::sphere ? record.number[3] : 0);
  return !with_hull(record, [&](const auto& shape) {
    return surely_apart(ThickPoint{hull, Vec3d(x), light.t}, shape, {1, 0, 0}, margin);
  });
}

std::vector<Light> lights() {
  const LightHull sun(SunLight{{0, 0.6f, 0.8f}, 0.3f}, scene);
  const Frame<double> f = frame_around(normalize(Vec3d{0, 0.6, 0.8}));
  const double width = length(sun.center({})) * std::tan(double(0.3f));
  return {
      {"point", [](Vec3f x) -> LightShape { return PointLight{x}; }, {{}, {}, false, 0}, 1},
      {"ball",
       [](Vec3f x) -> LightShape {
         return BallLight{x, 0.4f};
       },
       {{}, {}, false, 0.4f},
       1},
      {"ball, t = 1/4",
       [](Vec3f x) -> LightShape {
         return BallLight{x, 0.4f};
       },
       {{}, {}, false, 0.4f},
       0.25},
      {"parallelogram",
       [](Vec3f x) -> LightShape {
         return ParallelogramLight{x, {0.5f, 0, 0.25f}, {0.125f, 0.5f, 0}};
       },
       {{0.5, 0, 0.25}, {0.125, 0.5, 0}, false, 0},
       1},
      {"sun, t = 1/20",
       [](Vec3f) -> LightShape {
         return SunLight{{0, 0.6f, 0.8f}, 0.3f};
       },
       {f.u * width, f.v * width, true, 0},
       0.05},
  };
}

struct Volumes {
  int found = 0, exact = 0, lost = 0;
};

Volumes compare(const ShapeSet& shapes, const Light& light, int points) {
  const ShapeRef ref = all_primitives(shapes).front();
  const Record record = make_record(shapes, ref, 0);
  const Box box = offset_bounds(bounds(record), LightHull(light.around({}), scene), light.t, scene);
  Random random(1);
  Volumes volumes;
  for (int i = 0; i < points; ++i) {
    const Vec3f x{random.uniform(box.lo.x, box.hi.x), random.uniform(box.lo.y, box.hi.y),
                  random.uniform(box.lo.z, box.hi.z)};
    const bool is_in = exact::visit(shapes, ref, [&](const auto& shape) {
      return in_minkowski_sum(shape, Vec3d(x), light.flat, light.t);
    });
    const bool may = may_meet(record, light, x);
    volumes.found += may, volumes.exact += is_in, volumes.lost += is_in && !may;
  }
  return volumes;
}

std::vector<std::pair<const char*, ShapeSet>> test_shapes() {
  std::vector<std::pair<const char*, ShapeSet>> list;
  const auto add = [&](const char* name) -> ShapeSet& {
    list.emplace_back(name, ShapeSet{});
    return list.back().second;
  };
  add("sphere").spheres.push_back({{0, 0, 0}, 1, 0});
  add("cylinder").cones.push_back({{-0.5f, 0, -0.5f}, {0.5f, 0.25f, 1}, 0.5f, 0.5f});
  add("cone").cones.push_back({{-0.5f, 0, -0.5f}, {0.5f, 0.25f, 1}, 1, 0.25f, Caps::capped, 0});
  add("full cone").cones.push_back({{-0.5f, 0, -0.5f}, {0.5f, 0.25f, 1}, 1, 0, Caps::capped, 0});
  add("disk").rings.push_back({{0, 0, 0}, normalize(Vec3f{1, 2, 3}), 1, 0, 0});
  Mesh mesh;
  mesh.positions = {{-1, 0, 0}, {1, -0.5f, 0.5f}, {0.5f, 1, -0.25f}};
  mesh.triangles = {{0, 1, 2}};
  add("triangle").meshes.push_back(mesh);
  mesh.positions[2] = {0.01f, -0.25f, 0.25f};
  add("sliver").meshes.push_back(mesh);
  return list;
}

enum class Table { print, dont };

void compare_all(int points, double tolerance, Table table) {
  for (const auto& [name, shapes] : test_shapes())
    for (const Light& light : lights()) {
      const Volumes v = compare(shapes, light, points);
      EXPECT_EQ(v.lost, 0) << name << " " << light.name;
      if (v.exact == 0) {  // a flat shape has no volume
        EXPECT_LE(v.found, points / 1000) << name << " " << light.name;
        continue;
      }
      const double ratio = double(v.found) / v.exact;
      if (table == Table::print) std::printf("%-10s %-14s %.4f\n", name, light.name, ratio);
      EXPECT_LE(ratio, 1 + tolerance) << name << " " << light.name;
    }
}

TEST(Tightness, OfEveryPairIsThatOfTheMinkowskiSum) { compare_all(60, 0.05, Table::dont); }

TEST(SlowTightness, OfEveryPairIsThatOfTheMinkowskiSum) { compare_all(2'000, 0.002, Table::print); }

/// The hole is taken as straight, where its offset has a round rim.
TEST(Tightness, OfARingsHole) {
  ShapeSet shapes;
  shapes.rings.push_back({{0, 0, 0}, normalize(Vec3f{1, 2, 3}), 1, 0.6f, 0});
  for (const Light& light : lights()) {
    if (light.flat.u != Vec3d{} || light.flat.ball_radius == 0) continue;
    const Volumes v = compare(shapes, light, 20'000);
    EXPECT_EQ(v.lost, 0);
    EXPECT_LE(v.found, 1.05 * v.exact);
  }
}

}  // namespace
}  // namespace penumbra
