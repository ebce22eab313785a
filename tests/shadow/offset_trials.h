// SPDX-License-Identifier: MIT
// A shape, a light and a receiver point, placed so that proofs are tempted to be wrong:
// silhouettes, horizons, points on the shape itself, tiny and huge, far from the origin.
#pragma once

#include <optional>

#include "penumbra/geometry/surface_point.h"
#include "penumbra/kernel/kernel.h"
#include "tests/shadow/light_kinds.h"
#include "tests/shadow/shape_forms.h"

namespace penumbra::trials {

using nasty::Place;
using nasty::Random;

struct OffsetTrial {
  LightShape light;
  Vec3f p;
  Vec3f normal;  ///< at p, one way or the other
  // What the light was made from.
  LightFigure figure;
  Vec3d center;
  double size = 0;
};

inline Vec3f random_direction(Random& random) { return Vec3f(random.direction()); }

/// p' of a point on the shape that a random ray hits.
inline std::optional<SurfacePoint> own_point(const ShapeSet& shapes, const Kernel& kernel,
                                             const Place& place, Random& random) {
  const ShapeRef ref = only_primitive(shapes);
  const Vec3f origin = place(random.in_cube() * (random.one_in(4) ? 30.0f : 3.0f));
  const Vec3f direction = nasty::point_of_interest(shapes, ref, random) - origin;
  const auto hit = kernel.closest({origin, direction, 0, HUGE_VALF}).hit;
  if (!hit) return std::nullopt;
  return surface_point(shapes, ref, Vec3d(origin), Vec3d(direction), hit->t);
}

inline OffsetTrial offset_trial(const ShapeSet& shapes, const Kernel& kernel, const Place& place,
                                std::string_view light_kind, Random& random) {
  const ShapeRef ref = only_primitive(shapes);
  const auto interesting = [&] { return nasty::point_of_interest(shapes, ref, random); };
  Vec3f normal = random_direction(random);
  Vec3f p = place(random.in_cube() * (random.one_in(4) ? 10.0f : 2.0f));
  if (random.one_in(3)) {
    if (const auto own = own_point(shapes, kernel, place, random)) {
      normal = Vec3f(own->normal);
      p = random.one_in(8) ? behind_position(*own) : receiver_position(*own);
    }
  } else if (random.one_in(3)) {
    p = interesting() + random_direction(random) * (place.scale * random.power(-7, 0));
  }
  const float size = place.scale * random.power(-3, 0.5f) / 2;
  Vec3f center = place(random.in_cube() * random.power(0, 1.5f));
  // What grazes differs from a touch by anything from rounding to everything.
  const float touch = size * (1 + (random.one_in(2) ? 1.0f : -1.0f) * random.power(-7, 0));
  switch (random.below(4)) {
    case 0: {  // behind a silhouette, or before it
      const Vec3f way = interesting() - p;
      center = p + way * (random.one_in(4) ? random.power(-3, 0) : random.power(0, 1.5f)) +
               random_direction(random) * touch;
      break;
    }
    case 1: {  // near the horizon
      const Vec3f across = cross(normal, random_direction(random));
      center = p + across * (place.scale * random.power(-2, 1)) +
               normal * (random.one_in(3) ? place.scale * random.power(-7, -2) : touch);
      break;
    }
    case 2: {  // next to p, or to the shape
      const Vec3f to = random.one_in(2) ? p : interesting();
      center = to + random_direction(random) * (random.one_in(2) ? touch : 2 * touch);
      break;
    }
    default: break;
  }
  const LightFigure figure = random_figure(random);
  return {make_light(light_kind, figure, Vec3d(center), double(size), p),
          p,
          normal,
          figure,
          Vec3d(center),
          double(size)};
}

}  // namespace penumbra::trials
