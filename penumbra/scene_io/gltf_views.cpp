// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/gltf_views.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <string>
#include <vector>

#include "penumbra/scene/coordinates.h"

namespace penumbra {
namespace {

/// Seen from the earth.
constexpr double sun_diameter_rad = 0.53 * std::numbers::pi / 180;

void set_aspect(Camera& camera, double aspect) {
  if (!(aspect > 0.05 && aspect < 20)) return;  // none given, or no shape of a picture
  camera.width = static_cast<std::uint32_t>(std::lround(camera.height * aspect));
}

/// False where the numbers make no picture.
bool set_lens(const GltfDocument& gltf, const Json& json, Camera& camera) {
  if (const Json* lens = member(json, "perspective")) {
    camera.fov_deg = number_of(gltf, *lens, "yfov", 0) * 180 / std::numbers::pi;
    camera.near = number_of(gltf, *lens, "znear", 0);
    set_aspect(camera, number_of(gltf, *lens, "aspectRatio", 0));
    return camera.fov_deg > 0 && camera.fov_deg < 180;
  }
  const Json* lens = member(json, "orthographic");
  if (!lens) return false;
  // Halves of the picture. Signs would mirror it, which the specification leaves undefined.
  const double x = std::abs(number_of(gltf, *lens, "xmag", 0)),
               y = std::abs(number_of(gltf, *lens, "ymag", 0));
  camera.parallel_height = 2 * y;
  camera.near = number_of(gltf, *lens, "znear", 0);
  set_aspect(camera, x / y);
  return camera.parallel_height > 0 && camera.parallel_height <= largest_coordinate;
}

/// The first of these numbers in the extras of the light, then of the node, if it is above 0.
std::optional<double> extra(const Json& light, const Json& node,
                            std::initializer_list<const char*> names) {
  for (const Json* of : {&light, &node}) {
    const Json* extras = member(*of, "extras");
    if (!extras) continue;
    for (const char* name : names) {
      const Json* value = member(*extras, name);
      if (value && value->is_number() && value->get<double>() > 0) return value->get<double>();
    }
  }
  return std::nullopt;
}

void set_sun(const Json& json, const Json& node, const Transform& world, Light& light) {
  const double diameter = extra(json, node, {"angle", "angular_diameter"}).value_or(0);
  const bool is_angle = diameter > 0 && diameter < std::numbers::pi;
  light.shape = SunLight{Vec3f(normalize(world.z_axis)),
                         static_cast<float>((is_angle ? diameter : sun_diameter_rad) / 2)};
}

/// glTF's angles are from the axis; without them the outer one is 45 degrees, and all is soft.
Beam beam_of(const GltfDocument& gltf, const Json& json, Vec3d axis, Warnings& warnings) {
  static const Json empty = Json::object();
  const Json* found = member(json, "spot");
  const Json& spot = found ? *found : empty;
  double inner = number_of(gltf, spot, "innerConeAngle", 0);
  double outer = number_of(gltf, spot, "outerConeAngle", std::numbers::pi / 4);
  if (!(inner >= 0 && inner <= outer && outer > 0 && outer <= std::numbers::pi)) {
    warnings.add("a spot light's angles are out of order; the usual 0 and 45 degrees are taken");
    inner = 0, outer = std::numbers::pi / 4;
  }
  return {Vec3f(axis), static_cast<float>(std::cos(inner)), static_cast<float>(std::cos(outer))};
}

void set_lamp(const Json& json, const Json& node, const Transform& world, Light& light) {
  const Vec3f center(world.offset);
  const auto radius = static_cast<float>(
      extra(json, node, {"radius", "light_radius", "lightRadius", "shadow_soft_size"}).value_or(0));
  light.falloff = Falloff::inverse_square;
  light.shape = is_radius(radius) ? LightShape(BallLight{center, radius}) : PointLight{center};
}

}  // namespace

std::optional<Camera> read_camera(const GltfDocument& gltf, std::size_t index,
                                  const Transform& world, Warnings& warnings) {
  Camera camera;
  camera.from = world.offset;
  camera.at = world.offset - normalize(world.z_axis);
  camera.up = normalize(world.y_axis);
  const bool makes_picture = set_lens(gltf, element(gltf, "cameras", index), camera) &&
                             length(cross(world.z_axis, world.y_axis)) > 0;
  if (!makes_picture) {
    warnings.add("a camera with no field of view or direction is not read");
    return std::nullopt;
  }
  if (!(camera.near >= 0 && camera.near <= largest_coordinate)) camera.near = 0;
  return camera;
}

std::optional<Light> read_light(const GltfDocument& gltf, std::size_t index, const Json& node,
                                const Transform& world, Warnings& warnings) {
  const Json* lists = extension(gltf.root, "KHR_lights_punctual");
  const Json* lights = lists ? member(*lists, "lights") : nullptr;
  if (!lights || !lights->is_array() || index >= lights->size())
    gltf.fail(fmt::format("light {} does not exist", index));
  const Json& json = (*lights)[index];
  const auto color = numbers_of(gltf, json, "color", 3).value_or(std::vector{1.0, 1.0, 1.0});
  const double intensity = number_of(gltf, json, "intensity", 1);
  Light light;
  light.intensity = max(Color(Vec3d{color[0], color[1], color[2]} * intensity), Color{});
  if (!(max_abs(light.intensity) > 0)) return std::nullopt;

  const std::string type = string_of(gltf, json, "type");
  const Vec3d axis = -normalize(world.z_axis);
  if (type == "point") {
    set_lamp(json, node, world, light);
    return light;
  }
  if (type != "directional" && type != "spot") {
    warnings.add(fmt::format("a light of type '{:.20}' is not read", type));
    return std::nullopt;
  }
  if (axis == Vec3d{}) {
    warnings.add("a light whose node leaves it no direction is not read");
    return std::nullopt;
  }
  if (type == "directional") {
    set_sun(json, node, world, light);
  } else {
    set_lamp(json, node, world, light);
    light.beam = beam_of(gltf, json, axis, warnings);
  }
  return light;
}

}  // namespace penumbra
