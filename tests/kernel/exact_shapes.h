// SPDX-License-Identifier: MIT
// What the intersector's answers are measured against: distances from the exact shapes, and rays
// that no intersector with an error below some bound may miss. In long double, and by other
// formulas than the intersector's.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "penumbra/geometry/shape.h"

namespace penumbra::exact {

using Real = long double;
using Vec = Vec3<Real>;

struct Line {
  Vec origin, direction;
  Vec at(Real t) const { return origin + direction * t; }
};

/// Distance from p to the segment ab.
inline Real distance_to_segment(Vec p, Vec a, Vec b) {
  const Vec along = b - a;
  const Real square = length_squared(along);
  const Real s = square > 0 ? std::clamp(dot(p - a, along) / square, Real(0), Real(1)) : 0;
  return length(p - (a + along * s));
}

/// A surface of revolution: spheres, cones and rings are an axis and a profile in (height, radius).
struct Axis {
  Vec base, unit;
  Vec profile_point(Vec p) const {
    const Vec m = p - base;
    const Real height = dot(m, unit);
    return {height, length(m - unit * height), 0};
  }
};

inline Axis axis_of(const Cone& c) { return {Vec(c.base), normalize(Vec(c.apex) - Vec(c.base))}; }
inline Axis axis_of(const Ring& r) { return {Vec(r.center), normalize(Vec(r.normal))}; }
inline Real height_of(const Cone& c) { return length(Vec(c.apex) - Vec(c.base)); }

inline Real distance(const Sphere& s, Vec p) {
  return std::abs(length(p - Vec(s.center)) - Real(s.radius));
}

inline Real distance(const Ring& r, Vec p) {
  return distance_to_segment(axis_of(r).profile_point(p), {0, r.inner_radius, 0}, {0, r.radius, 0});
}

inline Real distance(const Cone& c, Vec p) {
  const Vec q = axis_of(c).profile_point(p), base{0, c.base_radius, 0},
            apex{height_of(c), c.apex_radius, 0};
  Real least = distance_to_segment(q, base, apex);
  if (c.caps == Caps::capped)
    least = std::min(
        {least, distance_to_segment(q, {}, base), distance_to_segment(q, {apex.x, 0, 0}, apex)});
  return least;
}

struct Corners {
  Vec a, b, c;
  Vec area() const { return cross(b - a, c - a); }
  /// Distance inside the edge xy, in the triangle's plane; negative outside.
  Real inside_edge(Vec p, Vec x, Vec y) const {
    return dot(cross(y - x, p - x), normalize(area())) / length(y - x);
  }
  Real inside(Vec p) const {
    return std::min({inside_edge(p, a, b), inside_edge(p, b, c), inside_edge(p, c, a)});
  }
};

inline Real distance(const Corners& t, Vec p) {
  if (t.inside(p) >= 0) return std::abs(dot(p - t.a, normalize(t.area())));
  return std::min({distance_to_segment(p, t.a, t.b), distance_to_segment(p, t.b, t.c),
                   distance_to_segment(p, t.c, t.a)});
}

/// An interval of the ray's parameter.
struct Range {
  Real from, to;
};

/// Where `value + t slope` lies in [lo, hi]; empty (from > to) if nowhere.
inline Range within(Real value, Real slope, Real lo, Real hi, Range range) {
  if (slope == 0) return value >= lo && value <= hi ? range : Range{1, 0};
  const Real a = (lo - value) / slope, b = (hi - value) / slope;
  return {std::max(range.from, std::min(a, b)), std::min(range.to, std::max(a, b))};
}

/// True where a convex function falls below -doubt in the range and rises above doubt at one of its
/// ends: it has a crossing there that an error of `doubt` can't remove.
template <typename F>
bool surely_crosses(F&& convex, Range range, Real doubt) {
  if (!(range.from < range.to)) return false;
  if (!(std::max(convex(range.from), convex(range.to)) > doubt)) return false;
  for (int i = 0; i < 100; ++i) {
    const Real third = (range.to - range.from) / 3, a = range.from + third, b = range.to - third;
    const Real at_a = convex(a), at_b = convex(b);
    if (std::min(at_a, at_b) < -doubt) return true;
    if (at_a < at_b)
      range.to = b;
    else
      range.from = a;
  }
  return false;
}

/// The part of the ray that lies within `doubt` of the plane.
inline Range near_plane(const Line& ray, Vec point, Vec unit_normal, Real doubt) {
  return within(dot(ray.origin - point, unit_normal), dot(ray.direction, unit_normal), -doubt,
                doubt, {-HUGE_VALL, HUGE_VALL});
}

/// Crosses the plane inside a ring by more than `doubt`, and so does everything near it.
inline bool surely_crosses_ring(const Line& ray, const Axis& axis, Real inner, Real outer,
                                Real doubt) {
  const Range near = near_plane(ray, axis.base, axis.unit, doubt);
  if (!(near.from > 0 && near.from <= near.to)) return false;
  const Vec a = ray.at(near.from), b = ray.at(near.to);
  if (!(std::max(axis.profile_point(a).y, axis.profile_point(b).y) < outer - doubt)) return false;
  return inner == 0 || distance_to_segment(axis.base, a, b) > inner + 2 * doubt;
}

// True where the ray (t > 0) passes so deep through the shape that it does so for any error up to
// `doubt` of either.
inline bool surely_meets(const Sphere& s, const Line& ray, Real doubt, Real far) {
  const auto height = [&](Real t) { return length(ray.at(t) - Vec(s.center)) - Real(s.radius); };
  return surely_crosses(height, {doubt / length(ray.direction), far}, doubt);
}

inline bool surely_meets(const Ring& r, const Line& ray, Real doubt, Real) {
  return surely_crosses_ring(ray, axis_of(r), r.inner_radius, r.radius, doubt);
}

inline bool surely_meets(const Cone& c, const Line& ray, Real doubt, Real far) {
  const Axis axis = axis_of(c);
  const Real height = height_of(c), slope = (Real(c.apex_radius) - Real(c.base_radius)) / height;
  const Range range = within(dot(ray.origin - axis.base, axis.unit), dot(ray.direction, axis.unit),
                             doubt, height - doubt, {doubt / length(ray.direction), far});
  const auto outside = [&](Real t) {
    const Vec q = axis.profile_point(ray.at(t));
    return (q.y - Real(c.base_radius) - slope * q.x) / std::sqrt(1 + slope * slope);
  };
  if (surely_crosses(outside, range, doubt)) return true;
  if (c.caps == Caps::open) return false;
  return surely_crosses_ring(ray, axis, 0, c.base_radius, doubt) ||
         surely_crosses_ring(ray, {Vec(c.apex), axis.unit}, 0, c.apex_radius, doubt);
}

inline bool surely_meets(const Corners& t, const Line& ray, Real doubt, Real) {
  const Range near = near_plane(ray, t.a, normalize(t.area()), doubt);
  return near.from > 0 && near.from <= near.to && t.inside(ray.at(near.from)) > doubt &&
         t.inside(ray.at(near.to)) > doubt;
}

/// Calls f with the exact form of the primitive.
template <typename F>
auto visit(const ShapeSet& shapes, ShapeRef ref, F&& f) {
  switch (ref.kind) {
    case ShapeKind::sphere: return f(shapes.spheres[ref.index]);
    case ShapeKind::cone: return f(shapes.cones[ref.index]);
    case ShapeKind::ring: return f(shapes.rings[ref.index]);
    case ShapeKind::triangle: break;
  }
  const Mesh& mesh = shapes.meshes[ref.index];
  const Triangle& corner = mesh.triangles[ref.triangle];
  return f(Corners{Vec(mesh.positions[corner[0]]), Vec(mesh.positions[corner[1]]),
                   Vec(mesh.positions[corner[2]])});
}

}  // namespace penumbra::exact
