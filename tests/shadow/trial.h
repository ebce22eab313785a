// SPDX-License-Identifier: MIT
// A shape, a light and a receiver point, placed so that proofs are tempted to be wrong:
// silhouettes, horizons, points on the shape itself, tiny and huge, far from the origin.
#pragma once

#include <optional>

#include "penumbra/geometry/surface_point.h"
#include "penumbra/kernel/kernel.h"
#include "penumbra/kernel/record.h"
#include "tests/shadow/makers.h"

namespace penumbra::trial {

using makers::power;
using nasty::Place;
using nasty::Random;

struct Trial {
  LightShape light;
  Vec3f p;
};

/// A point of a sphere around 0, often along an axis.
inline Vec3f random_direction(Random& random) {
  if (random.one_in(4)) {
    Vec3f axis;
    axis[static_cast<int>(random.below(3))] = random.one_in(2) ? 1.0f : -1.0f;
    return axis;
  }
  const Vec3f n = normalize(random.in_cube());
  return n == Vec3f{} ? Vec3f{0, 0, 1} : n;
}

/// p' of a point on the shape that a random ray hits.
inline std::optional<SurfacePoint> own_point(const ShapeSet& shapes, const Kernel& kernel,
                                             const Place& place, Random& random) {
  const ShapeRef ref = all_primitives(shapes).front();
  const Vec3f origin = place(random.in_cube() * (random.one_in(4) ? 30.0f : 3.0f));
  const Vec3f direction = nasty::point_of_interest(shapes, ref, random) - origin;
  const auto hit = kernel.closest({origin, direction, 0, HUGE_VALF}).hit;
  if (!hit) return std::nullopt;
  return surface_point(shapes, ref, Vec3d(origin), Vec3d(direction), hit->t);
}

inline Trial random_trial(const ShapeSet& shapes, const Kernel& kernel, const Place& place,
                          const makers::LightMaker& maker, Random& random) {
  const ShapeRef ref = all_primitives(shapes).front();
  const auto interesting = [&] { return nasty::point_of_interest(shapes, ref, random); };
  Trial trial;
  Vec3f normal = random_direction(random);
  trial.p = place(random.in_cube() * (random.one_in(4) ? 10.0f : 2.0f));
  if (random.one_in(3)) {
    if (const auto own = own_point(shapes, kernel, place, random)) {
      normal = Vec3f(own->normal);
      trial.p = random.one_in(8) ? behind_position(*own) : receiver_position(*own);
    }
  } else if (random.one_in(3)) {
    trial.p = interesting() + random_direction(random) * (place.scale * power(random, -7, 0));
  }
  const float size = place.scale * power(random, -3, 0.5f);
  Vec3f center = place(random.in_cube() * power(random, 0, 1.5f));
  // What grazes differs from a touch by anything from rounding to everything.
  const float touch = size / 2 * (1 + (random.one_in(2) ? 1.0f : -1.0f) * power(random, -7, 0));
  switch (random.below(4)) {
    case 0: {  // behind a silhouette, or before it
      const Vec3f way = interesting() - trial.p;
      center = trial.p + way * (random.one_in(4) ? power(random, -3, 0) : power(random, 0, 1.5f)) +
               random_direction(random) * touch;
      break;
    }
    case 1: {  // near the horizon
      const Vec3f across = cross(normal, random_direction(random));
      center = trial.p + across * (place.scale * power(random, -2, 1)) +
               normal * (random.one_in(3) ? place.scale * power(random, -7, -2) : touch);
      break;
    }
    case 2: {  // next to p, or to the shape
      const Vec3f to = random.one_in(2) ? trial.p : interesting();
      center = to + random_direction(random) * (random.one_in(2) ? touch : 2 * touch);
      break;
    }
    default: break;
  }
  trial.light = maker.make(center, size, trial.p, random);
  return trial;
}

}  // namespace penumbra::trial
