// SPDX-License-Identifier: MIT
// RadianceBuilder's materials, and what becomes of surfaces that glow.
#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "penumbra/scene_io/radiance_builder.h"

namespace penumbra {
namespace {

constexpr std::uint32_t none = RadianceModifier::none;
constexpr std::size_t most_lights = 10'000;

void check_light_count(const Scene& scene, const RadianceFile& file, const RadiancePrimitive& p) {
  if (scene.lights.size() >= most_lights)
    throw Error({file.path.string(), p.line, {}}, "more than 10000 lights",
                "use fewer, or one that stands for many");
}

}  // namespace

const RadianceLook& RadianceBuilder::look_of(std::uint32_t modifier) {
  const auto [entry, is_new] = looks_.try_emplace(modifier);
  RadianceLook& look = entry->second;
  if (!is_new || modifier == none || modifiers_[modifier].material == none) return look;
  const RadianceModifier& chain = modifiers_[modifier];
  const RadianceModifier& m = modifiers_[chain.material];
  look = radiance_look(*m.file, *m.primitive);
  look.radiance_below = scaled(look.radiance, chain.brightness.below);
  look.radiance = scaled(look.radiance, chain.brightness.above);
  look.spot_direction = m.spot_direction;
  // A mirror's alternate is what is seen; the mirror itself only throws light about.
  if (m.primitive->type == "mirror" && !m.primitive->words.empty()) {
    look.is_drawn = m.other != none;
    if (m.other != none) look = RadianceLook(look_of(m.other));
  }
  return look;
}

std::uint32_t RadianceBuilder::material(const Use& use) {
  const auto next = static_cast<std::uint32_t>(scene_.materials.size());
  const auto [entry, is_new] = materials_.try_emplace(use, next);
  if (!is_new) return entry->second;
  const RadianceLook& look = look_of(use.modifier);
  Material m = look.material;
  if (use.is_inside_out) m.refraction_index = 1 / m.refraction_index;
  if (look.passes_per_length)
    // A ray crosses two surfaces on its way through; where the way's length is not known, it is 1.
    for (int c = 0; c < 3; ++c)
      m.transmission[c] *=
          static_cast<float>(std::pow(static_cast<double>((*look.passes_per_length)[c]),
                                      (use.thickness > 0 ? use.thickness : 1) / 2));
  m.casts_shadow = m.casts_shadow && use.casts_shadow;
  scene_.materials.push_back(std::move(m));
  if (look.emission == RadianceEmission::glow) lights_.seen.emplace_back(next, look.radiance);
  return next;
}

std::uint32_t RadianceBuilder::glowing_material(std::uint32_t modifier) {
  const auto next = static_cast<std::uint32_t>(scene_.materials.size());
  const auto [entry, is_new] = glowing_.try_emplace(modifier, next);
  if (!is_new) return entry->second;
  Material m = look_of(modifier).material;
  m.emission = look_of(modifier).radiance;
  m.emits_from_back = false;
  scene_.materials.push_back(std::move(m));
  return next;
}

std::uint32_t RadianceBuilder::seen_material(std::uint32_t modifier) {
  const auto next = static_cast<std::uint32_t>(scene_.materials.size());
  const auto [entry, is_new] = seen_.try_emplace(modifier, next);
  if (!is_new) return entry->second;
  Material m = look_of(modifier).material;
  m.emits_from_back = false;
  m.casts_shadow = false;
  scene_.materials.push_back(std::move(m));
  lights_.seen.emplace_back(next, look_of(modifier).radiance);
  return next;
}

void RadianceBuilder::add_glowing(const RadianceFile& file, const RadiancePrimitive& p,
                                  std::uint32_t modifier, const RadiancePlacement& placement) {
  if (p.type != "source") {
    const RadianceShape shape = placed(
        radiance_shape(file, p,
                       placement.is_inverted ? RadianceSide::inverted : RadianceSide::as_it_is),
        placement.map);
    spend(64 + 4 * shape.corners.size(), file);  // stored once a placement
    return add_light(file, p, modifier, shape);
  }
  require_numbers(file, p, 4, 4);
  const Vec3d direction =
      apply_direction(placement.map, {p.numbers[0], p.numbers[1], p.numbers[2]});
  const double angle_deg = std::min(p.numbers[3], 360.0);
  const RadianceLook& look = look_of(modifier);
  if (look.emission == RadianceEmission::none || !(angle_deg > 0) || direction == Vec3d{} ||
      max_abs(look.radiance) == 0)
    return warn("a source without light, angle or direction is left out", file, p.line);
  check_light_count(scene_, file, p);
  if (look.emission == RadianceEmission::glow || angle_deg >= 180)
    warn("the sky is light from everywhere alike, without shadows", file, p.line);
  add_source(scene_, lights_, look, direction, angle_deg);
}

void RadianceBuilder::add_light(const RadianceFile& file, const RadiancePrimitive& p,
                                std::uint32_t modifier, const RadianceShape& shape) {
  using Kind = RadianceShape::Kind;
  if (shape.kind == Kind::none) return warn("surfaces without any size are left out", file, p.line);
  const RadianceLook& look = look_of(modifier);
  const bool is_illum = look.emission == RadianceEmission::illum;
  const bool is_mesh = shape.kind == Kind::polygon && !look.spot_deg && !is_illum;
  if (shape.kind == Kind::sphere && shape.faces_inward) {
    warn("a ball that shines inwards gives light from everywhere alike", file, p.line);
    lights_.sky_above = lights_.sky_below = look.radiance;
    if (!is_illum) add_shape(scene_.shapes, polygons_, shape, seen_material(modifier));
    return;
  }
  std::optional<Light> light;
  if (!is_mesh) light = light_of(shape, look, look.spot_direction);
  if (!light) {
    if (look.spot_deg) warn("a spotlight of this shape shines without its cone", file, p.line);
    if (is_illum) warn("an illum of this shape is seen", file, p.line);
    if (shape.kind == Kind::polygon)
      add_shape(scene_.shapes, lights_.glowing, shape, glowing_material(modifier));
    else
      add_faceted(lights_.glowing, shape, glowing_material(modifier));
    return;
  }
  check_light_count(scene_, file, p);
  scene_.lights.push_back(std::move(*light));
  if (!is_illum) return add_shape(scene_.shapes, polygons_, shape, seen_material(modifier));
  const std::uint32_t alternate = modifiers_[modifiers_[modifier].material].other;
  if (alternate != none)
    add_shape(scene_.shapes, polygons_, shape, material({alternate, false, false, 0}));
}

}  // namespace penumbra
