// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/pbrt_materials.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "penumbra/scene_io/numbers.h"
#include "penumbra/scene_io/pbrt_textures.h"
#include "penumbra/scene_io/rough_highlight.h"

namespace penumbra {
namespace {

constexpr Color grey{0.5f, 0.5f, 0.5f};

/// A material of the scene, and what else a shape must know of it.
struct Made {
  Material material;
  PbrtPaint paint;         ///< of its diffuse colour
  bool is_surface = true;  ///< false: pbrt's "interface"
};

/// Makes materials out of definitions.
class Maker {
 public:
  explicit Maker(PbrtScene& pbrt) : pbrt_(pbrt), textures_(pbrt), made_(pbrt.materials.size()) {}

  const Made& of_slot(std::uint32_t slot);

 private:
  Made make(const PbrtDefinition& definition);
  Made mix(const PbrtParams& params);
  void diffuse(Made& made, const PbrtPaint& paint, float share = 1);
  void metal(Made& made, const PbrtParams& params, const std::string& prefix);
  void glass(Made& made, const PbrtParams& params, bool is_thin);
  void coat(Made& made, const PbrtParams& params, const std::string& prefix);
  double index(const PbrtParams& params, const std::string& name, double otherwise);
  double alpha(const PbrtParams& params, const std::string& prefix, double otherwise);
  void substitute(Made& made, const PbrtDefinition& definition, const PbrtPaint& paint);

  PbrtScene& pbrt_;
  PbrtTextures textures_;
  std::vector<std::optional<Made>> made_;
  std::size_t depth_ = 0;
};

float reflected_along_normal(double index) {
  const double r = (index - 1) / (index + 1);
  return static_cast<float>(r * r);
}

/// The share of what a rough surface mirrors that is still a picture of its surroundings.
float clear_share(double alpha) {
  const double smooth = 1 - std::clamp(alpha, 0.0, 1.0);
  return static_cast<float>(smooth * smooth);
}

double Maker::index(const PbrtParams& params, const std::string& name, double otherwise) {
  const PbrtParameter* p = params.find(name);
  if (!p) return otherwise;
  const double index = p->type == "spectrum" || p->type == "rgb"
                           ? static_cast<double>(textures_.paint(params, name, {}).mean.y)
                           : textures_.number(params, name, otherwise);
  return std::clamp(index, 1.0, 100.0);
}

/// The width of pbrt's microfacets, from one roughness or two.
double Maker::alpha(const PbrtParams& params, const std::string& prefix, double otherwise) {
  const double both = textures_.number(params, prefix + "roughness", otherwise);
  const double u = textures_.number(params, prefix + "uroughness", both),
               v = textures_.number(params, prefix + "vroughness", both);
  const double roughness = std::clamp((u + v) / 2, 0.0, 1.0);
  return params.flag("remaproughness", true) ? std::sqrt(roughness) : roughness;
}

void Maker::diffuse(Made& made, const PbrtPaint& paint, float share) {
  made.paint = paint;
  made.paint.color = paint.color * share;
  made.paint.mean = paint.mean * share;
  made.material.diffuse = made.paint.color;
  made.material.texture = paint.texture;
}

void Maker::metal(Made& made, const PbrtParams& params, const std::string& prefix) {
  Color f0;
  if (params.has("reflectance")) {
    f0 = textures_.paint(params, "reflectance", {}).mean;
  } else {
    const MetalIndex copper = *metal_index("Cu");
    f0 = metal_reflectance({textures_.paint(params, prefix + "eta", copper.eta).mean,
                            textures_.paint(params, prefix + "k", copper.k).mean});
  }
  const double width = alpha(params, prefix, 0);
  made.material.mirror = f0 * clear_share(width);
  // What is in between is the highlight's.
  diffuse(made, {f0, -1, {}, f0}, static_cast<float>(std::clamp(width * width, 0.0, 1.0)));
  set_rough_highlight(made.material, f0, width);
}

void Maker::coat(Made& made, const PbrtParams& params, const std::string& prefix) {
  const float f0 = reflected_along_normal(index(params, prefix + "eta", 1.5));
  const double width = alpha(params, prefix, 0);
  const Color white{f0, f0, f0};
  made.material.mirror += white * clear_share(width);
  if (max_abs(made.material.highlight) == 0) set_rough_highlight(made.material, white, width);
}

void Maker::glass(Made& made, const PbrtParams& params, bool is_thin) {
  const double eta = index(params, "eta", 1.5);
  // Of a thin wall all that goes to and fro inside adds up.
  const float once = reflected_along_normal(eta), f0 = is_thin ? 2 * once / (1 + once) : once;
  Material& m = made.material;
  m.diffuse = {};
  m.mirror = {f0, f0, f0};
  m.transmission = {1 - f0, 1 - f0, 1 - f0};
  m.refraction_index = is_thin ? 1 : static_cast<float>(eta);
  m.casts_shadow = !is_thin;
  const double width = alpha(params, "", 0);
  set_rough_highlight(m, m.mirror, width);
  if (width > 0.05) pbrt_.warnings.add("rough glass is drawn clear", params.place());
}

void Maker::substitute(Made& made, const PbrtDefinition& definition, const PbrtPaint& paint) {
  pbrt_.warnings.add(
      fmt::format("a material of the kind {} is drawn matte", in_quotes(definition.kind)),
      definition.params.place());
  diffuse(made, paint);
}

Made Maker::mix(const PbrtParams& params) {
  constexpr std::size_t most_depth = 64;
  const std::vector<std::string> names = params.texts("materials");
  if (names.size() != 2)
    throw Error(params.place(), "a mix is of two materials", "name them in \"string materials\"");
  if (depth_ == most_depth)
    throw Error(params.place(),
                fmt::format("more than {} materials are mixed of each other", most_depth),
                "is one mixed of itself?");
  ++depth_;
  const auto part = [&](const std::string& name) {
    const auto slot = pbrt_.named_materials.find(name);
    if (slot == pbrt_.named_materials.end())
      throw Error(params.place(), "there is no material " + in_quotes(name),
                  "define it with MakeNamedMaterial");
    return of_slot(slot->second);
  };
  const Made a = part(names[0]), b = part(names[1]);
  --depth_;
  const auto share =
      static_cast<float>(std::clamp(textures_.number(params, "amount", 0.5), 0.0, 1.0));
  if (share == 0 || !b.is_surface) return a;
  if (share == 1 || !a.is_surface) return b;
  const auto blend = [&](Color x, Color y) { return x * (1 - share) + y * share; };
  Made both = share < 0.5f ? a : b;
  Material& m = both.material;
  m.highlight = blend(a.material.highlight, b.material.highlight);
  m.mirror = blend(a.material.mirror, b.material.mirror);
  m.transmission = blend(a.material.transmission, b.material.transmission);
  // One image at most, and then it is all of the colour.
  PbrtPaint paint = a.paint.texture >= 0 ? a.paint : b.paint;
  const Color color = blend(a.paint.mean, b.paint.mean);
  if (paint.texture < 0) {
    paint = {color, -1, {}, color};
  } else {
    const auto ratio = [](float x, float y) { return y > 0 ? x / y : 0; };
    paint.color = paint.color * Color{ratio(color.x, paint.mean.x), ratio(color.y, paint.mean.y),
                                      ratio(color.z, paint.mean.z)};
    paint.mean = color;
  }
  diffuse(both, paint);
  return both;
}

Made Maker::make(const PbrtDefinition& definition) {
  const PbrtParams& params = definition.params;
  const std::string& kind = definition.kind;
  if (kind == "mix") return mix(params);
  Made made;
  if (is_pbrt_interface(kind)) {
    made.is_surface = false;
  } else if (kind == "diffuse") {
    diffuse(made, textures_.paint(params, "reflectance", grey));
  } else if (kind == "coateddiffuse") {
    diffuse(made, textures_.paint(params, "reflectance", grey));
    coat(made, params, "");
  } else if (kind == "conductor") {
    metal(made, params, "");
  } else if (kind == "coatedconductor") {
    metal(made, params, "conductor.");
    coat(made, params, "interface.");
  } else if (kind == "dielectric" || kind == "thindielectric") {
    glass(made, params, kind == "thindielectric");
  } else if (kind == "diffusetransmission") {
    PbrtPaint paint = textures_.paint(params, "reflectance", grey * 0.5f);
    const Color through = textures_.paint(params, "transmittance", grey * 0.5f).mean;
    if (paint.texture < 0) paint.color = paint.mean = paint.color + through;
    substitute(made, definition, paint);
  } else if (kind == "subsurface") {
    substitute(made, definition, textures_.paint(params, "reflectance", {0.8f, 0.8f, 0.8f}));
  } else if (kind == "hair") {
    const char* color = params.has("color") ? "color" : "reflectance";
    substitute(made, definition, textures_.paint(params, color, {0.25f, 0.15f, 0.08f}));
  } else {
    substitute(made, definition, textures_.paint(params, "reflectance", grey));
  }
  for (const char* harmless :
       {"type", "thickness", "maxdepth", "nsamples", "g", "albedo", "interface.thickness"})
    params.has(harmless);
  if (params.has("displacement") || params.has("normalmap"))
    pbrt_.warnings.add("bumps (displacement, normalmap) are drawn flat", params.place());
  warn_unread(pbrt_, "Material", definition);
  return made;
}

const Made& Maker::of_slot(std::uint32_t index) {
  if (made_[index]) return *made_[index];
  const PbrtMaterialSlot& slot = pbrt_.materials[index];
  Made made;
  if (slot.base) {
    made = of_slot(*slot.base);
    made.material.emission = slot.emission;
    made.material.emits_from_back = slot.is_two_sided;
    made.material.casts_shadow = made.material.casts_shadow && slot.casts_shadow;
    if (!made.is_surface) made.material.diffuse = {};
    made.is_surface = true;
  } else if (slot.definition) {
    made = make(*slot.definition);
  } else {
    throw Error(slot.mention, "there is no material " + in_quotes(slot.name),
                "define it with MakeNamedMaterial");
  }
  made.material.name = slot.name;
  const auto within = [](Color c) { return min(max(c, Color{}), Color{1, 1, 1}); };
  if (made.material.texture < 0) made.material.diffuse = within(made.material.diffuse);
  made.material.mirror = within(made.material.mirror);
  made.material.transmission = within(made.material.transmission);
  made_[index] = std::move(made);
  return *made_[index];
}

/// Puts the made materials where shapes look for them.
class Finisher {
 public:
  Finisher(PbrtScene& pbrt, Maker& maker)
      : pbrt_(pbrt), maker_(maker), plain_(pbrt.materials.size()) {}

  void finish(ShapeSet& shapes) {
    const auto is_no_surface = [&](const auto& shape) {
      return !maker_.of_slot(shape.surface).is_surface;
    };
    std::erase_if(shapes.spheres, is_no_surface);
    std::erase_if(shapes.cones, is_no_surface);
    std::erase_if(shapes.rings, is_no_surface);
    std::erase_if(shapes.meshes, is_no_surface);
    for (Sphere& sphere : shapes.spheres) sphere.surface = plain(sphere.surface);
    for (Cone& cone : shapes.cones) cone.surface = plain(cone.surface);
    for (Ring& ring : shapes.rings) ring.surface = plain(ring.surface);
    for (Mesh& mesh : shapes.meshes) finish(mesh);
  }

 private:
  void finish(Mesh& mesh) {
    const Made& made = maker_.of_slot(mesh.surface);
    if (mesh.uvs.empty() || made.material.texture < 0) {
      mesh.surface = plain(mesh.surface);
      mesh.uvs.clear();
      return;
    }
    if (const PbrtUvMap& map = made.paint.map; map != PbrtUvMap{})
      for (Vec2f& uv : mesh.uvs)
        uv = {static_cast<float>(map.scale_u * double(uv.u) + map.offset_u),
              static_cast<float>(map.scale_v * double(uv.v) + map.offset_v)};
  }

  /// The same material without its image, for what has no texture coordinates.
  std::uint32_t plain(std::uint32_t slot) {
    const Made& made = maker_.of_slot(slot);
    if (made.material.texture < 0) return slot;
    if (plain_[slot] == 0) {
      plain_[slot] = static_cast<std::uint32_t>(pbrt_.scene.materials.size());
      pbrt_.scene.materials.push_back(made.material);
      pbrt_.scene.materials.back().texture = -1;
      pbrt_.scene.materials.back().diffuse = made.paint.mean;
      pbrt_.warnings.add(
          "an image on a shape without texture coordinates is drawn as its mean colour",
          pbrt_.materials[slot].mention);
    }
    return plain_[slot];
  }

  PbrtScene& pbrt_;
  Maker& maker_;
  std::vector<std::uint32_t> plain_;  ///< by slot; 0: none yet
};

}  // namespace

std::uint32_t named_pbrt_material(PbrtScene& pbrt, const std::string& name, PbrtPlace place) {
  const auto slot = static_cast<std::uint32_t>(pbrt.materials.size());
  const auto [known, is_new] = pbrt.named_materials.try_emplace(name, slot);
  if (is_new) {
    pbrt.materials.emplace_back();
    pbrt.materials.back().name = name;
    pbrt.materials.back().mention = place;
  }
  return known->second;
}

std::uint32_t add_pbrt_material(PbrtScene& pbrt, PbrtDefinition definition) {
  pbrt.materials.emplace_back();
  pbrt.materials.back().mention = definition.params.place();
  pbrt.materials.back().definition = std::move(definition);
  return static_cast<std::uint32_t>(pbrt.materials.size() - 1);
}

void finish_pbrt_materials(PbrtScene& pbrt) {
  Maker maker(pbrt);
  for (std::uint32_t slot = 0; slot < pbrt.materials.size(); ++slot)
    pbrt.scene.materials.push_back(maker.of_slot(slot).material);
  Finisher finisher(pbrt, maker);
  finisher.finish(pbrt.scene.shapes);
  for (ShapeSet& group : pbrt.scene.shapes.groups) finisher.finish(group);
}

}  // namespace penumbra
