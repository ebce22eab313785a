// SPDX-License-Identifier: MIT
#include "penumbra/scene/image.h"

#include <algorithm>
#include <cmath>

namespace penumbra {

const Channel* find_channel(const Image& image, std::string_view name) {
  const auto found = std::find_if(image.channels.begin(), image.channels.end(),
                                  [&](const Channel& channel) { return channel.name == name; });
  return found == image.channels.end() ? nullptr : &*found;
}

std::uint8_t srgb_from_linear(float value) {
  if (!(value > 0)) return 0;  // NaN too
  const double linear = std::min(static_cast<double>(value), 1.0);
  const double code =
      linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::min(255.0, std::floor(255 * code + 0.5)));
}

float linear_from_srgb(float code) {
  const double c = code;
  return static_cast<float>(c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4));
}

}  // namespace penumbra
