// SPDX-License-Identifier: MIT
#include "answer_points.h"

#include <utility>

#include "penumbra/geometry/sample_pattern.h"
#include "penumbra/visibility/scene_occluders.h"

namespace penumbra {

struct PointAnswerer::Data {
  Occluders occluders;
  std::vector<LightShape> lights;
  AnswerOptions options;
  std::uint64_t first_key = 0;
  std::vector<Visibility> seen;
  std::vector<ShadowClass> proven;
};

PointAnswerer::PointAnswerer(const Scene& scene, const AnswerOptions& options)
    : data_(std::make_unique<Data>()) {
  data_->occluders = occluders_of(scene);
  for (const Light& light : scene.lights) data_->lights.push_back(light.shape);
  data_->options = options;
  if (options.seed != 0) data_->first_key = hash(options.seed, 0);
}

PointAnswerer::~PointAnswerer() = default;

std::size_t PointAnswerer::memory_bytes() const { return data_->occluders.memory_bytes(); }

ShadowCounters PointAnswerer::answer(const PointBlock& points, std::uint64_t first,
                                     PointAnswers& answers,
                                     const std::function<void(double)>& progress) {
  Data& data = *data_;
  const std::size_t lights = data.lights.size(), count = points.positions.size();
  const bool has_fractions = data.options.has_fractions;
  answers.classes.resize(count * lights);
  answers.fractions.resize(has_fractions ? count * lights : 0);
  data.seen.resize(has_fractions ? count : 0);
  data.proven.resize(has_fractions ? 0 : count);
  const Points asked{.positions = std::span(points.positions),
                     .normals = std::span(points.normals),
                     .offset = data.options.offset,
                     .first_key = data.first_key + first};
  ShadowCounters counters;
  for (std::size_t light = 0; light < lights; ++light) {
    const auto report = [&](double share) {
      progress((static_cast<double>(light) + share) / static_cast<double>(lights));
      return true;
    };
    const AskOptions how{.shadow_samples = data.options.shadow_samples,
                         .method = data.options.method,
                         .light_index = static_cast<std::uint32_t>(light),
                         .threads = data.options.threads,
                         .progress = report};
    const LightShape& shape = data.lights[light];
    if (!has_fractions) {
      counters.add(data.occluders.classify(asked, shape, data.proven, how));
      for (std::size_t i = 0, k = light; i < count; ++i, k += lights)
        answers.classes[k] = static_cast<std::uint8_t>(data.proven[i]);
      continue;
    }
    counters.add(data.occluders.visibility(asked, shape, data.seen, how));
    for (std::size_t i = 0, k = light; i < count; ++i, k += lights) {
      answers.classes[k] = static_cast<std::uint8_t>(data.seen[i].shadow_class);
      answers.fractions[k] = data.seen[i].fraction;
    }
  }
  return counters;
}

}  // namespace penumbra
