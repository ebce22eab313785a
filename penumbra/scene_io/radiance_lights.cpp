// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/radiance_lights.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "penumbra/geometry/centroid.h"
#include "penumbra/geometry/polygon.h"
#include "penumbra/scene/check_light.h"
#include "penumbra/scene_io/exposure.h"
#include "penumbra/scene_io/light_emitters.h"

namespace penumbra {
namespace {

constexpr double pi = std::numbers::pi;

/// Radiant intensity along the normal: radiance times area.
Light flat_light(LightShape shape, Color radiance, double area, Vec3d normal) {
  return {std::move(shape), scaled(radiance, area), Falloff::inverse_square,
          Beam{Vec3f(normal), 0, 0}};
}

std::optional<Light> polygon_light(const RadianceShape& shape, Color radiance) {
  PolygonLight polygon;
  for (Vec3d c : shape.corners) polygon.corners.emplace_back(c);
  if (shape.faces_inward) std::reverse(polygon.corners.begin(), polygon.corners.end());
  polygon.center = area_centroid(polygon.corners);
  const Vec3d normal = polygon_normal(polygon.corners);
  const double area = 0.5 * length(normal);
  if (!(area > 0) || problem_of(polygon)) return std::nullopt;
  return flat_light(std::move(polygon), radiance, area, normalize(normal));
}

std::optional<Light> unbeamed(const RadianceShape& shape, Color radiance) {
  switch (shape.kind) {
    case RadianceShape::Kind::sphere:
      if (shape.faces_inward) return std::nullopt;
      return Light{BallLight{Vec3f(shape.a), static_cast<float>(shape.r0)},
                   scaled(radiance, pi * shape.r0 * shape.r0), Falloff::inverse_square,
                   std::nullopt};
    case RadianceShape::Kind::ring: {
      if (shape.r0 > 0) return std::nullopt;
      const Vec3d normal = shape.faces_inward ? -shape.b : shape.b;
      return flat_light(DiskLight{Vec3f(shape.a), Vec3f(normal), static_cast<float>(shape.r1)},
                        radiance, pi * shape.r1 * shape.r1, normal);
    }
    case RadianceShape::Kind::polygon: return polygon_light(shape, radiance);
    case RadianceShape::Kind::cone:
    case RadianceShape::Kind::none: break;
  }
  return std::nullopt;
}

/// A picture shows pi times radiance, as it shows irradiance on white; times the lights' factor.
/// A sky alone is brought to just below white.
double exposure(Scene& scene, const RadianceLights& lights) {
  if (!scene.lights.empty()) return pi * balance_lights(scene);
  const double sky = static_cast<double>(std::max(max_abs(lights.sky_above.value_or(Color{})),
                                                  max_abs(lights.sky_below.value_or(Color{}))));
  return sky > 0 ? 0.8 / sky : 1;
}

}  // namespace

std::optional<Light> light_of(const RadianceShape& shape, const RadianceLook& look,
                              Vec3d spot_direction) {
  std::optional<Light> light = unbeamed(shape, look.radiance);
  if (!light || !look.spot_deg) return light;
  const double half_rad = std::min(*look.spot_deg, 360.0) * pi / 360;
  const auto cosine = static_cast<float>(std::cos(half_rad));
  light->beam = Beam{Vec3f(normalize(spot_direction)), cosine, cosine};
  return light;
}

void add_source(Scene& scene, RadianceLights& lights, const RadianceLook& look, Vec3d direction,
                double angle_deg) {
  const Vec3d towards = normalize(direction);
  const double half_rad = angle_deg * pi / 360;
  if (look.emission != RadianceEmission::glow && angle_deg < 180) {
    // What a surface that faces the middle of a cone of this radiance gets.
    const double irradiance = pi * std::sin(half_rad) * std::sin(half_rad);
    scene.lights.push_back({SunLight{Vec3f(towards), static_cast<float>(half_rad)},
                            scaled(look.radiance, irradiance), Falloff::none, std::nullopt});
    return;
  }
  constexpr double nearly_half_deg = 150;
  if (angle_deg < nearly_half_deg) return;  // a patch of sky that is only seen
  if (angle_deg > 270 || towards.z >= 0) lights.sky_above = look.radiance;
  if (angle_deg > 270 || towards.z < 0) lights.sky_below = look.radiance_below;
}

void finish_lights(Scene& scene, RadianceLights lights, Warnings& warnings) {
  finish_polygons(scene.shapes, std::move(lights.glowing));
  light_emitters(scene, warnings);
  const bool has_lights = !scene.lights.empty();
  const double factor = exposure(scene, lights);
  for (const auto& [material, radiance] : lights.seen)
    scene.materials[material].emission = radiance;
  for (Material& material : scene.materials) material.emission = scaled(material.emission, factor);
  if (!lights.sky_above && !lights.sky_below) {
    if (has_lights) scene.background = Color{};
    return;
  }
  const Color above = scaled(lights.sky_above.value_or(Color{}), factor);
  const Color below = scaled(lights.sky_below.value_or(Color{}), factor);
  scene.background = lights.sky_above ? above : below;
  // From everywhere alike: the mean of both halves. Without lights the studio's light the scene.
  if (has_lights) scene.ambient = (above + below) * 0.5f;
}

}  // namespace penumbra
