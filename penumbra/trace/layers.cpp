// SPDX-License-Identifier: MIT
#include "penumbra/trace/layers.h"

#include <fmt/format.h>

#include <limits>

namespace penumbra {
namespace {

std::vector<std::string> channel_names(Aov aov, std::size_t lights) {
  std::vector<std::string> names;
  const auto each_light = [&](const char* layer) {
    for (std::size_t i = 0; i < lights; ++i) names.push_back(fmt::format("{}.light{}", layer, i));
  };
  switch (aov) {
    case Aov::light_class: each_light("class"); break;
    case Aov::visibility: each_light("visibility"); break;
    case Aov::depth: names = {"depth.Z"}; break;
    case Aov::normal: names = {"normal.X", "normal.Y", "normal.Z"}; break;
    case Aov::samples: names = {"samples.count"}; break;
  }
  return names;
}

std::vector<float> light_classes(const PixelResult& result, std::size_t lights) {
  std::vector<float> values(lights, 0);
  const RayNode& first = result.primary.front();
  for (std::size_t i = 0; i < first.light.size(); ++i)
    values[i] = static_cast<float>(first.light[i].shadow_class);
  return values;
}

std::vector<float> mean_visibilities(const PixelResult& result, std::size_t lights) {
  std::vector<float> values(lights, 0);
  std::size_t hits = 0;
  for (const RayNode& node : result.primary) {
    if (!node.hit) continue;
    ++hits;
    for (std::size_t i = 0; i < lights; ++i) values[i] += node.light[i].cosine_weighted;
  }
  for (float& value : values) value = hits > 0 ? value / static_cast<float>(hits) : 1.0f;
  return values;
}

float depth_of(const RayNode& node, const Camera& camera) {
  if (!node.hit) return std::numeric_limits<float>::infinity();
  return static_cast<float>(
      dot(node.point.surface.position - camera.from, normalize(camera.at - camera.from)));
}

std::vector<float> values_of(Aov aov, const PixelResult& result, const Camera& camera,
                             std::size_t lights) {
  switch (aov) {
    case Aov::light_class: return light_classes(result, lights);
    case Aov::visibility: return mean_visibilities(result, lights);
    case Aov::depth: return {depth_of(result.primary.front(), camera)};
    case Aov::normal: {
      const Vec3f n = result.primary.front().point.shading_normal;
      return {n.x, n.y, n.z};
    }
    case Aov::samples: break;
  }
  return {static_cast<float>(result.shadow_rays)};
}

}  // namespace

Image make_layers(std::uint32_t width, std::uint32_t height, const std::vector<Aov>& aovs,
                  std::size_t lights) {
  Image image{width, height, {}, {}};
  const auto add = [&](std::string name) {
    image.channels.push_back({std::move(name), std::vector<float>(std::size_t(width) * height)});
  };
  for (const char* name : {"R", "G", "B"}) add(name);
  for (Aov aov : aovs)
    for (std::string& name : channel_names(aov, lights)) add(std::move(name));
  return image;
}

void store(const PixelResult& result, const std::vector<Aov>& aovs, const Scene& scene,
           std::size_t pixel, Image& image) {
  auto channel = image.channels.begin();
  for (float value : {result.color.x, result.color.y, result.color.z})
    (channel++)->values[pixel] = value;
  for (Aov aov : aovs)
    for (float value : values_of(aov, result, *scene.camera, scene.lights.size()))
      (channel++)->values[pixel] = value;
}

}  // namespace penumbra
