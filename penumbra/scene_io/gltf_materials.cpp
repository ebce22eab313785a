// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/gltf_materials.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "penumbra/scene_io/gltf_uri.h"
#include "penumbra/scene_io/rough_highlight.h"

namespace penumbra {

namespace {

/// An image in three numbers a channel.
struct Summary {
  Color mean{1, 1, 1};
  float brightest = 1;  ///< of all channels
};

struct Builder {
  const GltfDocument& gltf;
  TextureLoader& textures;
  Warnings& warnings;
  std::map<std::pair<std::size_t, ImageCoding>, Summary> summaries;  ///< by image
  std::map<std::size_t, std::int32_t> loaded;                        ///< texture of an image
};

Color color_of(const GltfDocument& gltf, const Json& json, const char* key, std::size_t count,
               Color otherwise) {
  const auto numbers = numbers_of(gltf, json, key, count);
  if (!numbers) return otherwise;
  return max(Color(Vec3d{(*numbers)[0], (*numbers)[1], (*numbers)[2]}), Color{});
}

/// The image that a texture reference stands for.
std::optional<std::size_t> image_of(const GltfDocument& gltf, const Json& reference) {
  const auto texture = index_of(gltf, reference, "index");
  if (!texture) return std::nullopt;
  return index_of(gltf, element(gltf, "textures", *texture), "source");
}

std::int32_t load_image(Builder& b, std::size_t image) {
  const Json& json = element(b.gltf, "images", image);
  const std::string key = fmt::format("image {}", image);
  if (const std::string uri = string_of(b.gltf, json, "uri"); !uri.empty()) {
    if (!is_data_uri(uri)) return b.textures.from_file(decode_uri(uri));
    return b.textures.from_bytes(key, uri_bytes(b.gltf, uri).value_or(""));
  }
  const auto view = index_of(b.gltf, json, "bufferView");
  if (!view) b.gltf.fail(fmt::format("image {} has neither a file nor a buffer view", image));
  return b.textures.from_bytes(key, buffer_view(b.gltf, *view).bytes);
}

std::int32_t load_texture(Builder& b, const Json& reference) {
  const auto image = image_of(b.gltf, reference);
  if (!image) {
    b.warnings.add("a texture in a format other than PNG and JPEG is not read");
    return -1;
  }
  const auto known = b.loaded.find(*image);
  return known != b.loaded.end() ? known->second
                                 : b.loaded.emplace(*image, load_image(b, *image)).first->second;
}

std::optional<Texture> decode_image(const GltfDocument& gltf, std::size_t image,
                                    ImageCoding coding) {
  const auto decode = [&](std::string_view bytes) {
    return decode_texture(bytes, coding, most_pixels_of(bytes.size()) / 2);
  };
  const Json& json = element(gltf, "images", image);
  if (const std::string uri = string_of(gltf, json, "uri"); !uri.empty()) {
    const auto bytes = uri_bytes(gltf, uri);
    return bytes ? decode(*bytes) : std::nullopt;
  }
  const auto view = index_of(gltf, json, "bufferView");
  return view ? decode(buffer_view(gltf, *view).bytes) : std::nullopt;
}

/// Of an image; white where it cannot be had. Decoded once, however many materials have it.
Summary summary_of(Builder& b, const Json& reference, ImageCoding coding) {
  const auto image = image_of(b.gltf, reference);
  if (!image) return {};
  const auto [entry, is_new] = b.summaries.try_emplace({*image, coding});
  if (!is_new) return entry->second;
  const std::optional<Texture> texture = decode_image(b.gltf, *image, coding);
  if (!texture || texture->pixels.empty()) return {};
  Vec3d sum;
  float brightest = 0;
  for (const Color c : texture->pixels) {
    sum += Vec3d(c);
    brightest = std::max(brightest, max_abs(c));
  }
  entry->second = {Color(sum / static_cast<double>(texture->pixels.size())), brightest};
  return entry->second;
}

GltfUvUse uv_use(const GltfDocument& gltf, const Json& reference) {
  GltfUvUse use;
  use.set = index_of(gltf, reference, "texCoord").value_or(0);
  const Json* transform = extension(reference, "KHR_texture_transform");
  if (!transform) return use;
  use.set = index_of(gltf, *transform, "texCoord").value_or(use.set);
  use.rotation_rad = number_of(gltf, *transform, "rotation", 0);
  if (const auto offset = numbers_of(gltf, *transform, "offset", 2))
    use.offset_u = (*offset)[0], use.offset_v = (*offset)[1];
  if (const auto scale = numbers_of(gltf, *transform, "scale", 2))
    use.scale_u = (*scale)[0], use.scale_v = (*scale)[1];
  return use;
}

void set_metal_and_glass(Builder& b, const Json& json, Material& m) {
  static const Json empty = Json::object();
  const Json* found = member(json, "pbrMetallicRoughness");
  const Json& pbr = found ? *found : empty;
  double metal = std::clamp(number_of(b.gltf, pbr, "metallicFactor", 1), 0.0, 1.0);
  double roughness = std::clamp(number_of(b.gltf, pbr, "roughnessFactor", 1), 0.0, 1.0);
  if (const Json* map = member(pbr, "metallicRoughnessTexture"); map && metal > 0) {
    // One material has one metalness here: the mean of the map's.
    const Color mean = summary_of(b, *map, ImageCoding::plain).mean;
    roughness *= static_cast<double>(mean.y), metal *= static_cast<double>(mean.z);
  }
  const Color base = m.diffuse;
  const auto smooth = static_cast<float>((1 - roughness) * (1 - roughness));
  const auto metallic = static_cast<float>(metal);
  m.mirror = base * (metallic * smooth);
  m.diffuse = base * (1 - metallic * smooth);

  double ior = 1.5;
  if (const Json* e = extension(json, "KHR_materials_ior"))
    ior = std::max(number_of(b.gltf, *e, "ior", 1.5), 1.0);
  const double reflected = (ior - 1) / (ior + 1);
  const auto dielectric = static_cast<float>(reflected * reflected);
  const double alpha = roughness * roughness;
  set_rough_highlight(
      m, Color{dielectric, dielectric, dielectric} * (1 - metallic) + base * metallic, alpha);

  const Json* glass = extension(json, "KHR_materials_transmission");
  if (!glass) return;
  const auto share = static_cast<float>(
      std::clamp(number_of(b.gltf, *glass, "transmissionFactor", 0), 0.0, 1.0) * (1 - metal));
  m.transmission = base * share;
  m.diffuse *= 1 - share;
  m.mirror += Color{dielectric, dielectric, dielectric} * (share * smooth);
  // Without a volume the surface is a thin wall, which bends nothing.
  const Json* volume = extension(json, "KHR_materials_volume");
  if (volume && number_of(b.gltf, *volume, "thicknessFactor", 0) > 0)
    m.refraction_index = static_cast<float>(ior);
}

/// KHR_materials_pbrSpecularGlossiness, which older files have instead of metal and roughness.
void set_specular_glossiness(const GltfDocument& gltf, const Json& specular, Material& m) {
  const double glossiness = std::clamp(number_of(gltf, specular, "glossinessFactor", 1), 0.0, 1.0);
  const double alpha = (1 - glossiness) * (1 - glossiness);
  set_rough_highlight(m, color_of(gltf, specular, "specularFactor", 3, {1, 1, 1}) * 0.1f, alpha);
}

const char* base_factor_key(const Json& json) {
  return extension(json, "KHR_materials_pbrSpecularGlossiness") ? "diffuseFactor"
                                                                : "baseColorFactor";
}

void set_emission(Builder& b, const Json& json, Material& m) {
  Color factor = color_of(b.gltf, json, "emissiveFactor", 3, {});
  if (max_abs(factor) == 0) return;
  if (const Json* map = member(json, "emissiveTexture")) {
    const Summary image = summary_of(b, *map, ImageCoding::srgb);
    // A surface with a few bright spots would be a lamp all over, and cast no shadow as lamps do.
    if (!(max_abs(image.mean) >= 0.5f * image.brightest)) {
      b.warnings.add("a glowing surface whose texture is mostly dark does not glow");
      return;
    }
    if (max_abs(image.mean) < 0.99f * image.brightest)
      b.warnings.add("a texture that glows is taken as its mean");
    factor = factor * image.mean;
  }
  double strength = 1;
  if (const Json* e = extension(json, "KHR_materials_emissive_strength"))
    strength = std::max(number_of(b.gltf, *e, "emissiveStrength", 1), 0.0);
  m.emission = factor * static_cast<float>(strength);
  const Json* is_double_sided = member(json, "doubleSided");
  m.emits_from_back = is_double_sided && *is_double_sided == true;
}

/// What the factor leaves out of a blended surface goes straight through; textures' alpha does not.
void set_alpha(Builder& b, const Json& json, const Json* base, Material& m) {
  const std::string mode = string_of(b.gltf, json, "alphaMode");
  if (mode.empty() || mode == "OPAQUE") return;
  const auto factor = base ? numbers_of(b.gltf, *base, base_factor_key(json), 4) : std::nullopt;
  const double alpha = factor ? std::clamp((*factor)[3], 0.0, 1.0) : 1;
  if (mode == "BLEND" && alpha < 1) {
    const auto through = static_cast<float>(1 - alpha);
    m.transmission = min(m.transmission + Color{through, through, through}, Color{1, 1, 1});
    for (Color* part : {&m.diffuse, &m.highlight, &m.mirror}) *part *= static_cast<float>(alpha);
  }
  if (m.texture >= 0 || alpha == 1)
    b.warnings.add("alpha of textures and vertices is not read: what they cut out is drawn");
}

GltfUvUse add_material(Builder& b, const Json& json, Scene& scene) {
  Material m;
  GltfUvUse use;
  m.name = string_of(b.gltf, json, "name");
  const Json* specular = extension(json, "KHR_materials_pbrSpecularGlossiness");
  const Json* pbr = member(json, "pbrMetallicRoughness");
  const Json* base = specular ? specular : pbr;
  m.diffuse = {1, 1, 1};
  if (base) {
    m.diffuse = color_of(b.gltf, *base, base_factor_key(json), 4, {1, 1, 1});
    if (const Json* map = member(*base, specular ? "diffuseTexture" : "baseColorTexture")) {
      m.texture = load_texture(b, *map);
      use = uv_use(b.gltf, *map);
    }
  }
  if (specular)
    set_specular_glossiness(b.gltf, *specular, m);
  else
    set_metal_and_glass(b, json, m);
  if (extension(json, "KHR_materials_unlit"))
    b.warnings.add("KHR_materials_unlit is not read: surfaces of baked-in light are lit as others");
  set_emission(b, json, m);
  set_alpha(b, json, base, m);
  scene.materials.push_back(std::move(m));
  return use;
}

}  // namespace

Vec2f to_uv(const GltfUvUse& use, float u, float v) {
  const double su = use.scale_u * static_cast<double>(u), sv = use.scale_v * static_cast<double>(v);
  const double c = std::cos(use.rotation_rad), s = std::sin(use.rotation_rad);
  return {static_cast<float>(use.offset_u + c * su + s * sv),
          static_cast<float>(1 - (use.offset_v - s * su + c * sv))};
}

std::vector<GltfUvUse> add_materials(const GltfDocument& gltf, Scene& scene,
                                     TextureLoader& textures, Warnings& warnings) {
  Builder builder{gltf, textures, warnings, {}, {}};
  std::vector<GltfUvUse> uses;
  const std::size_t count = element_count(gltf, "materials");
  for (std::size_t i = 0; i < count; ++i)
    uses.push_back(add_material(builder, element(gltf, "materials", i), scene));
  scene.materials.push_back({});
  uses.push_back({});
  return uses;
}

}  // namespace penumbra
