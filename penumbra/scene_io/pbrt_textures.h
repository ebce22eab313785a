// SPDX-License-Identifier: MIT
// pbrt's textures, as one colour and at most one image.
#pragma once

#include <map>
#include <string>

#include "penumbra/scene_io/pbrt_scene.h"
#include "penumbra/scene_io/spectrum.h"
#include "penumbra/scene_io/texture_io.h"

namespace penumbra {

/// White for an empty one. Cost: linear.
Color mean_color(const Texture& texture);

/// How an image's coordinates come from a mesh's: scale, then offset.
struct PbrtUvMap {
  double scale_u = 1, scale_v = 1, offset_u = 0, offset_v = 0;

  bool operator==(const PbrtUvMap&) const = default;
};

/// What a surface's colour is.
struct PbrtPaint {
  Color color{};              ///< of the whole surface, or what multiplies the image
  std::int32_t texture = -1;  ///< index in the scene, or -1
  PbrtUvMap map;
  Color mean{};  ///< of all of it
};

/// What a texture is of: pbrt looks names up among those of colours or those of numbers.
enum class PbrtTextureOf { colors, numbers };

class PbrtTextures {
 public:
  explicit PbrtTextures(PbrtScene& pbrt)
      : pbrt_(pbrt), loader_(pbrt.source, pbrt.scene, pbrt.warnings) {}

  /// The colour of a parameter of any kind; `otherwise` where there is none of that name.
  PbrtPaint paint(const PbrtParams& params, std::string_view name, Color otherwise,
                  PbrtTextureOf of = PbrtTextureOf::colors);
  /// A parameter that must be one number, of a texture the mean.
  double number(const PbrtParams& params, std::string_view name, double otherwise);

 private:
  PbrtPaint named(const std::string& name, PbrtPlace place, PbrtTextureOf of);
  PbrtPaint make(const PbrtDefinition& definition, PbrtTextureOf of);
  PbrtPaint image(const PbrtDefinition& definition);
  PbrtPaint scaled(const PbrtDefinition& definition, PbrtTextureOf of);
  PbrtPaint mixed(const PbrtDefinition& definition, PbrtTextureOf of);
  PbrtPaint checkerboard(const PbrtDefinition& definition, PbrtTextureOf of);
  PbrtPaint mean_only(const PbrtPaint& paint, std::string_view kind, PbrtPlace place);

  PbrtScene& pbrt_;
  TextureLoader loader_;
  std::map<const PbrtDefinition*, PbrtPaint> known_;
  std::size_t depth_ = 0;
};

}  // namespace penumbra
