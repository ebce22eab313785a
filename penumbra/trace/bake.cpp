// SPDX-License-Identifier: MIT
#include "penumbra/trace/bake.h"

#include <fmt/format.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <mutex>
#include <utility>

#include "penumbra/kernel/more_threads.h"
#include "penumbra/trace/bake_block.h"
#include "penumbra/trace/clock.h"
#include "penumbra/trace/dilate.h"

namespace penumbra {

void BakeCounters::add(const BakeCounters& other) {
  covered += other.covered, padded += other.padded, overlapping += other.overlapping;
  lit += other.lit, penumbra += other.penumbra, umbra += other.umbra;
  proven_samples += other.proven_samples, asked_samples += other.asked_samples;
  shadow.add(other.shadow);
}

namespace {

Image make_planes(const BakeOptions& options, std::size_t lights) {
  Image image{options.width, options.height, {}, {}};
  const auto add = [&](std::string name, float value) {
    const std::size_t texels = std::size_t(options.width) * options.height;
    image.channels.push_back({std::move(name), std::vector<float>(texels, value)});
  };
  for (std::size_t i = 0; i < lights; ++i)
    add(fmt::format("visibility.light{}", i), options.background);
  for (std::size_t i = 0; i < lights && options.has_classes; ++i)
    add(fmt::format("class.light{}", i), 0);
  add("coverage", 0);
  return image;
}

BakePlanes planes_of(Image& image, const BakeOptions& options, std::size_t lights) {
  BakePlanes planes;
  for (std::size_t i = 0; i < lights; ++i) {
    planes.visibility.push_back(&image.channels[i]);
    if (options.has_classes) planes.light_class.push_back(&image.channels[lights + i]);
  }
  planes.covered.resize(std::size_t(image.width) * image.height);
  return planes;
}

/// Fills the texels around charts; returns how many.
std::uint64_t pad(const BakePlanes& planes, std::uint32_t padding, Image& image) {
  std::vector<float>& coverage = image.channels.back().values;
  const std::vector<std::uint32_t> source =
      nearest_covered(planes.covered, image.width, image.height, padding);
  std::uint64_t padded = 0;
  for (std::size_t i = 0; i < source.size(); ++i) {
    if (source[i] == no_texel) continue;
    const bool is_covered = source[i] == i;
    coverage[i] = is_covered ? 1.0f : 0.5f;
    if (is_covered) continue;
    ++padded;
    for (const auto* channels : {&planes.visibility, &planes.light_class})
      for (Channel* channel : *channels) channel->values[i] = channel->values[source[i]];
  }
  return padded;
}

}  // namespace

Bake bake(const Scene& scene, const ShadowScene& shadows, const UvAtlas& atlas,
          const BakeOptions& options) {
  const double start = now_seconds();
  const std::size_t lights = shadows.lights.size();
  Bake result;
  result.image = make_planes(options, lights);
  result.threads = options.threads > 0
                       ? options.threads
                       : static_cast<std::uint32_t>(tbb::this_task_arena::max_concurrency());
  BakePlanes planes = planes_of(result.image, options, lights);
  const BakeContext context{scene, shadows, atlas, options, SamplePattern(options.texel_samples)};
  std::mutex mutex;
  std::size_t done = 0;
  const auto finish = [&](const BakeCounters& counters) {
    const std::lock_guard lock(mutex);
    result.counters.add(counters);
    ++done;
    if (options.progress) options.progress(double(done) / double(atlas.block_count()));
  };
  const MoreThreads allowed(result.threads);
  tbb::enumerable_thread_specific<VisibilityScratch> memory(options.shadow_samples);
  tbb::task_arena arena(static_cast<int>(result.threads));
  arena.execute([&] {
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, atlas.block_count(), 1),
        [&](const tbb::blocked_range<std::size_t>& range) {
          for (std::size_t i = range.begin(); i < range.end(); ++i)
            finish(atlas.block(i).empty() ? BakeCounters{}
                                          : bake_block(context, i, memory.local(), planes));
        },
        tbb::simple_partitioner());
  });
  result.counters.padded = pad(planes, options.padding, result.image);
  result.seconds = now_seconds() - start;
  return result;
}

}  // namespace penumbra
