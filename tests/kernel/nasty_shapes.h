// SPDX-License-Identifier: MIT
// Random primitives and rays of the kind that break intersectors: slivers, shared corners, grazing
// and axis-parallel rays, huge and tiny scales, far from the origin.
#pragma once

#include <cmath>
#include <limits>
#include <random>

#include "penumbra/geometry/light_sampling.h"
#include "penumbra/geometry/shape.h"

namespace penumbra::nasty {

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  float uniform(float lo, float hi) {
    return std::uniform_real_distribution<float>(lo, hi)(engine_);
  }
  std::uint32_t below(std::uint32_t n) { return static_cast<std::uint32_t>(engine_() % n); }
  bool one_in(std::uint32_t n) { return below(n) == 0; }
  Vec3f in_cube() { return {uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)}; }
  /// 10^uniform(lo, hi)
  float power(float lo, float hi) { return std::pow(10.0f, uniform(lo, hi)); }
  /// A unit vector, often along an axis or a diagonal.
  Vec3d direction() {
    Vec3d n(in_cube());
    if (one_in(3)) n = {std::round(n.x), std::round(n.y), std::round(n.z)};
    return n == Vec3d{} ? Vec3d{0, 0, 1} : normalize(n);
  }

 private:
  std::mt19937_64 engine_;
};

/// A frame of reference: everything in a case is scaled and moved by it.
struct Place {
  float scale = 1;
  Vec3f offset{};
  Vec3f operator()(Vec3f p) const { return offset + p * scale; }
};

inline Place random_place(Random& random) {
  Place place;
  if (random.one_in(2)) place.scale = random.power(-8, 8);
  if (random.one_in(3)) place.offset = random.in_cube() * (place.scale * random.power(0, 5));
  return place;
}

/// Sometimes on a coarse grid, so that coordinates coincide and rays meet edges and corners
/// exactly.
inline Vec3f random_point(Random& random) {
  const Vec3f p = random.in_cube();
  if (!random.one_in(3)) return p;
  return {std::round(p.x * 2) / 2, std::round(p.y * 2) / 2, std::round(p.z * 2) / 2};
}

inline ShapeSet random_shapes(ShapeKind kind, std::uint32_t count, const Place& place,
                              Random& random) {
  ShapeSet shapes;
  const auto radius = [&] { return place.scale * random.power(-3, 0); };
  for (std::uint32_t i = 0; i < count; ++i) {
    const Vec3f a = place(random_point(random));
    switch (kind) {
      case ShapeKind::sphere: shapes.spheres.push_back({a, radius(), 0}); break;
      case ShapeKind::cone: {
        Vec3f b = place(random_point(random));
        if (b == a) b = place(random.in_cube());
        if (b == a) break;  // so far out that the scale is lost
        const float r = radius();
        shapes.cones.push_back({a, b, r,
                                random.one_in(2)   ? r
                                : random.one_in(3) ? 0
                                                   : radius(),
                                random.one_in(2) ? Caps::capped : Caps::open, 0});
        break;
      }
      case ShapeKind::ring: {
        const float r = radius();
        const Vec3f n = random.one_in(3) ? Vec3f{0, 0, 1} : normalize(random.in_cube());
        shapes.rings.push_back({a, n, r, random.one_in(2) ? 0 : r * random.uniform(0, 1), 0});
        break;
      }
      case ShapeKind::triangle: {
        if (shapes.meshes.empty()) shapes.meshes.emplace_back();
        Mesh& mesh = shapes.meshes.front();
        const auto n = static_cast<std::uint32_t>(mesh.positions.size());
        const Vec3f b = place(random_point(random));
        const bool is_sliver = random.one_in(4);
        const Vec3f c = is_sliver ? (a + b) * 0.5f + random.in_cube() * (place.scale * 1e-5f)
                                  : place(random_point(random));
        for (Vec3f p : {a, b, c}) mesh.positions.push_back(p);
        if (n >= 3 && random.one_in(2))
          mesh.triangles.push_back({n - 1, n, n + 1});  // shares a corner with the one before
        else
          mesh.triangles.push_back({n, n + 1, n + 2});
        break;
      }
    }
  }
  return shapes;
}

/// Some point that matters for a primitive: a corner, a point on its surface, on its rim, its
/// centre.
inline Vec3f point_of_interest(const ShapeSet& shapes, ShapeRef ref, Random& random) {
  const Vec3f n = normalize(random.in_cube());
  switch (ref.kind) {
    case ShapeKind::sphere:
      return shapes.spheres[ref.index].center + n * shapes.spheres[ref.index].radius;
    case ShapeKind::cone: {
      const Cone& c = shapes.cones[ref.index];
      const Frame<float> f = frame_around(normalize(c.apex - c.base));
      const float angle = random.uniform(0, 6.2831853f), s = random.one_in(3) ? 0
                                                             : random.one_in(2)
                                                                 ? 1
                                                                 : random.uniform(0, 1);
      const float r = c.base_radius + s * (c.apex_radius - c.base_radius);
      return c.base + (c.apex - c.base) * s + f.u * (r * std::cos(angle)) +
             f.v * (r * std::sin(angle));
    }
    case ShapeKind::ring: {
      const Ring& r = shapes.rings[ref.index];
      const Frame<float> f = frame_around(r.normal);
      return r.center + (f.u * n.x + f.v * n.y) * (random.one_in(2) ? r.radius : r.inner_radius);
    }
    case ShapeKind::triangle: break;
  }
  const Mesh& mesh = shapes.meshes[ref.index];
  const Triangle& t = mesh.triangles[ref.triangle];
  const Vec3f a = mesh.positions[t[0]], b = mesh.positions[t[1]], c = mesh.positions[t[2]];
  if (random.one_in(3)) return a;
  const float u = random.uniform(0, 1);
  if (random.one_in(2)) return a + (b - a) * u;
  return a + (b - a) * u + (c - a) * (random.uniform(0, 1) * (1 - u));
}

/// What breaks slab tests: zeros of either sign, numbers whose reciprocal is infinite, and (rarely)
/// what is no number.
inline float odd_component(Random& random) {
  constexpr float odd[] = {0, -0.0f, 1e-42f, -1e-42f, 1e-38f, -1e-38f};
  return random.one_in(50) ? std::numeric_limits<float>::quiet_NaN() : odd[random.below(6)];
}

/// A packet: one origin, `count` directions, some towards points of interest, some grazing, some
/// along axes.
inline LightSamples random_packet(const ShapeSet& shapes, const std::vector<ShapeRef>& refs,
                                  const Place& place, std::uint32_t count, Random& random) {
  LightSamples rays;
  rays.resize(count);
  const auto interesting = [&] {
    return point_of_interest(shapes, refs[random.below(static_cast<std::uint32_t>(refs.size()))],
                             random);
  };
  rays.origin = random.one_in(4) ? interesting()
                                 : place(random.in_cube() * (random.one_in(4) ? 100.0f : 2.0f));
  rays.t_max = random.one_in(4) ? std::numeric_limits<float>::infinity() : 1.0f;
  const Vec3f towards = interesting();
  const float spread = random.one_in(2) ? 2 : random.power(-4, 0);
  for (std::uint32_t i = 0; i < rays.x.size(); ++i) {
    Vec3f target = towards + random.in_cube() * (place.scale * spread);
    if (random.one_in(4)) target = interesting();
    Vec3f d = target - rays.origin;
    if (random.one_in(8)) d[static_cast<int>(random.below(3))] = odd_component(random);
    if (random.one_in(8)) d = d * 2.0f;
    rays.x[i] = d.x, rays.y[i] = d.y, rays.z[i] = d.z;
  }
  return rays;
}

}  // namespace penumbra::nasty
