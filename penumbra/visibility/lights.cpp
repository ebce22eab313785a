// SPDX-License-Identifier: MIT
#include "penumbra/visibility/lights.h"

#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "penumbra/geometry/centroid.h"
#include "penumbra/geometry/convex_hull.h"
#include "penumbra/scene/check_light.h"
#include "penumbra/scene/error.h"

namespace penumbra {
PolygonLight polygon_light(std::span<const Vec3f> corners) {
  PolygonLight light{{}, {corners.begin(), corners.end()}};
  if (!corners.empty()) light.center = area_centroid(corners);
  return std::get<PolygonLight>(checked_light(std::move(light)));
}

MeshLight hull_light(std::span<const Vec3f> points) {
  std::optional<MeshLight> hull = convex_hull(points);
  if (!hull)
    throw Error({}, "the points of a hull light enclose no volume",
                "give at least 4 that are finite and not in one plane, or use a polygon");
  return *std::move(hull);
}

SunLight sun_light(Vec3f towards, float diameter_deg) {
  if (!(diameter_deg >= 0 && diameter_deg < 180))
    throw Error({}, "the sun's angular diameter is outside [0, 180) degrees", "use 0.533");
  const SunLight light{towards, diameter_deg * std::numbers::pi_v<float> / 360};
  return std::get<SunLight>(checked_light(light));
}

LightShape checked_light(LightShape light) {
  if (const std::optional<LightProblem> problem = problem_of(light))
    throw Error({}, std::string("the light ") + problem->what, problem->hint);
  if (auto* disk = std::get_if<DiskLight>(&light)) disk->normal = unit(disk->normal);
  if (auto* sun = std::get_if<SunLight>(&light)) sun->direction = unit(sun->direction);
  return light;
}

}  // namespace penumbra
