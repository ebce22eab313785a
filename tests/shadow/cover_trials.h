// SPDX-License-Identifier: MIT
// Occluders, lights and receivers made so that umbra is nearly critical, and the judge of them.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "penumbra/geometry/light_sampling.h"
#include "penumbra/kernel/record.h"
#include "penumbra/kernel/traverse.h"
#include "penumbra/shadow/light_hull.h"
#include "tests/kernel/nasty_shapes.h"

namespace penumbra::trials {

using nasty::Random;

/// One shape, and a point in it, on it or near it that a light may be hidden behind.
struct Occluder {
  ShapeSet shapes;
  Vec3d aim;
  double size = 1;  // a typical length
  ShapeRef ref() const { return all_primitives(shapes).front(); }
};

struct OccluderKind {
  const char* name;
  ShapeKind kind;
  std::function<void(ShapeSet&, Random&)> adjust;
};

inline const OccluderKind occluder_kinds[] = {
    {"sphere", ShapeKind::sphere, [](ShapeSet&, Random&) {}},
    {"capped cylinder", ShapeKind::cone,
     [](ShapeSet& s, Random&) {
       s.cones[0].apex_radius = s.cones[0].base_radius, s.cones[0].caps = Caps::capped;
     }},
    {"open cylinder", ShapeKind::cone,
     [](ShapeSet& s, Random&) {
       s.cones[0].apex_radius = s.cones[0].base_radius, s.cones[0].caps = Caps::open;
     }},
    {"capped cone", ShapeKind::cone,
     [](ShapeSet& s, Random& random) {
       s.cones[0].base_radius *= std::pow(4.0f, random.uniform(0, 3));
       s.cones[0].caps = Caps::capped;
     }},
    {"open cone", ShapeKind::cone,
     [](ShapeSet& s, Random& random) {
       s.cones[0].base_radius *= std::pow(4.0f, random.uniform(0, 3));
       s.cones[0].caps = Caps::open;
     }},
    {"full cone", ShapeKind::cone,
     [](ShapeSet& s, Random& random) {
       if (random.one_in(2)) std::swap(s.cones[0].base, s.cones[0].apex);
       s.cones[0].apex_radius = 0;
       if (random.one_in(4)) std::swap(s.cones[0].base_radius, s.cones[0].apex_radius);
     }},
    {"disk", ShapeKind::ring, [](ShapeSet& s, Random&) { s.rings[0].inner_radius = 0; }},
    {"ring", ShapeKind::ring,
     [](ShapeSet& s, Random& random) {
       s.rings[0].inner_radius = s.rings[0].radius * random.uniform(0.01f, 0.9f);
     }},
    {"triangle", ShapeKind::triangle, [](ShapeSet&, Random&) {}},
};

/// Points of the solid or the surface, the middle often.
inline Vec3d aim_at(const ShapeSet& shapes, ShapeRef ref, Random& random) {
  const Vec3d n = normalize(Vec3d(random.in_cube()));
  const double off = random.one_in(3) ? 0 : random.uniform(0, 1);
  switch (ref.kind) {
    case ShapeKind::sphere:
      return Vec3d(shapes.spheres[0].center) + n * (off * double(shapes.spheres[0].radius));
    case ShapeKind::cone: {
      const Cone& c = shapes.cones[0];
      const Vec3d base(c.base), axis = Vec3d(c.apex) - base;
      const Frame<double> frame = frame_around(normalize(axis));
      const double z = random.one_in(3) ? 0.5 : random.uniform(0, 1);
      const double r = off * (c.base_radius + z * (double(c.apex_radius) - c.base_radius));
      return base + axis * z + (frame.u * n.x + frame.v * n.y) * r;
    }
    case ShapeKind::ring: {
      const Ring& r = shapes.rings[0];
      const Frame<double> frame = frame_around(normalize(Vec3d(r.normal)));
      const double angle = random.uniform(0, 6.2831853f);
      const double at = r.inner_radius + (double(r.radius) - r.inner_radius) * random.uniform(0, 1);
      return Vec3d(r.center) + (frame.u * std::cos(angle) + frame.v * std::sin(angle)) * at;
    }
    case ShapeKind::triangle: break;
  }
  const Mesh& mesh = shapes.meshes[0];
  const Vec3d a(mesh.positions[0]), b(mesh.positions[1]), c(mesh.positions[2]);
  const double u = random.uniform(0, 1), v = random.uniform(0, 1) * (1 - u);
  return random.one_in(3) ? (a + b + c) / 3.0 : a + (b - a) * u + (c - a) * v;
}

inline Occluder make_occluder(const OccluderKind& kind, const nasty::Place& place, Random& random) {
  for (;;) {
    Occluder result{nasty::random_shapes(kind.kind, 1, place, random), {}, 1};
    for (Mesh& mesh : result.shapes.meshes) drop_degenerate_triangles(mesh);
    if (primitive_count(result.shapes) != 1) continue;
    kind.adjust(result.shapes, random);
    const ShapeRef ref = result.ref();
    result.aim = aim_at(result.shapes, ref, random);
    switch (ref.kind) {
      case ShapeKind::sphere: result.size = result.shapes.spheres[0].radius; break;
      case ShapeKind::cone:
        result.size =
            std::max(result.shapes.cones[0].base_radius, result.shapes.cones[0].apex_radius);
        break;
      case ShapeKind::ring: result.size = result.shapes.rings[0].radius; break;
      case ShapeKind::triangle: result.size = place.scale; break;
    }
    return result;
  }
}

/// A light of some form around a centre, as large as `size`, seen from p.
struct LightKind {
  const char* name;
  std::function<LightShape(Vec3d center, double size, Vec3f p, Random random)> make;
};

inline Vec3d some_direction(Random& random) {
  const Vec3d n(random.in_cube());
  if (!random.one_in(3)) return normalize(n);
  return normalize(Vec3d{std::round(n.x), std::round(n.y), std::round(n.z)} + Vec3d{0, 0, 1e-30});
}

/// The same random numbers for any size and centre: `random` comes by value.
inline const LightKind light_kinds[] = {
    {"point",
     [](Vec3d center, double, Vec3f, Random) -> LightShape { return PointLight{Vec3f(center)}; }},
    {"ball",
     [](Vec3d center, double size, Vec3f, Random) -> LightShape {
       return BallLight{Vec3f(center), static_cast<float>(size)};
     }},
    {"parallelogram",
     [](Vec3d center, double size, Vec3f, Random random) -> LightShape {
       const Vec3d u = some_direction(random);
       Vec3d v = normalize(cross(u, some_direction(random) + Vec3d{0.1, 0.2, 0.3}));
       if (random.one_in(2)) v = v + u * 0.5;
       return ParallelogramLight{Vec3f(center), Vec3f(u * size),
                                 Vec3f(v * (size * random.uniform(0.05f, 1)))};
     }},
    {"sun",
     [](Vec3d center, double size, Vec3f p, Random) -> LightShape {
       const Vec3d to = center - Vec3d(p);
       return SunLight{Vec3f(normalize(to)), static_cast<float>(std::atan(size / length(to)))};
     }},
};

/// Rays to the light's edge, as seen from p: towards its farthest points across the way.
inline void add_extreme_rays(const LightShape& light, Vec3f p, std::uint32_t count, Random& random,
                             LightSamples& rays) {
  const std::uint32_t before = rays.count;
  std::vector<float> old[3] = {rays.x, rays.y, rays.z};
  rays.resize(before + count);
  for (std::uint32_t i = 0; i < count; ++i) {
    const Frame<double> frame = frame_around(normalize(Vec3d(towards_center(light, p))));
    const double angle =
        random.one_in(2) ? random.below(8) * std::numbers::pi / 4 : random.uniform(0, 6.2831853f);
    const Vec3d across = frame.u * std::cos(angle) + frame.v * std::sin(angle);
    Vec3d way;
    if (const auto* sun = std::get_if<SunLight>(&light)) {
      way = frame.n * std::cos(double(sun->half_angle_rad)) +
            across * std::sin(double(sun->half_angle_rad));
    } else {
      const auto* ball = std::get_if<BallLight>(&light);
      const double distance = length(Vec3d(towards_center(light, p)));
      const double sine = ball ? std::min(1.0, ball->radius / distance) : 0;
      way = *support(light, across * std::sqrt(1 - sine * sine) - frame.n * sine) - Vec3d(p);
    }
    rays.x[before + i] = static_cast<float>(way.x);
    rays.y[before + i] = static_cast<float>(way.y);
    rays.z[before + i] = static_cast<float>(way.z);
  }
}

/// How many rays from p to samples and extreme points of the light the record leaves free.
inline std::uint32_t free_rays(const Record& record, const LightShape& light, Vec3f p,
                               const SamplePattern& pattern, std::uint32_t extremes,
                               Random& random) {
  LightSamples rays;
  sample_light(light, p, pattern, random.below(1u << 30), rays);
  add_extreme_rays(light, p, extremes, random, rays);
  const std::vector<std::uint32_t> active((rays.count + 31) / 32, ~0u);
  std::vector<std::uint32_t> blocked(active.size());
  occluded_brute({&record, 1}, rays, active, blocked);
  std::uint32_t hidden = 0;
  for (std::uint32_t word : blocked) hidden += static_cast<std::uint32_t>(__builtin_popcount(word));
  return rays.count - hidden;
}

}  // namespace penumbra::trials
