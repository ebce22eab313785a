// SPDX-License-Identifier: MIT
// Whether a light around a point meets a shape, the point being in the outer offset then: by nested
// search instead of by separating planes.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "penumbra/geometry/light_shape.h"
#include "tests/kernel/exact_shapes.h"

namespace penumbra::exact {

// Distance from the solid; of rings from their disk, which is convex as all of these are.
inline double outside(const Sphere& s, Vec x) {
  return std::max(0.0, double(length(x - Vec(s.center)) - Real(s.radius)));
}
inline double outside(Ring r, Vec x) {
  r.inner_radius = 0;
  return double(distance(r, x));
}
inline double outside(const Corners& t, Vec x) { return double(distance(t, x)); }
inline double outside(Cone c, Vec x) {
  const Vec q = axis_of(c).profile_point(x);
  const Real height = height_of(c), share = q.x / height;
  if (share >= 0 && share <= 1 &&
      q.y <= Real(c.base_radius) * (1 - share) + Real(c.apex_radius) * share)
    return 0;
  c.caps = Caps::capped;
  return double(distance(c, x));
}

inline Vec3d point_of(const Sphere& s) { return Vec3d(s.center); }
inline Vec3d point_of(const Ring& r) { return Vec3d(r.center); }
inline Vec3d point_of(const Cone& c) { return Vec3d(c.base); }
inline Vec3d point_of(const Corners& t) { return Vec3d(t.a); }

/// origin + a u + b v: a and b from -1 to 1, of a unit disk, or not below 0 with a + b <= 1.
struct Patch {
  enum class Form { square, disk, triangle } form;
  Vec3d origin, u, v;
  double least_a() const { return form == Form::triangle ? 0 : -1; }
  double least_b(double a) const { return form == Form::triangle ? 0 : -most_b(a); }
  double most_b(double a) const {
    if (form == Form::square) return v == Vec3d{} ? 0 : 1;
    return form == Form::triangle ? 1 - a : std::sqrt(std::max(0.0, 1 - a * a));
  }
};

/// L - c: a ball, or patches, which for meshes enclose it.
struct LightBody {
  double ball_radius = 0;
  std::vector<Patch> patches;
  std::vector<Vec3d> corners;  // but for balls and disks
  bool is_solid = false;
};

inline Patch triangle_patch(Vec3d a, Vec3d b, Vec3d c) {
  return {Patch::Form::triangle, a, b - a, c - a};
}

inline LightBody disk_body(Vec3d normal, double radius) {
  const Frame<double> frame = frame_around(normal);
  return {0, {{Patch::Form::disk, {}, frame.u * radius, frame.v * radius}}, {}};
}

/// Of suns: a disk of this radius across the direction.
inline LightBody body_of(const LightShape& light, double sun_radius) {
  if (const auto* ball = std::get_if<BallLight>(&light)) return {double(ball->radius), {}, {}};
  if (const auto* disk = std::get_if<DiskLight>(&light))
    return disk_body(normalize(Vec3d(disk->normal)), double(disk->radius));
  if (const auto* sun = std::get_if<SunLight>(&light))
    return disk_body(normalize(Vec3d(sun->direction)), sun_radius);
  LightBody body;
  body.corners = corners(light);
  for (Vec3d& corner : body.corners) corner = corner - Vec3d(*center(light));
  const auto& at = body.corners;
  if (const auto* mesh = std::get_if<MeshLight>(&light)) {
    body.is_solid = true;
    for (const auto& t : mesh->triangles)
      body.patches.push_back(triangle_patch(at[t[0]], at[t[1]], at[t[2]]));
  } else if (const auto* four = std::get_if<ParallelogramLight>(&light)) {
    body.patches.push_back({Patch::Form::square, {}, Vec3d(four->u), Vec3d(four->v)});
  } else if (at.size() <= 2) {
    body.patches.push_back({Patch::Form::square, {}, at.front(), {}});
  } else {
    for (std::size_t i = 1; i + 1 < at.size(); ++i)
      body.patches.push_back(triangle_patch(at[0], at[i], at[i + 1]));
  }
  return body;
}

/// The least value of a convex function on [lo, hi]; some value where that is surely not up to
/// `enough`, or surely is. `most_fall(width)`: by how much it may fall within that width.
template <typename F, typename Fall>
double least(double lo, double hi, double enough, F&& f, Fall&& most_fall) {
  if (hi == lo) return f(lo);
  constexpr double golden = 0.6180339887498949;
  double a = hi - (hi - lo) * golden, b = lo + (hi - lo) * golden, at_a = f(a), at_b = f(b);
  for (int i = 0; i < 44; ++i) {
    const double best = std::min(at_a, at_b);
    if (best <= enough || best - most_fall(hi - lo) > enough) break;
    if (at_a < at_b) {
      hi = b, b = a, at_b = at_a;
      a = hi - (hi - lo) * golden, at_a = f(a);
    } else {
      lo = a, a = b, at_a = at_b;
      b = lo + (hi - lo) * golden, at_b = f(b);
    }
  }
  return std::min(at_a, at_b);
}

/// The same, for its value's sake.
template <typename F>
double least(double lo, double hi, double enough, F&& f) {
  return least(lo, hi, enough, f, [](double) { return HUGE_VAL; });
}

/// Whether x + t (L - c) meets the shape's hull, to 1e-8.
template <typename Shape>
bool meets_hull(const Shape& shape, const LightBody& light, Vec3d x, double t) {
  constexpr double enough = 1e-8;
  const auto at = [&](Vec3d from_center) { return outside(shape, Vec(x + from_center * t)); };
  if (light.patches.empty()) return at({}) <= t * light.ball_radius;
  for (const Patch& patch : light.patches) {
    if (at(patch.origin) > t * (length(patch.u) + length(patch.v))) continue;
    const auto over_b = [&](double a) {
      return least(patch.least_b(a), patch.most_b(a), enough,
                   [&](double b) { return at(patch.origin + patch.u * a + patch.v * b); });
    };
    const auto most_fall = [&](double width) {
      return t * (length(patch.u) * width + length(patch.v) * std::sqrt(2 * width));
    };
    if (least(patch.least_a(), 1, enough, over_b, most_fall) <= enough) return true;
  }
  if (!light.is_solid) return false;
  const Vec3d inner = (point_of(shape) - x) / t;  // the light may have swallowed the shape
  return std::all_of(light.patches.begin(), light.patches.end(), [&](const Patch& patch) {
    return dot(cross(patch.u, patch.v), inner - patch.origin) <= 0;
  });
}

/// The farthest distance from the ring's centre of what x + t (L - c) has in its plane.
inline double farthest_in_plane(const Ring& ring, const LightBody& light, Vec3d x, double t) {
  const Vec3d n = normalize(Vec3d(ring.normal)), from = x - Vec3d(ring.center);
  const auto height = [&](Vec3d l) { return dot(from + l * t, n); };
  const auto radius = [&](Vec3d l) { return length(from + l * t - n * height(l)); };
  if (light.patches.empty()) {
    const double r = t * light.ball_radius, h = height({});
    return radius({}) + std::sqrt(std::max(0.0, (r - h) * (r + h)));
  }
  double farthest = 0;
  for (const Vec3d& a : light.corners)
    for (const Vec3d& b : light.corners) {
      const double up = height(a), down = height(b);
      if (up >= 0 && down <= 0 && up > down)
        farthest = std::max(farthest, radius(a + (b - a) * (up / (up - down))));
    }
  if (!light.corners.empty()) return farthest;
  const Patch& disk = light.patches.front();  // a chord of it, most likely
  const double along_u = dot(disk.u, n) * t, along_v = dot(disk.v, n) * t,
               square = along_u * along_u + along_v * along_v, middle = -height({}) / square,
               half = std::sqrt(std::max(0.0, 1 - middle * middle * square) / square);
  for (const double s : {half, -half})
    farthest = std::max(farthest, radius(disk.u * (middle * along_u - s * along_v) +
                                         disk.v * (middle * along_v + s * along_u)));
  return farthest;
}

template <typename Shape>
bool in_offset(const Shape& shape, const LightBody& light, Vec3d x, double t) {
  return meets_hull(shape, light, x, t);
}
inline bool in_offset(const Ring& ring, const LightBody& light, Vec3d x, double t) {
  return meets_hull(ring, light, x, t) &&
         farthest_in_plane(ring, light, x, t) >= double(ring.inner_radius);
}

}  // namespace penumbra::exact
