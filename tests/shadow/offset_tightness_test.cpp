// SPDX-License-Identifier: MIT
// How much larger than the exact offset the set is in which offsets are not proven missed: the
// ratio of their volumes, by pair of shape and light (docs/method.md, How tight).
#include <cstdio>

#include "penumbra/geometry/separation.h"
#include "penumbra/shadow/light_box.h"
#include "penumbra/shadow/offset.h"
#include "penumbra/shadow/record_hull.h"
#include "tests/shadow/exact_offset.h"
#include "tests/shadow/pairs.h"

namespace penumbra {
namespace {

using nasty::Random;

const Box scene{{-4, -4, -4}, {4, 4, 4}};

/// A point that a light is drawn around: the thick segment of no length.
struct ThickPoint {
  const LightHull& light;
  Vec3d x;
  double t;
  Vec3d support(Vec3d n) const { return x + light.spread(n) * t; }
};

bool may_meet(const Record& record, const LightHull& hull, Vec3f x, double t) {
  if (!hull.is_sun()) return !surely_misses_offset(record, hull, x, t);
  const double margin = hit_bound(record, x) + t * hull.doubt(x) +
                        (record.kind == ShapeKind::sphere ? record.number[3] : 0);
  return !with_hull(record, [&](const auto& shape) {
    return surely_apart(ThickPoint{hull, Vec3d(x), t}, shape, {1, 0, 0}, margin);
  });
}

/// Sums over the shapes.
struct Volumes {
  double found = 0, exact = 0;
};

double volume(const Box& box) {
  const Vec3d size(box.size());
  return size.x * size.y * size.z;
}

/// Points of the offset's box, each with the light around it.
void compare(const ShapeSet& shapes, const char* light_kind, int points, Random& random,
             Volumes& volumes) {
  const Record record = only_record(shapes);
  const LightFigure form = random_figure(random);
  const Vec3d towards = random.direction();
  const auto light_around = [&](Vec3f x) {
    return make_light(light_kind, form, Vec3d(x), 0.4, Vec3f(Vec3d(x) - towards));
  };
  const LightHull around_zero(light_around({}), scene);
  const double t = around_zero.is_sun() ? 0.3 / around_zero.size() : 0.75;
  const Box box = offset_bounds(bounds(record), around_zero, t, scene);
  for (int i = 0; i < points; ++i) {
    const Vec3f x{random.uniform(box.lo.x, box.hi.x), random.uniform(box.lo.y, box.hi.y),
                  random.uniform(box.lo.z, box.hi.z)};
    const LightShape light = light_around(x);
    const LightHull hull(light, scene);
    const exact::LightBody body = exact::body_of(light, hull.size());
    const bool is_in = exact::visit(shapes, only_primitive(shapes), [&](const auto& shape) {
      return exact::in_offset(shape, body, Vec3d(x), t);
    });
    const bool may = may_meet(record, hull, x, t);
    EXPECT_TRUE(may || !is_in);
    volumes.found += may * volume(box), volumes.exact += is_in * volume(box);
  }
}

Volumes compare_many(const ShapeForm& form, const char* light_kind, int shapes, int points) {
  Random random(1);
  Volumes volumes;
  for (int i = 0; i < shapes; ++i)
    compare(random_shape(form, {}, random), light_kind, points, random, volumes);
  volumes.found /= points, volumes.exact /= points;
  return volumes;
}

/// In a ring's hole the light counts as a ball around its centre.
double limit(const ShapeForm& form, double otherwise) {
  return std::string_view(form.name) == "ring" ? 1.5 : otherwise;
}

using OffsetTightness = EveryPair;
using SlowOffsetTightness = EveryPair;

TEST_P(OffsetTightness, IsThatOfTheExactOffset) {
  const Volumes v = compare_many(form(), light_kind(), 20, 4);
  EXPECT_LE(v.found, limit(form(), 1.1) * v.exact + 0.1);
}

TEST_P(SlowOffsetTightness, IsThatOfTheExactOffset) {
  const Volumes v = compare_many(form(), light_kind(), 100, 50);
  EXPECT_LE(v.found, limit(form(), 1.001) * v.exact + 0.001);
  std::printf("offset %-16s %-14s %.4f = %.5f / %.5f\n", form().name, light_kind(),
              v.found / v.exact, v.found, v.exact);
}

INSTANTIATE_TEST_SUITE_P(Pairs, OffsetTightness, every_pair(), name_of_pair);
INSTANTIATE_TEST_SUITE_P(Pairs, SlowOffsetTightness, every_pair(), name_of_pair);

}  // namespace
}  // namespace penumbra
