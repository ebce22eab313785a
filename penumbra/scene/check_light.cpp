// SPDX-License-Identifier: MIT
#include "penumbra/scene/check_light.h"

#include <algorithm>
#include <map>
#include <numbers>
#include <span>
#include <utility>

#include "penumbra/geometry/centroid.h"
#include "penumbra/geometry/polygon.h"
#include "penumbra/scene/coordinates.h"

namespace penumbra {
namespace {

using Problem = std::optional<LightProblem>;

constexpr LightProblem bad_coordinate{"has a coordinate that is not a number within ±1e15",
                                      "mend the number, or scale the scene"};
constexpr LightProblem bad_radius{"has a radius that is not above 0 and within 1e15",
                                  "give it a size, or leave it out"};

Problem problem_with(const PointLight&) { return {}; }

Problem problem_with(const BallLight& light) {
  if (!is_radius(light.radius)) return bad_radius;
  return {};
}

Problem problem_with(const ParallelogramLight& light) {
  const Vec3d u = normalize(Vec3d(light.u)), v = normalize(Vec3d(light.v));
  if (is_coordinate(light.u) && is_coordinate(light.v) && length(cross(u, v)) > 1e-6) return {};
  return LightProblem{"is no parallelogram", "give two half edges that are not parallel"};
}

Problem problem_with(const DiskLight& light) {
  if (!is_radius(light.radius)) return bad_radius;
  if (!is_finite(light.normal) || normalize(light.normal) == Vec3f{})
    return LightProblem{"has no normal", "give it a direction that is not 0"};
  return {};
}

Problem problem_with(const LineLight& light) {
  if (!is_coordinate(light.half)) return bad_coordinate;
  if (light.half == Vec3f{}) return LightProblem{"has no length", "use point for none"};
  return {};
}

/// What rounding to float may have done to corners, twice over.
double tolerance(std::span<const Vec3f> corners) {
  float largest = 0;
  for (const Vec3f corner : corners) largest = std::max(largest, max_abs(corner));
  return 0x1p-22 * static_cast<double>(largest);
}

double diameter(std::span<const Vec3f> corners) {
  Box box;
  for (const Vec3f corner : corners) box.add(corner);
  return length(Vec3d(box.hi) - Vec3d(box.lo));
}

/// The first problem of corners as such, each a coordinate.
Problem problem_with_corners(std::span<const Vec3f> corners) {
  for (const Vec3f corner : corners)
    if (!is_coordinate(corner)) return bad_coordinate;
  return {};
}

Problem problem_with(const PolygonLight& light) {
  const std::span<const Vec3f> corners = light.corners;
  if (corners.size() < 3) return LightProblem{"has fewer than 3 corners", "use line for 2"};
  if (const Problem problem = problem_with_corners(corners)) return problem;
  const Vec3d normal = polygon_normal(corners), n = normalize(normal);
  const double size = diameter(corners), slack = tolerance(corners) + 1e-3 * size;
  const auto at = [&](std::size_t i) { return Vec3d(corners[i % corners.size()]); };
  // Height over the line through two corners, when it is the third.
  const auto is_left = [&](Vec3d a, Vec3d b, Vec3d c) {
    return dot(cross(b - a, c - a), n) >= -slack * length(b - a);
  };
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (std::abs(dot(n, at(i) - Vec3d(light.center))) > slack)
      return LightProblem{"is not planar", "move its corners into one plane, or use mesh"};
    if (!is_left(at(i), at(i + 1), at(i + 2)) || !is_left(at(0), at(i), at(i + 1)))
      return LightProblem{"is not convex with its corners in order",
                          "give them in order around it, or split it"};
  }
  for (std::size_t i = 0; i < corners.size(); ++i)
    if (!is_left(at(i), at(i + 1), Vec3d(light.center)))
      return LightProblem{"has its centre outside", "take the centroid of its area"};
  if (!(length(normal) > 1e-7 * size * size + tolerance(corners) * size))
    return LightProblem{"has no area, or its corners are out of order",
                        "give them in order around it; use line for corners in a row"};
  return {};
}

/// Every edge belongs to two triangles, which pass it in opposite directions.
bool is_closed(std::span<const Triangle> triangles) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> passes;
  for (const Triangle& t : triangles)
    for (int i = 0; i < 3; ++i) ++passes[{t[i], t[(i + 1) % 3]}];
  return std::all_of(passes.begin(), passes.end(), [&](const auto& edge) {
    const auto back = passes.find({edge.first.second, edge.first.first});
    return edge.second == 1 && back != passes.end() && back->second == 1;
  });
}

Problem problem_with(const MeshLight& light) {
  const std::span<const Vec3f> corners = light.corners;
  constexpr const char* hull = "give the convex hull of its corners";
  if (corners.size() < 4) return LightProblem{"has fewer than 4 corners", "use polygon for 3"};
  if (const Problem problem = problem_with_corners(corners)) return problem;
  for (const Triangle& t : light.triangles)
    if (std::max({t[0], t[1], t[2]}) >= corners.size())
      return LightProblem{"has a triangle with a corner that does not exist",
                          "number corners from 0"};
  if (light.triangles.empty() || !is_closed(light.triangles))
    return LightProblem{"is not closed", hull};
  const double size = diameter(corners), slack = tolerance(corners) + 1e-3 * size;
  const double volume = six_volumes(corners, light.triangles);
  if (!(volume > 1e-9 * size * size * size))
    return LightProblem{"has no volume, or its triangles look inwards",
                        "give corners that are not in one plane"};
  for (const Triangle& t : light.triangles) {
    const Vec3d a(corners[t[0]]), b(corners[t[1]]), c(corners[t[2]]);
    const Vec3d n = normalize(cross(b - a, c - a));
    const auto is_beyond = [&](Vec3f corner) { return dot(n, Vec3d(corner) - a) > slack; };
    if (std::any_of(corners.begin(), corners.end(), is_beyond) || is_beyond(light.center))
      return LightProblem{"is not convex with its centre inside", hull};
  }
  return {};
}

Problem problem_with(const SunLight& light) {
  if (!is_finite(light.direction) || normalize(light.direction) == Vec3f{})
    return LightProblem{"has no direction", "point it at the sun"};
  if (!(light.half_angle_rad >= 0 && light.half_angle_rad < std::numbers::pi_v<float> / 2))
    return LightProblem{"has an angular diameter outside [0, 180) degrees", "use 0.53"};
  return {};
}

}  // namespace

std::optional<LightProblem> problem_of(const LightShape& light) {
  if (const std::optional<Vec3f> middle = center(light); middle && !is_coordinate(*middle))
    return bad_coordinate;
  return std::visit([](const auto& shape) { return problem_with(shape); }, light);
}

bool is_too_large(const LightShape& light, double extent) {
  if (std::holds_alternative<BallLight>(light)) return false;
  const std::optional<Box> box = bounds(light);
  return box && box->largest_extent() > 1e6 * extent;
}

std::optional<LightProblem> problem_of(const Beam& beam, const LightShape& light) {
  if (std::holds_alternative<SunLight>(light))
    return LightProblem{"is a sun with a beam", "leave the beam out: a sun shines everywhere"};
  if (!is_finite(beam.axis) || normalize(beam.axis) == Vec3f{})
    return LightProblem{"has a beam without direction", "give it an axis that is not 0"};
  if (!(beam.cos_none >= -1 && beam.cos_none <= beam.cos_full && beam.cos_full <= 1))
    return LightProblem{"has a beam whose angles are out of order or outside [0, 180] degrees",
                        "give the angle of full light first, then that of none"};
  return {};
}

}  // namespace penumbra
