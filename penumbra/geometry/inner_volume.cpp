// SPDX-License-Identifier: MIT
#include "penumbra/geometry/inner_volume.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "penumbra/geometry/sample_pattern.h"

namespace penumbra {
namespace {

constexpr std::size_t most_planes = 48;

/// The least of dot(n, x) over a box.
double least(const Box& box, Vec3d n) {
  return n.x * (n.x > 0 ? box.lo.x : box.hi.x) + n.y * (n.y > 0 ? box.lo.y : box.hi.y) +
         n.z * (n.z > 0 ? box.lo.z : box.hi.z);
}

/// Planes around a centre that shut out triangles.
class Planes {
 public:
  Planes(Vec3d center, double radius, double inward)
      : center_(center), radius_(radius), inward_(inward) {}

  const std::vector<HalfSpace>& all() const { return planes_; }

  void add_box(const Box& box) {
    for (int axis = 0; axis < 3; ++axis) {
      Vec3d n;
      n[axis] = 1;
      planes_.push_back({n, (box.hi[axis] - center_[axis]) * (1 - inward_)});
      planes_.push_back({-n, (center_[axis] - box.lo[axis]) * (1 - inward_)});
    }
  }

  bool shut_out(const Box& box) const {
    return std::any_of(planes_.begin(), planes_.end(), [&](const HalfSpace& plane) {
      return least(box, plane.normal) - dot(plane.normal, center_) >= plane.offset;
    });
  }

  bool shut_out(const FlatTriangle& triangle) const {
    return std::any_of(planes_.begin(), planes_.end(), [&](const HalfSpace& plane) {
      return near_side(triangle, plane.normal) >= plane.offset;
    });
  }

  /// False where no plane separates the triangle from the centre.
  bool add(const FlatTriangle& triangle) {
    const Vec3d a(triangle.a), b(triangle.b), c(triangle.c);
    Vec3d normal = normalize(cross(b - a, c - a));
    if (dot(normal, a - center_) < 0) normal = -normal;
    if (!(near_side(triangle, normal) >= radius_ * (1 - inward_)))
      normal = normalize(nearest_point(triangle, center_).point - center_);
    const double offset = near_side(triangle, normal) * (1 - inward_);
    if (!(offset > 0)) return false;
    planes_.push_back({normal, offset});
    return true;
  }

 private:
  double near_side(const FlatTriangle& triangle, Vec3d n) const {
    return std::min({dot(n, Vec3d(triangle.a) - center_), dot(n, Vec3d(triangle.b) - center_),
                     dot(n, Vec3d(triangle.c) - center_)});
  }

  Vec3d center_;
  double radius_, inward_;
  std::vector<HalfSpace> planes_;
};

/// Planes of a model often meet four in a point: moved inwards, each by some up to a thousandth,
/// they don't.
std::vector<HalfSpace> in_general_position(std::vector<HalfSpace> planes, std::uint64_t key) {
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const auto bits = static_cast<std::uint32_t>(hash(key, i));
    planes[i].offset *= 1 - 1e-3 * double(unit_float(bits));
  }
  return planes;
}

/// Empty if it takes too many planes.
ConvexPolyhedron inflated(const TriangleTree& triangles, Vec3d center, double radius,
                          const Box& box, double inward) {
  Planes planes(center, radius, inward);
  planes.add_box(box);
  bool is_done = true;
  triangles.walk(
      center, [&](const Box& b) { return planes.shut_out(b); },
      [&](const FlatTriangle& triangle) {
        if (planes.shut_out(triangle)) return true;
        return is_done = planes.all().size() < most_planes && planes.add(triangle);
      });
  if (!is_done) return {};
  const double bound = 4 * max_abs(Vec3d(box.hi) - Vec3d(box.lo));
  for (std::uint64_t attempt = 0; attempt < 4; ++attempt) {
    ConvexPolyhedron body = intersection(in_general_position(planes.all(), attempt), bound);
    if (!body.is_empty()) return body;
  }
  return {};
}

}  // namespace

double clearance(const TriangleTree& triangles, Vec3d center, double at_most, double slack) {
  const double square = triangles.nearest(center, at_most, slack).distance_squared;
  const double distance = std::sqrt(square) / (1 + slack);
  return std::max(0.0, distance - distance_doubt(center, distance));
}

Vec3d roomier_center(const TriangleTree& triangles, Vec3d p, double at_most) {
  constexpr int steps = 10;
  constexpr double slack = 0.02;
  NearestPoint here = triangles.nearest(p, at_most, slack);
  double step = 0.5;
  for (int i = 0; i < steps; ++i) {
    const Vec3d moved = p + (p - here.point) * step;
    const NearestPoint there = triangles.nearest(moved, at_most, slack);
    if (there.distance_squared > here.distance_squared)
      p = moved, here = there;
    else
      step *= 0.5;
  }
  return p;
}

std::optional<InnerVolume> inner_volume(const TriangleTree& triangles, Vec3d center,
                                        const Box& box) {
  const Vec3d room = min(center - Vec3d(box.lo), Vec3d(box.hi) - center);
  const double radius = clearance(triangles, center, std::min({room.x, room.y, room.z}), 0);
  if (!(radius > 0)) return {};
  // The finer planes are, the more of them a curved surface takes.
  for (const double inward : {0.01, 0.05, 0.2}) {
    ConvexPolyhedron body = inflated(triangles, center, radius, box, inward);
    if (!body.is_empty()) return InnerVolume{center, radius, std::move(body)};
  }
  return {};
}

}  // namespace penumbra
