// SPDX-License-Identifier: MIT
// `solid_angle` of each light shape.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "penumbra/geometry/light_shape.h"
#include "penumbra/geometry/parallelogram.h"
#include "penumbra/geometry/seen_disk.h"
#include "penumbra/geometry/seen_triangles.h"

namespace penumbra {
namespace {

constexpr double pi = std::numbers::pi;

double angle_of(const PointLight&, Vec3f) { return 0; }
double angle_of(const LineLight&, Vec3f) { return 0; }

double angle_of(const BallLight& light, Vec3f p) {
  if (contains(light, p)) return 4 * pi;
  const double distance = length(Vec3d(light.center) - Vec3d(p)), r = light.radius;
  const double sine = r / distance;
  const double cosine = std::sqrt((distance - r) * (distance + r)) / distance;
  return 2 * pi * sine * sine / (1 + cosine);
}

double angle_of(const ParallelogramLight& light, Vec3f p) {
  return contains(light, p) ? 2 * pi : solid_angle(seen_from(light, p));
}

double angle_of(const DiskLight& light, Vec3f p) {
  return contains(light, p) ? 2 * pi : solid_angle(seen_from(light, p));
}

double angle_of(const PolygonLight& light, Vec3f p) {
  if (contains(light, p)) return 2 * pi;
  double sum = 0;
  for (std::size_t i = 0; i < triangle_count(light); ++i)
    sum += solid_angle(seen_triangle(light, i, p));
  return std::min(sum, 2 * pi);
}

double angle_of(const MeshLight& light, Vec3f p) {
  if (contains(light, p)) return 4 * pi;
  double sum = 0;
  for (std::size_t i = 0; i < triangle_count(light); ++i) {
    const SeenTriangle triangle = seen_triangle(light, i, p);
    if (triangle.volume() < 0) sum += solid_angle(triangle);
  }
  return std::min(sum, 2 * pi);
}

double angle_of(const SunLight& light, Vec3f) {
  const double s = std::sin(0.5 * light.half_angle_rad);
  return 4 * pi * s * s;
}

}  // namespace

double solid_angle(const LightShape& light, Vec3f p) {
  return std::visit([&](const auto& shape) { return angle_of(shape, p); }, light);
}

}  // namespace penumbra
