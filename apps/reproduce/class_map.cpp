// SPDX-License-Identifier: MIT
#include "class_map.h"

#include <array>
#include <cmath>
#include <vector>

#include "penumbra/scene/error.h"

namespace penumbra::reproduce {
namespace {

/// sRGB codes of lit, penumbra, umbra, and of nothing. The lightness of the classes falls in this
/// order, so that grey prints and colour-blind readers keep it.
constexpr std::array<std::array<float, 3>, 4> colors = {
    {{255, 242, 194}, {224, 84, 30}, {22, 38, 96}, {160, 160, 160}}};

std::size_t color_index(float light_class) {
  return light_class < 0.5f ? 0 : light_class < 1.5f ? 1 : 2;
}

}  // namespace

Image class_map(const Image& picture) {
  const Channel* classes = find_channel(picture, "class.light0");
  const Channel* depth = find_channel(picture, "depth.Z");
  if (!classes)
    throw Error({}, "the picture has no layer of shadow classes", "render it with the layer class");
  const std::size_t count = classes->values.size();
  Image map{picture.width, picture.height, {}, {}};
  for (std::size_t color = 0; color < 3; ++color) {
    Channel channel{std::string(1, "RGB"[color]), std::vector<float>(count)};
    for (std::size_t i = 0; i < count; ++i) {
      const bool is_hit = !depth || std::isfinite(depth->values[i]);
      const std::size_t index = is_hit ? color_index(classes->values[i]) : 3;
      channel.values[i] = linear_from_srgb(colors[index][color] / 255);
    }
    map.channels.push_back(std::move(channel));
  }
  return map;
}

}  // namespace penumbra::reproduce
