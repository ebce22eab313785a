// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/pbrt_lights.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "penumbra/scene_io/numbers.h"
#include "penumbra/scene_io/pbrt_spectra.h"
#include "penumbra/scene_io/pbrt_textures.h"
#include "penumbra/scene_io/texture_io.h"

namespace penumbra {
namespace {

constexpr double pi = std::numbers::pi;

/// The colour of a light, times `scale`; white where the file gives none.
Color light_color(const PbrtScene& pbrt, const PbrtParams& params, std::string_view name) {
  const auto color = pbrt_color(params.find(name), SpectrumOf::light, pbrt.source.path);
  return max(scaled(color.value_or(Color{1, 1, 1}), params.number("scale", 1)), Color{});
}

/// "power" (of the whole light) over `share`, the power of one of intensity or radiance 1.
double power_factor(const PbrtParams& params, double share) {
  const double power = params.number("power", -1);
  return power > 0 && share > 0 ? power / share : 1;
}

void add(PbrtScene& pbrt, Light light) {
  if (max_abs(light.intensity) > 0) pbrt.scene.lights.push_back(std::move(light));
}

Light point_light(const PbrtScene& pbrt, const PbrtParams& params) {
  Light light;
  light.shape = PointLight{Vec3f(apply_point(pbrt.graphics.to_world, params.point("from", {})))};
  light.intensity = light_color(pbrt, params, "I");
  light.falloff = Falloff::inverse_square;
  return light;
}

/// A beam along an axis, from full at one angle to none at another.
Beam beam_of(Vec3d axis, double full_deg, double none_deg, PbrtPlace place) {
  axis = normalize(axis);
  if (axis == Vec3d{})
    throw Error(place, "a light shines nowhere", "give it `from` and `to` that differ");
  const double full = std::clamp(full_deg, 0.0, 180.0), none = std::clamp(none_deg, 0.0, 180.0);
  return {Vec3f(axis), static_cast<float>(std::cos(full * pi / 180)),
          static_cast<float>(std::cos(none * pi / 180))};
}

void add_point(PbrtScene& pbrt, const PbrtParams& params) {
  Light light = point_light(pbrt, params);
  light.intensity = scaled(light.intensity, power_factor(params, 4 * pi));
  add(pbrt, std::move(light));
}

void add_spot(PbrtScene& pbrt, const PbrtParams& params) {
  Light light = point_light(pbrt, params);
  const Vec3d way = params.point("to", {0, 0, 1}) - params.point("from", {});
  const double angle = params.number("coneangle", 30), delta = params.number("conedeltaangle", 5);
  light.beam =
      beam_of(apply_direction(pbrt.graphics.to_world, way), angle - delta, angle, params.place());
  const double full = light.beam->cos_full, none = light.beam->cos_none;
  light.intensity =
      scaled(light.intensity, power_factor(params, 2 * pi * ((1 - full) + (full - none) / 2)));
  add(pbrt, std::move(light));
}

/// A picture thrown along z: as a spot of its field of view.
void add_projection(PbrtScene& pbrt, const PbrtParams& params) {
  Light light = point_light(pbrt, params);
  const double half_fov = params.number("fov", 90) / 2;
  light.beam = beam_of(apply_direction(pbrt.graphics.to_world, {0, 0, 1}), half_fov, half_fov + 5,
                       params.place());
  light.intensity = scaled(light.intensity, power_factor(params, 4 * pi));
  add(pbrt, std::move(light));
}

void add_distant(PbrtScene& pbrt, const PbrtParams& params) {
  const Vec3d way = params.point("from", {}) - params.point("to", {0, 0, 1});
  const Vec3d direction = normalize(apply_direction(pbrt.graphics.to_world, way));
  if (direction == Vec3d{})
    throw Error(params.place(), "a distant light shines nowhere",
                "give it `from` and `to` that differ");
  Light light;
  light.shape = SunLight{Vec3f(direction), 0};
  const double illuminance = params.number("illuminance", -1);
  light.intensity = scaled(light_color(pbrt, params, "L"), illuminance > 0 ? illuminance : 1);
  add(pbrt, std::move(light));
}

/// The mean of a map; pbrt's maps have equal areas everywhere. White where it cannot be read.
Color map_color(PbrtScene& pbrt, const std::string& name, PbrtPlace place) {
  constexpr std::size_t most_pixels = std::size_t{1} << 26;
  const auto path = find_beside(pbrt.source.path, name);
  std::optional<Texture> map;
  if (path) map = decode_texture(load(*path).bytes, ImageCoding::srgb, most_pixels);
  const char* fate =
      "an infinite light's map is not drawn: its mean colour is all around, without shadows";
  if (!map) fate = "an infinite light's map cannot be read; white is all around, without shadows";
  pbrt.warnings.add(fate, place);
  return map ? mean_color(*map) : Color{1, 1, 1};
}

void add_infinite(PbrtScene& pbrt, const PbrtParams& params) {
  Color radiance = light_color(pbrt, params, "L");
  if (const std::string file = params.text("filename", ""); !file.empty())
    radiance = radiance * map_color(pbrt, file, params.place());
  else
    pbrt.warnings.add("an infinite light is the same all around, without shadows", params.place());
  if (const double illuminance = params.number("illuminance", -1); illuminance > 0)
    radiance = scaled(radiance, illuminance / pi);
  pbrt.surroundings.radiance += radiance;
  pbrt.surroundings.place = params.place();
}

}  // namespace

void add_pbrt_light(PbrtScene& pbrt, const PbrtDefinition& definition) {
  const PbrtParams& params = definition.params;
  const std::string& kind = definition.kind;
  if (kind == "point") {
    add_point(pbrt, params);
  } else if (kind == "spot") {
    add_spot(pbrt, params);
  } else if (kind == "distant") {
    add_distant(pbrt, params);
  } else if (kind == "infinite") {
    add_infinite(pbrt, params);
  } else if (kind == "goniometric") {
    pbrt.warnings.add("a goniometric light shines alike in all directions", params.place());
    params.has("filename");
    add_point(pbrt, params);
  } else if (kind == "projection") {
    pbrt.warnings.add("a projection light shines in a cone, without its picture", params.place());
    params.has("filename");
    add_projection(pbrt, params);
  } else {
    throw Error(params.place(), "unknown light " + in_quotes(kind),
                "pbrt-v4 has point, spot, distant, infinite, goniometric and projection");
  }
  warn_unread(pbrt, "LightSource", definition);
}

std::optional<PbrtGlow> pbrt_glow(PbrtScene& pbrt, double area, std::size_t parts) {
  if (!pbrt.graphics.area_light) return std::nullopt;
  const PbrtDefinition& definition = *pbrt.graphics.area_light;
  const PbrtParams& params = definition.params;
  if (definition.kind != "diffuse")
    throw Error(params.place(), "unknown area light " + in_quotes(definition.kind),
                "pbrt-v4 has diffuse");
  PbrtGlow glow;
  glow.radiance = light_color(pbrt, params, "L");
  glow.is_two_sided = params.flag("twosided", false);
  const double sides = glow.is_two_sided ? 2 : 1;
  glow.radiance =
      scaled(glow.radiance, power_factor(params, sides * pi * area / static_cast<double>(parts)));
  warn_unread(pbrt, "AreaLightSource", definition);
  const auto& material = pbrt.materials[pbrt.graphics.material].definition;
  if (material && is_pbrt_interface(material->kind)) {
    pbrt.warnings.add("an area light on an interface is left out, as pbrt does", params.place());
    return std::nullopt;
  }
  if (max_abs(glow.radiance) == 0) return std::nullopt;
  if (pbrt.open_group) {
    pbrt.warnings.add("an area light in an object is left out, as pbrt does", params.place());
    return std::nullopt;
  }
  return glow;
}

}  // namespace penumbra
