// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/radiance_materials.h"
#include "penumbra/scene_io/rough_highlight.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

namespace penumbra {
namespace {

/// Of window glass, where the file gives none.
constexpr double default_glass_index = 1.52;

struct Numbers {
  const RadianceFile& file;
  const RadiancePrimitive& p;

  /// Where there is no such number: `otherwise`.
  double at(std::size_t i, double otherwise = 0) const {
    return i < p.numbers.size() ? p.numbers[i] : otherwise;
  }
  double share(std::size_t i) const { return std::clamp(at(i), 0.0, 1.0); }
  /// Three numbers from i on, not below 0.
  Color color(std::size_t i) const {
    return Color(max(Vec3d(at(i), at(i + 1), at(i + 2)), Vec3d{}));
  }
  Color reflectance(std::size_t i) const { return min(color(i), Color{1, 1, 1}); }
  [[noreturn]] void fail(const std::string& what, const char* hint) const {
    throw Error({file.path.string(), p.line, {}},
                fmt::format("{} '{:.40}' {}", p.type, p.name, what), hint);
  }
};

/// What a smooth surface between these indices reflects straight on (Fresnel).
double straight_reflectance(double index) {
  const double r = (index - 1) / (index + 1);
  return r * r;
}

Color grey(double value) {
  const auto v = static_cast<float>(value);
  return {v, v, v};
}

/// A surface that reflects `color` diffusely and `specular` in a lobe of Ward's roughness. Smooth
/// ones mirror; of rough ones lights make highlights, and what else the lobe would gather is half
/// mirrored, half spread, by how rough it is.
void set_reflection(Material& m, Color color, Color specular, double roughness) {
  const double sharp = 1 - std::sqrt(std::clamp(roughness, 0.0, 1.0));
  const auto mirrored = static_cast<float>(sharp * sharp);
  m.diffuse = color + specular * (1 - mirrored);
  m.mirror = specular * mirrored;
  if (roughness > 0) set_rough_highlight(m, specular, roughness);
}

/// plastic and metal and those like them: red green blue specularity [roughness ...]. The highlight
/// of plastic is white, that of metal its colour.
void set_plastic(const Numbers& n, Material& m, bool is_metal, double roughness) {
  const Color color = n.reflectance(0);
  const auto specular = static_cast<float>(n.share(3));
  set_reflection(m, color * (1 - specular), is_metal ? color * specular : grey(n.share(3)),
                 roughness);
}

/// trans: red green blue specularity roughness transmitted transmitted-specularly.
void set_trans(const Numbers& n, RadianceLook& look, std::size_t transmitted, double roughness) {
  const Color color = n.reflectance(0);
  const auto specular = static_cast<float>(n.share(3));
  const auto through = static_cast<float>(n.share(transmitted));
  const auto clear = static_cast<float>(n.share(transmitted + 1));
  set_reflection(look.material, color * ((1 - specular) * (1 - through)), grey(n.share(3)),
                 roughness);
  look.material.transmission = color * ((1 - specular) * through * clear);
  if (through * (1 - clear) > 0)
    look.warning = "light that passes diffusely (trans) is not drawn; behind it is shadow";
}

/// A thin pane, inner reflections included: red green blue transmissivity [refraction index].
void set_glass(const Numbers& n, Material& m) {
  const double r = straight_reflectance(n.at(3, default_glass_index));
  m.diffuse = {};
  for (int c = 0; c < 3; ++c) {
    const double t = std::clamp(n.at(static_cast<std::size_t>(c)), 0.0, 1.0);
    const double rest = 1 - r * r * t * t;
    m.transmission[c] = static_cast<float>((1 - r) * (1 - r) * t / rest);
    m.mirror[c] = static_cast<float>(r + r * (1 - r) * (1 - r) * t * t / rest);
  }
  // Radiance's glass exists to let light in.
  m.casts_shadow = max_abs(m.transmission) < 0.5f;
}

/// A solid's surface: `inside` red green blue that pass a length of 1, and the ratio of indices.
void set_dielectric(const Numbers& n, RadianceLook& look, double index) {
  if (!(index > 0) || !std::isfinite(index))
    n.fail("has a refraction index that is not above 0", "give an index such as 1.5");
  Material& m = look.material;
  const double mirrored = straight_reflectance(index);
  m.diffuse = {};
  m.mirror = grey(mirrored);
  m.transmission = grey(1 - mirrored);
  m.refraction_index = static_cast<float>(index);
  if (const Color inside = n.reflectance(0); inside != Color{1, 1, 1})
    look.passes_per_length = inside;
}

void set_light(const Numbers& n, RadianceLook& look) {
  const std::string_view type = n.p.type;
  look.material.diffuse = {};
  look.radiance = n.color(0);
  look.emission = type == "illum" ? RadianceEmission::illum : RadianceEmission::light;
  if (type == "glow" && !(n.at(3) > 0)) look.emission = RadianceEmission::glow;
  if (type != "spotlight") return;
  look.spot_deg = n.at(3);
  look.spot_direction = {n.at(4), n.at(5), n.at(6)};
  if (!(*look.spot_deg > 0) || look.spot_direction == Vec3d{})
    n.fail("has no cone: its angle or its direction is 0", "give both");
}

/// BRTDfunc: after its functions, what it reflects diffusely from the front and the back and lets
/// through.
void set_brtd(const Numbers& n, RadianceLook& look) {
  look.material.diffuse = n.p.numbers.empty() ? grey(0.5) : n.reflectance(0);
  look.warning = "a BRTDfunc is drawn by its diffuse reflection alone";
}

void set_bsdf(const Numbers& n, RadianceLook& look) {
  look.material.diffuse = n.p.numbers.empty() ? grey(0.5) : n.reflectance(0);
  look.warning = "a BSDF's data are not read: it is drawn diffuse";
}

/// How many numbers a material has; optional ones between the two.
struct Range {
  std::string_view type;
  std::size_t least, most;
};

constexpr std::size_t any = static_cast<std::size_t>(-1);
constexpr Range ranges[] = {{"light", 3, 3},      {"illum", 3, 3},     {"glow", 4, 4},
                            {"spotlight", 7, 7},  {"mirror", 3, 3},    {"plastic", 5, 5},
                            {"metal", 5, 5},      {"trans", 7, 7},     {"plastic2", 6, 6},
                            {"metal2", 6, 6},     {"trans2", 8, 8},    {"ashik2", 8, 8},
                            {"dielectric", 5, 5}, {"interface", 8, 8}, {"glass", 3, 4},
                            {"plasfunc", 4, any}, {"metfunc", 4, any}, {"transfunc", 6, any},
                            {"plasdata", 4, any}, {"metdata", 4, any}, {"transdata", 6, any}};

void check_numbers(const Numbers& n) {
  for (const Range& range : ranges)
    if (range.type == n.p.type) require_numbers(n.file, n.p, range.least, range.most);
}

/// Anisotropic and function-driven ones, drawn as the plain material that is nearest.
bool set_nearest(const Numbers& n, RadianceLook& look) {
  const std::string_view type = n.p.type;
  Material& m = look.material;
  const double mean = std::sqrt(std::abs(n.at(4) * n.at(5)));  // of two roughnesses
  constexpr double for_functions = 0.1;
  if (type == "plastic2" || type == "metal2") {
    set_plastic(n, m, type == "metal2", mean);
  } else if (type == "trans2") {
    set_trans(n, look, 6, mean);
  } else if (type == "ashik2") {
    const double power = std::sqrt(std::abs(n.at(6) * n.at(7)));
    set_reflection(m, n.reflectance(0), n.reflectance(3), std::sqrt(2 / (power + 2)));
  } else if (type == "plasfunc" || type == "plasdata" || type == "metfunc" || type == "metdata") {
    set_plastic(n, m, type.starts_with("met"), for_functions);
  } else if (type == "transfunc" || type == "transdata") {
    set_trans(n, look, 4, for_functions);
  } else {
    return false;
  }
  look.warning = fmt::format("{} is drawn as the nearest of plastic, metal and trans", type);
  return true;
}

}  // namespace

RadianceLook radiance_look(const RadianceFile& file, const RadiancePrimitive& p) {
  const Numbers n{file, p};
  check_numbers(n);
  RadianceLook look;
  look.material.name = p.name;
  const std::string_view type = p.type;
  if (type == "plastic" || type == "metal") {
    set_plastic(n, look.material, type == "metal", n.at(4));
  } else if (type == "trans") {
    set_trans(n, look, 5, n.at(4));
  } else if (type == "glass") {
    set_glass(n, look.material);
  } else if (type == "dielectric") {
    set_dielectric(n, look, n.at(3));
  } else if (type == "interface") {
    set_dielectric(n, look, n.at(3) / n.at(7));
  } else if (type == "mirror") {
    look.material.diffuse = {};
    look.material.mirror = n.reflectance(0);
  } else if (type == "light" || type == "illum" || type == "glow" || type == "spotlight") {
    set_light(n, look);
  } else if (type == "mist" || type == "antimatter") {
    look.is_drawn = false;
    look.warning = fmt::format("{} is left out, with the surfaces made of it", type);
  } else if (type == "prism1" || type == "prism2") {
    set_glass(n, look.material);
    look.material.transmission = grey(0.9), look.material.mirror = {};
    look.material.casts_shadow = false;
    look.warning = "prisms are drawn as clear glass";
  } else if (type == "BRTDfunc" || type == "WGMDfunc") {
    set_brtd(n, look);
  } else if (type == "BSDF" || type == "aBSDF") {
    set_bsdf(n, look);
  } else {
    set_nearest(n, look);
  }
  return look;
}

}  // namespace penumbra
