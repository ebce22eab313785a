// SPDX-License-Identifier: MIT
// Occluders, lights and receivers made so that umbra is nearly critical.
#pragma once

#include <algorithm>
#include <cmath>

#include "tests/shadow/light_kinds.h"
#include "tests/shadow/shape_forms.h"

namespace penumbra::trials {

using nasty::Place;
using nasty::Random;

/// One shape, and a point in it, on it or near it that a light may be hidden behind.
struct Occluder {
  ShapeSet shapes;
  Record record;
  Vec3d aim;
  double size = 1;  // how wide it is
};

/// Points of the solid or the surface, the middle often.
inline Vec3d aim_at(const ShapeSet& shapes, ShapeRef ref, Random& random) {
  const Vec3d n = random.direction();
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

inline double width_of(const ShapeSet& shapes, ShapeRef ref) {
  switch (ref.kind) {
    case ShapeKind::sphere: return shapes.spheres[0].radius;
    case ShapeKind::cone: return std::max(shapes.cones[0].base_radius, shapes.cones[0].apex_radius);
    case ShapeKind::ring: return shapes.rings[0].radius;
    case ShapeKind::triangle: break;
  }
  const Mesh& mesh = shapes.meshes[0];
  const Vec3d a(mesh.positions[0]), b(mesh.positions[1]), c(mesh.positions[2]);
  return length(cross(b - a, c - a)) / std::max({length(b - a), length(c - b), length(a - c)});
}

inline Occluder make_occluder(const ShapeForm& form, const Place& place, Random& random) {
  const ShapeSet shapes = random_shape(form, place, random);
  const ShapeRef ref = only_primitive(shapes);
  return {shapes, only_record(shapes), aim_at(shapes, ref, random), width_of(shapes, ref)};
}

struct CoverTrial {
  LightShape light;
  Vec3f p;
};

/// One way to look at an occluder: lights that grow or move with t, from surely hidden (if any is)
/// to surely not.
class Situation {
 public:
  Situation(const char* light_kind, const Occluder& occluder, Random& random)
      : kind_(light_kind), figure_(random_figure(random)) {
    const Vec3d way = random.direction();
    const double before = distance(occluder.size, random), behind = distance(occluder.size, random);
    Vec3d p = occluder.aim - way * before;
    center_ = occluder.aim + way * (random.one_in(30) ? -behind : behind);
    if (random.one_in(8)) {
      const Vec3f q =
          nasty::point_of_interest(occluder.shapes, only_primitive(occluder.shapes), random);
      p = Vec3d(q) - way * (occluder.size * (random.one_in(2) ? 0 : 1e-6));
    }
    p_ = Vec3f(p);
    const double seen = occluder.size * (1 + behind / (before + 1e-30));
    largest_ = std::min(seen, 100 * (before + behind)) * (random.one_in(2) ? 1 : 4);
    if (random.one_in(3)) {
      smallest_ = largest_ * double(random.power(-4, -0.5f));
      shift_ = random.direction() * (largest_ * 2);
    }
  }

  CoverTrial at(double t) const {
    const bool is_moved = shift_ != Vec3d{};
    const double size = is_moved ? smallest_ : std::max(largest_ * t, largest_ * 1e-6);
    return {make_light(kind_, figure_, is_moved ? center_ + shift_ * t : center_, size, p_), p_};
  }

 private:
  static double distance(double size, Random& random) {
    switch (random.below(6)) {
      case 0: return size * double(random.power(-7, -1));
      case 1: return size * double(random.power(0, 4));
      default: return size * double(random.uniform(0.1f, 4));
    }
  }

  const char* kind_;
  LightFigure figure_;
  Vec3f p_;
  Vec3d center_, shift_;
  double largest_ = 0, smallest_ = 0;
};

}  // namespace penumbra::trials
