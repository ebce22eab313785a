// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstddef>

#include "penumbra/scene/material.h"

namespace penumbra {

namespace {

/// The two texels around a coordinate that repeats every 1, and how far it is to the second.
struct Neighbours {
  std::uint32_t first = 0, second = 0;
  float fraction = 0;
};

Neighbours neighbours(float coordinate, std::uint32_t texels) {
  double wrapped = coordinate - std::floor(static_cast<double>(coordinate));
  if (!(wrapped >= 0 && wrapped < 1)) wrapped = 0;  // not finite
  // Texel i has its centre at (i + 0.5) / texels.
  const double at = wrapped * texels + texels - 0.5;
  const double below = std::floor(at);
  const auto first = static_cast<std::uint64_t>(below) % texels;
  return {static_cast<std::uint32_t>(first), static_cast<std::uint32_t>((first + 1) % texels),
          static_cast<float>(at - below)};
}

Color mix(Color a, Color b, float t) { return a * (1 - t) + b * t; }

}  // namespace

Color sample(const Texture& texture, Vec2f uv) {
  if (texture.pixels.empty() || texture.width == 0 || texture.height == 0) return {1, 1, 1};
  const Neighbours x = neighbours(uv.u, texture.width);
  const Neighbours y = neighbours(1 - uv.v, texture.height);
  const auto texel = [&](std::uint32_t column, std::uint32_t row) {
    return texture.pixels[std::size_t{row} * texture.width + column];
  };
  return mix(mix(texel(x.first, y.first), texel(x.second, y.first), x.fraction),
             mix(texel(x.first, y.second), texel(x.second, y.second), x.fraction), y.fraction);
}

}  // namespace penumbra
