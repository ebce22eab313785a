// SPDX-License-Identifier: MIT
#include "answer_points.h"

#include <algorithm>
#include <limits>

#include "penumbra/geometry/sample_pattern.h"
#include "penumbra/trace/prepare.h"
#include "penumbra/trace/shadow_work.h"

namespace penumbra {

struct PointAnswerer::Data {
  const Scene& scene;
  AnswerOptions options;
  Kernel kernel;
  ShadowScene shadows;

  Data(const Scene& s, const AnswerOptions& o)
      : scene(s),
        options(o),
        kernel(s.shapes, kernel_options(s)),
        shadows(prepare_shadows(s, kernel, o.method)) {}
};

PointAnswerer::PointAnswerer(const Scene& scene, const AnswerOptions& options)
    : data_(std::make_unique<Data>(scene, options)) {}
PointAnswerer::~PointAnswerer() = default;

std::size_t PointAnswerer::memory_bytes() const {
  return data_->kernel.memory_bytes() + data_->shadows.memory_bytes();
}

ShadowCounters PointAnswerer::answer(const PointBlock& points, std::uint64_t first,
                                     PointAnswers& answers) {
  const std::size_t lights = data_->scene.lights.size(), count = points.positions.size();
  answers.classes.resize(count * lights);
  answers.fractions.resize(count * lights);
  std::vector<Visibility> seen(count);
  ShadowCounters counters;
  VisibilityScratch scratch(data_->options.shadow_samples);
  OccluderCache cache(lights);
  for (std::uint32_t light = 0; light < lights; ++light) {
    std::vector<ShadowQuery> queries;
    for (std::size_t i = 0; i < count; ++i) {
      const Vec3f n = points.normals.empty() ? Vec3f{} : normalize(points.normals[i]);
      const float offset = data_->options.offset.value_or(
          64 * std::numeric_limits<float>::epsilon() * max_abs(points.positions[i]));
      queries.push_back(
          {{points.positions[i] + offset * n, n},
           light_key((data_->options.seed ? hash(data_->options.seed, 0) : 0) + first + i, light)});
    }
    visibilities(data_->shadows, light, queries, cache.queue(1, light), scratch, counters, seen);
    for (std::size_t i = 0; i < count; ++i) {
      answers.classes[i * lights + light] = static_cast<std::uint8_t>(seen[i].shadow_class);
      answers.fractions[i * lights + light] = seen[i].fraction;
    }
  }
  return counters;
}

}  // namespace penumbra
