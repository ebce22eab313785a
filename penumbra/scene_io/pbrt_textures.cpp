// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/pbrt_textures.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "penumbra/scene_io/numbers.h"
#include "penumbra/scene_io/pbrt_spectra.h"

namespace penumbra {
namespace {

/// Of textures made of textures, and a guard against those made of themselves.
constexpr std::size_t most_depth = 64;

PbrtPaint plain(Color color) { return {color, -1, {}, color}; }

Color blend(Color a, Color b, float share) { return a * (1 - share) + b * share; }

/// Straight from u and v; the other mappings are by position.
std::optional<PbrtUvMap> uv_map(const PbrtParams& params) {
  if (params.text("mapping", "uv") != "uv") return std::nullopt;
  return PbrtUvMap{params.number("uscale", 1), params.number("vscale", 1),
                   params.number("udelta", 0), params.number("vdelta", 0)};
}

/// Two fields each way, the lower left one of the first colour.
Texture two_by_two(Color first, Color second) {
  constexpr std::uint32_t size = 128;
  Texture texture{size, size, std::vector<Color>(std::size_t{size} * size)};
  for (std::uint32_t y = 0; y < size; ++y)
    for (std::uint32_t x = 0; x < size; ++x) {
      const bool is_first = (x < size / 2) == (y >= size / 2);
      texture.pixels[std::size_t{y} * size + x] = is_first ? first : second;
    }
  return texture;
}

}  // namespace

Color mean_color(const Texture& texture) {
  Vec3d sum;
  for (const Color pixel : texture.pixels) sum += Vec3d(pixel);
  return texture.pixels.empty() ? Color{1, 1, 1}
                                : Color(sum / static_cast<double>(texture.pixels.size()));
}

PbrtPaint PbrtTextures::paint(const PbrtParams& params, std::string_view name, Color otherwise,
                              PbrtTextureOf of) {
  const PbrtParameter* p = params.find(name);
  if (!p) return plain(otherwise);
  if (p->type != "texture") return plain(*pbrt_color(p, SpectrumOf::surface, pbrt_.source.path));
  if (p->texts.size() != 1)
    throw Error(p->place, "parameter " + in_quotes(p->name) + " must name one texture");
  return named(p->texts[0], p->place, of);
}

double PbrtTextures::number(const PbrtParams& params, std::string_view name, double otherwise) {
  const PbrtParameter* p = params.find(name);
  if (!p) return otherwise;
  if (p->type != "texture") return params.number(name, otherwise);
  const PbrtPaint value = paint(params, name, {}, PbrtTextureOf::numbers);
  if (value.texture >= 0)
    pbrt_.warnings.add("a number given by an image is its mean everywhere", p->place);
  return static_cast<double>(value.mean.y);
}

PbrtPaint PbrtTextures::named(const std::string& name, PbrtPlace place, PbrtTextureOf of) {
  const PbrtDefinition* definition = nullptr;
  for (const auto* textures : {&pbrt_.color_textures, &pbrt_.number_textures}) {
    const auto found = textures->find(name);
    const bool is_wanted = (of == PbrtTextureOf::colors) == (textures == &pbrt_.color_textures);
    if (found != textures->end() && (is_wanted || !definition)) definition = &found->second;
  }
  if (!definition)
    throw Error(place, "there is no texture " + in_quotes(name), "define it with Texture");
  if (const auto known = known_.find(definition); known != known_.end()) return known->second;
  if (depth_ == most_depth)
    throw Error(place, fmt::format("more than {} textures are made of each other", most_depth),
                "is one made of itself?");
  ++depth_;
  const PbrtPaint made = make(*definition, of);
  --depth_;
  return known_[definition] = made;
}

PbrtPaint PbrtTextures::make(const PbrtDefinition& definition, PbrtTextureOf of) {
  const PbrtParams& params = definition.params;
  const std::string& kind = definition.kind;
  if (kind == "constant") return paint(params, "value", {1, 1, 1}, of);
  PbrtPaint made;
  if (kind == "imagemap") {
    made = image(definition);
  } else if (kind == "scale") {
    made = scaled(definition, of);
  } else if (kind == "mix" || kind == "directionmix") {
    made = mixed(definition, of);
  } else if (kind == "checkerboard") {
    made = checkerboard(definition, of);
  } else if (kind == "dots") {
    return mean_only(paint(params, "outside", {0, 0, 0}, of), kind, params.place());
  } else {
    return mean_only(plain({0.5f, 0.5f, 0.5f}), kind, params.place());
  }
  warn_unread(pbrt_, "Texture", definition);
  return made;
}

PbrtPaint PbrtTextures::mean_only(const PbrtPaint& paint, std::string_view kind, PbrtPlace place) {
  pbrt_.warnings.add(
      fmt::format("textures of the kind {} are drawn in one colour", in_quotes(kind)), place);
  return plain(paint.mean);
}

PbrtPaint PbrtTextures::image(const PbrtDefinition& definition) {
  const PbrtParams& params = definition.params;
  for (const char* harmless : {"filter", "maxanisotropy", "encoding", "wrap"}) params.has(harmless);
  for (const char* name : {"encoding", "wrap"})
    if (const std::string value = params.text(name, "");
        !value.empty() && value != "sRGB" && value != "repeat")
      pbrt_.warnings.add(
          fmt::format("images are sRGB and repeat, {} {} is not read", name, in_quotes(value)),
          params.place());
  PbrtPaint paint;
  const auto scale = static_cast<float>(std::clamp(params.number("scale", 1), 0.0, 1e6));
  paint.color = {scale, scale, scale};
  paint.texture = loader_.from_file(params.text("filename", ""), params.place());
  if (paint.texture < 0) return plain(Color{0.5f, 0.5f, 0.5f} * scale);
  paint.mean =
      mean_color(pbrt_.scene.textures[static_cast<std::size_t>(paint.texture)]) * paint.color;
  const auto map = uv_map(params);
  if (!map) return mean_only(paint, "imagemap that is not mapped by uv", params.place());
  paint.map = *map;
  return paint;
}

PbrtPaint PbrtTextures::scaled(const PbrtDefinition& definition, PbrtTextureOf of) {
  const PbrtParams& params = definition.params;
  PbrtPaint a = paint(params, "tex", {1, 1, 1}, of),
            b = paint(params, "scale", {1, 1, 1}, PbrtTextureOf::numbers);
  if (a.texture >= 0 && b.texture >= 0)
    b = mean_only(b, "image scaled by an image", params.place());
  if (a.texture < 0) std::swap(a, b);
  a.color = a.color * b.mean;
  a.mean = a.mean * b.mean;
  return a;
}

PbrtPaint PbrtTextures::mixed(const PbrtDefinition& definition, PbrtTextureOf of) {
  const PbrtParams& params = definition.params;
  const PbrtPaint a = paint(params, "tex1", {0, 0, 0}, of),
                  b = paint(params, "tex2", {1, 1, 1}, of);
  const auto share = static_cast<float>(std::clamp(number(params, "amount", 0.5), 0.0, 1.0));
  if (share == 0) return a;
  if (share == 1) return b;
  const PbrtPaint both = plain(blend(a.mean, b.mean, share));
  if (a.texture < 0 && b.texture < 0) return both;
  return mean_only(both, "mix of images", params.place());
}

PbrtPaint PbrtTextures::checkerboard(const PbrtDefinition& definition, PbrtTextureOf of) {
  const PbrtParams& params = definition.params;
  const PbrtPaint a = paint(params, "tex1", {1, 1, 1}, of),
                  b = paint(params, "tex2", {0, 0, 0}, of);
  const auto map = uv_map(params);
  const PbrtPaint both = plain(blend(a.mean, b.mean, 0.5f));
  constexpr std::size_t most_textures = 256;  // of all
  if (!map || a.texture >= 0 || b.texture >= 0 || params.number("dimension", 2) != 2 ||
      pbrt_.scene.textures.size() >= most_textures)
    return mean_only(both, "checkerboard of other than colours by uv", params.place());
  pbrt_.scene.textures.push_back(two_by_two(a.color, b.color));
  PbrtPaint board{
      {1, 1, 1}, static_cast<std::int32_t>(pbrt_.scene.textures.size()) - 1, *map, both.mean};
  for (double* number :
       {&board.map.scale_u, &board.map.scale_v, &board.map.offset_u, &board.map.offset_v})
    *number /= 2;
  return board;
}

}  // namespace penumbra
