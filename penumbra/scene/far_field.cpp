// SPDX-License-Identifier: MIT
#include "penumbra/scene/far_field.h"

#include <algorithm>
#include <cmath>
#include <variant>
#include <vector>

#include "penumbra/geometry/polygon.h"
#include "penumbra/geometry/reduced_hull.h"

namespace penumbra {
namespace {

constexpr std::size_t count = std::tuple_size_v<FarField>;

const std::vector<Vec3d>& directions() {
  static const std::vector<Vec3d> spread = spread_directions(count);
  return spread;
}

double sum_of(Vec3d color) { return color.x + color.y + color.z; }

/// By the area that a shape turns to a direction, over that which makes the intensity.
double share(const auto&, Vec3d) { return 1; }
double share(const ParallelogramLight& light, Vec3d direction) {
  return std::abs(dot(normalize(cross(Vec3d(light.u), Vec3d(light.v))), direction));
}
double share(const DiskLight& light, Vec3d direction) {
  return std::abs(dot(normalize(Vec3d(light.normal)), direction));
}
double share(const PolygonLight& light, Vec3d direction) {
  return std::abs(dot(normalize(polygon_normal(light.corners)), direction));
}
double share(const MeshLight& light, Vec3d direction) {
  double seen = 0;
  for (const Triangle& t : light.triangles) {
    const Vec3d a(light.corners[t[0]]), b(light.corners[t[1]]), c(light.corners[t[2]]);
    seen += std::max(0.0, 0.5 * dot(cross(b - a, c - a), direction));
  }
  return seen / (0.25 * surface_area(light));
}

}  // namespace

FarField field_of(std::span<const GlowingTriangle> triangles, Sides sides, Vec3d power) {
  std::array<double, count> seen{};
  for (const GlowingTriangle& t : triangles) {
    const Vec3d normal = normal_of(t);
    for (std::size_t i = 0; i < count; ++i) {
      const double cosine = dot(normal, directions()[i]);
      seen[i] += sides == Sides::front ? std::max(0.0, cosine) : std::abs(cosine);
    }
  }
  // Power over pi is four times the mean intensity.
  double sum = 0;
  for (const double of_it : seen) sum += of_it;
  const double scale = sum > 0 ? 0.25 * sum_of(power) * static_cast<double>(count) / sum : 0;
  FarField field;
  for (std::size_t i = 0; i < count; ++i) field[i] = static_cast<float>(seen[i] * scale);
  return field;
}

FarField field_of(const Light& light) {
  FarField field;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3d direction = directions()[i];
    const bool is_dark = light.beam && !(dot(Vec3d(light.beam->axis), direction) > 0);
    const double part =
        is_dark
            ? 0
            : std::visit([&](const auto& shape) { return share(shape, direction); }, light.shape);
    field[i] = static_cast<float>(part * sum_of(Vec3d(light.intensity)));
  }
  return field;
}

void add(FarField& sum, const FarField& field) {
  for (std::size_t i = 0; i < count; ++i) sum[i] += field[i];
}

double misdirected(const FarField& wanted, const FarField& is) {
  double difference = 0;
  for (std::size_t i = 0; i < count; ++i)
    difference += std::abs(static_cast<double>(wanted[i]) - static_cast<double>(is[i]));
  return 0.5 * difference;
}

double total(const FarField& field) {
  double sum = 0;
  for (const float of_it : field) sum += static_cast<double>(of_it);
  return sum;
}

}  // namespace penumbra
