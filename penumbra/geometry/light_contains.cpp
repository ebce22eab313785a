// SPDX-License-Identifier: MIT
// `contains` of each light shape. Comparisons are written so that NaN means inside.
#include <cmath>
#include <limits>
#include <span>

#include "penumbra/geometry/light_shape.h"
#include "penumbra/geometry/polygon.h"

namespace penumbra {
namespace {

/// What float cannot tell of a distance between p and something of this size.
double float_doubt(Vec3f p, double size) {
  return (max_abs(Vec3d(p)) + size) * std::numeric_limits<float>::epsilon();
}

bool holds(const PointLight&, Vec3f) { return false; }
bool holds(const SunLight&, Vec3f) { return false; }

bool holds(const BallLight& light, Vec3f p) {
  const double distance = length(Vec3d(light.center) - Vec3d(p));
  return !(distance > light.radius + float_doubt(p, light.radius));
}

bool holds(const ParallelogramLight& light, Vec3f p) {
  const Vec3d u(light.u), v(light.v), w = Vec3d(p) - Vec3d(light.center);
  const Vec3d n = cross(u, v);
  const double doubt = float_doubt(p, length(u) + length(v)), area = length(n);
  // w = a u + b v + z n / |n|; a unit of a (of b) moves p by |n| / |v| (by |n| / |u|) off the edge.
  const double a = dot(cross(w, v), n) / (area * area), b = dot(cross(u, w), n) / (area * area);
  const double z = dot(w, n) / area;
  return !(std::abs(z) > doubt) && !((std::abs(a) - 1) * area > doubt * length(v)) &&
         !((std::abs(b) - 1) * area > doubt * length(u));
}

bool holds(const DiskLight& light, Vec3f p) {
  const Vec3d normal(light.normal), n = normal / length(normal);
  const Vec3d w = Vec3d(p) - Vec3d(light.center);
  const double z = dot(w, n), doubt = float_doubt(p, light.radius);
  return !(std::abs(z) > doubt) && !(length(w - n * z) > light.radius + doubt);
}

bool holds(const LineLight& light, Vec3f p) {
  const Vec3d half(light.half), w = Vec3d(p) - Vec3d(light.center);
  const double along = dot(w, half) / length_squared(half);
  const double s = along > 1 ? 1 : along < -1 ? -1 : along;
  return !(length(w - half * s) > float_doubt(p, length(half)));
}

struct Extent {
  double doubt;
  bool is_clear;  ///< p lies outside the box of the corners, by more than the doubt
};

/// What nearly all points need: the rest of `contains` is for those near the light.
Extent extent_of(std::span<const Vec3f> corners, Vec3f p) {
  Vec3d lo = Vec3d(corners[0]) - Vec3d(p), hi = lo;
  double sum = 0;  // NaN where a corner has one
  for (const Vec3f corner : corners) {
    const Vec3d w = Vec3d(corner) - Vec3d(p);
    lo = min(lo, w), hi = max(hi, w);
    sum += w.x + w.y + w.z;
  }
  const double doubt = float_doubt(p, length(hi - lo));
  const bool is_clear = lo.x > doubt || lo.y > doubt || lo.z > doubt || hi.x < -doubt ||
                        hi.y < -doubt || hi.z < -doubt;
  return {doubt, is_clear && !std::isnan(sum)};
}

/// p lies beyond the plane that touches the corners on this side.
bool is_beyond(std::span<const Vec3f> corners, Vec3d outward, Vec3f p, double doubt) {
  double least = std::numeric_limits<double>::infinity();
  for (const Vec3f corner : corners) {
    const double height = dot(outward, Vec3d(p) - Vec3d(corner));
    if (!(height >= least)) least = height;  // NaN stays: nothing is less than it
    if (std::isnan(least)) return false;
  }
  return least > doubt * length(outward);
}

// Planes are those that touch the actual corners, so that slightly bent polygons, and meshes with
// a dent in the last digit, hold all of their hull.
bool holds(const PolygonLight& light, Vec3f p) {
  const std::span<const Vec3f> corners = light.corners;
  if (corners.empty()) return true;
  const Extent extent = extent_of(corners, p);
  if (extent.is_clear) return false;
  const Vec3d n = normalize(polygon_normal(corners));
  if (is_beyond(corners, n, p, extent.doubt) || is_beyond(corners, -n, p, extent.doubt))
    return false;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3d edge = Vec3d(corners[(i + 1) % corners.size()]) - Vec3d(corners[i]);
    if (is_beyond(corners, cross(edge, n), p, extent.doubt)) return false;
  }
  return true;
}

bool holds(const MeshLight& light, Vec3f p) {
  const std::span<const Vec3f> corners = light.corners;
  if (corners.empty()) return true;
  const Extent extent = extent_of(corners, p);
  if (extent.is_clear) return false;
  for (const auto& t : light.triangles) {
    const Vec3d a(corners[t[0]]), b(corners[t[1]]), c(corners[t[2]]);
    if (is_beyond(corners, cross(b - a, c - a), p, extent.doubt)) return false;
  }
  return true;
}

}  // namespace

bool contains(const LightShape& light, Vec3f p) {
  return std::visit([&](const auto& shape) { return holds(shape, p); }, light);
}

}  // namespace penumbra
