// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/radiance_modifiers.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "penumbra/scene_io/numbers.h"

namespace penumbra {
namespace {

constexpr std::uint32_t none = RadianceModifier::none;

/// Perez's all-weather sky (perezlum.cal: scale, ground, five coefficients, direction of the sun),
/// as a level surface sees it: the mean over steps of equal irradiance.
double perez_mean(const std::vector<double>& a) {
  constexpr int rings = 16, turns = 32;
  const Vec3d sun = normalize(Vec3d(a[7], a[8], a[9]));
  double sum = 0;
  for (int i = 0; i < rings; ++i)
    for (int j = 0; j < turns; ++j) {
      const double outward = std::sqrt((i + 0.5) / rings), up = std::sqrt(1 - outward * outward);
      const double turn = 2 * std::numbers::pi * j / turns;
      const Vec3d direction(outward * std::cos(turn), outward * std::sin(turn), up);
      const double cosine = std::clamp(dot(direction, sun), -1.0, 1.0);
      sum += (1 + a[2] * std::exp(a[3] / up)) *
             (1 + a[4] * std::exp(a[5] * std::acos(cosine)) + a[6] * cosine * cosine);
    }
  return a[0] * sum / (rings * turns);
}

/// Of gensky's and gendaylit's skies. Of the first it is the zenith's, the mean of a hemisphere
/// near enough.
RadianceBrightness sky_brightness(const RadiancePrimitive& pattern) {
  const auto sensible = [](double value) { return value >= 0 ? std::min(value, 1e30) : 1; };
  const std::vector<double>& n = pattern.numbers;
  if (pattern.type != "brightfunc" || pattern.words.size() < 2) return {};
  if (pattern.words[1] == "skybright.cal" && n.size() >= 3) return {sensible(n[1]), sensible(n[2])};
  if (pattern.words[1] == "perezlum.cal" && n.size() >= 10)
    return {sensible(perez_mean(n)), sensible(n[1])};
  return {};
}

}  // namespace

std::optional<std::uint32_t> RadianceModifiers::known(const std::string& name) const {
  if (name == "void") return none;
  const auto found = names_.find(name);
  if (found == names_.end()) return std::nullopt;
  return found->second;
}

std::uint32_t RadianceModifiers::find(const std::string& name, const RadianceFile& file,
                                      const RadiancePrimitive& user) const {
  if (const auto id = known(name)) return *id;
  throw Error({file.path.string(), user.line, {}},
              fmt::format("no material named {} is defined before it", in_quotes(name)),
              "define it, or put `!xform materials.rad` of the file that does before it");
}

/// The materials of mirrors, illums and mixtures that their words name: what is drawn in their
/// stead. Of a mixture the foreground, unless that is void.
void RadianceModifiers::complete(RadianceModifier& m, std::uint32_t id) const {
  const RadiancePrimitive& p = *m.primitive;
  const auto inherit = [&](std::uint32_t from) {
    if (from == none) return;
    m.material = all_[from].material;
    m.brightness = all_[from].brightness;
    m.oddity = all_[from].oddity;
  };
  if (is_radiance_mixture(p.type)) {
    const std::size_t count = std::min<std::size_t>(p.words.size(), 2);
    for (std::size_t i = 0; i < count && m.material == none; ++i)
      inherit(find(p.words[i], *m.file, p));
    m.oddity = id;
    return;
  }
  inherit(m.parent);
  if (is_radiance_pattern(p.type)) {
    const RadianceBrightness sky = sky_brightness(p);
    m.brightness = {std::min(m.brightness.above * sky.above, 1e30),
                    std::min(m.brightness.below * sky.below, 1e30)};
    m.oddity = id;
    return;
  }
  m.material = id;
  if ((p.type == "mirror" || p.type == "illum") && !p.words.empty())
    m.other = find(p.words[0], *m.file, p);
  // A mirror's alternate may have one itself, which is already the last of such a row.
  if (p.type != "mirror" || m.other == none || all_[m.other].material == none) return;
  const RadianceModifier& other = all_[all_[m.other].material];
  if (other.primitive->type == "mirror" && !other.primitive->words.empty()) m.other = other.other;
}

/// `inherit alias name other` is other itself, and so is one with the same modifier.
std::uint32_t RadianceModifiers::alias(const RadianceFile& file, const RadiancePrimitive& p) const {
  const std::uint32_t other = find(p.words[0], file, p);
  if (other == none)
    throw Error({file.path.string(), p.line, {}}, "an alias cannot stand for void",
                "use void itself");
  return other;
}

void RadianceModifiers::define(const RadianceFile& file, const RadiancePrimitive& p,
                               const Transform& map) {
  RadianceModifier m;
  m.file = &file, m.primitive = &p;
  if (p.type == "alias") {
    const RadianceModifier& other = all_[alias(file, p)];
    const std::uint32_t parent = p.modifier == "inherit" ? other.parent : find(p.modifier, file, p);
    m = other;
    m.parent = parent;
    m.material = m.oddity = m.other = none;
    m.brightness = {};
  } else {
    m.parent = find(p.modifier, file, p);
  }
  const RadiancePrimitive& meant = *m.primitive;
  if (&meant == &p && meant.type == "spotlight" && meant.numbers.size() >= 7)
    m.spot_direction = apply_direction(map, {meant.numbers[4], meant.numbers[5], meant.numbers[6]});
  if (&meant == &p && (meant.type == "dielectric" || meant.type == "interface")) {
    // As a float, so that equal scales by different turns are equal.
    m.scale = static_cast<double>(static_cast<float>(std::cbrt(std::abs(determinant(map)))));
  }
  const auto id = static_cast<std::uint32_t>(all_.size());
  complete(m, id);
  // Mixtures and alternates depend on what their words mean here.
  const std::uint32_t named = is_radiance_mixture(meant.type) ? m.material : m.other;
  const Vec3d d = m.spot_direction;
  const auto [entry, is_new] =
      ids_.emplace(Key{&meant, m.parent, named, d.x, d.y, d.z, m.scale}, id);
  if (is_new) all_.push_back(m);
  names_[p.name] = entry->second;
}

}  // namespace penumbra
