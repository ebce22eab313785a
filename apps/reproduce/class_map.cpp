// SPDX-License-Identifier: MIT
#include "class_map.h"

#include <algorithm>
#include <array>
#include <vector>

#include "penumbra/scene/error.h"

namespace penumbra::reproduce {
namespace {

/// sRGB codes in the order of the classes' numbers: lit, penumbra, umbra. Their lightness falls in
/// that order, so that grey prints and colour-blind readers keep it.
constexpr std::array<std::array<float, 3>, 3> class_colors = {
    {{255, 242, 194}, {224, 84, 30}, {22, 38, 96}}};

std::vector<const Channel*> class_channels(const Image& picture) {
  std::vector<const Channel*> channels;
  const std::size_t count = std::size_t{picture.width} * picture.height;
  for (const Channel& channel : picture.channels)
    if (channel.name.starts_with("class.light") && channel.values.size() == count)
      channels.push_back(&channel);
  return channels;
}

std::size_t color_index(float light_class) {
  return light_class < 0.5f ? 0 : light_class < 1.5f ? 1 : 2;
}

}  // namespace

Image class_map(const Image& picture) {
  const std::vector<const Channel*> lights = class_channels(picture);
  if (lights.empty())
    throw Error({}, "the picture has no layer of shadow classes", "render it with the layer class");
  const std::size_t count = std::size_t{picture.width} * picture.height;
  Image map{picture.width, picture.height, {}, {}};
  for (std::size_t color = 0; color < 3; ++color) {
    Channel channel{std::string(1, "RGB"[color]), std::vector<float>(count)};
    for (const Channel* light : lights)
      for (std::size_t i = 0; i < count; ++i)
        channel.values[i] += class_colors[color_index(light->values[i])][color];
    const float most = 255 * static_cast<float>(lights.size());
    for (float& value : channel.values) value = linear_from_srgb(value / most);
    map.channels.push_back(std::move(channel));
  }
  return map;
}

}  // namespace penumbra::reproduce
