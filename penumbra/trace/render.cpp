// SPDX-License-Identifier: MIT
#include "penumbra/trace/render.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <mutex>

#include "penumbra/kernel/more_threads.h"
#include "penumbra/trace/block.h"
#include "penumbra/trace/clock.h"
#include "penumbra/trace/layers.h"
#include "penumbra/trace/pixel.h"

namespace penumbra {

void RenderCounters::add(const RenderCounters& other) {
  primary += other.primary, reflected += other.reflected, refracted += other.refracted;
  closest_tests += other.closest_tests;
  shadow.add(other.shadow);
}

namespace {

/// Totals over tiles. Integers, so that the order in which tiles end does not matter.
class Totals {
 public:
  Totals(std::uint64_t pixels, std::function<void(double)> progress)
      : pixels_(pixels), progress_(std::move(progress)) {}

  void add(const TraceScratch& tile, std::uint64_t pixels) {
    const std::lock_guard lock(mutex_);
    counters.add(tile.counters);
    shadow_seconds += tile.shadow_seconds;
    done_ += pixels;
    if (progress_) progress_(static_cast<double>(done_) / static_cast<double>(pixels_));
  }

  RenderCounters counters;
  double shadow_seconds = 0;

 private:
  std::mutex mutex_;
  std::uint64_t done_ = 0, pixels_;
  std::function<void(double)> progress_;
};

/// An area cut into squares, row by row.
class Squares {
 public:
  Squares(Area area, std::uint32_t edge)
      : area_(area), edge_(edge), across_((area.x_end - area.x_begin + edge - 1) / edge) {}
  std::uint32_t count() const {
    return across_ * ((area_.y_end - area_.y_begin + edge_ - 1) / edge_);
  }
  Area operator[](std::uint32_t index) const {
    const std::uint32_t x = area_.x_begin + index % across_ * edge_;
    const std::uint32_t y = area_.y_begin + index / across_ * edge_;
    return {x, std::min(x + edge_, area_.x_end), y, std::min(y + edge_, area_.y_end)};
  }

 private:
  Area area_;
  std::uint32_t edge_, across_;
};

}  // namespace

Picture render(const Scene& scene, const ShadowScene& shadows, const RenderOptions& options) {
  const double start = now_seconds();
  Picture picture;
  picture.image = make_layers(options.width, options.height, options.aovs, scene.lights.size());
  picture.threads = options.threads > 0
                        ? options.threads
                        : static_cast<std::uint32_t>(tbb::this_task_arena::max_concurrency());
  const CameraRays camera(*scene.camera, options);
  const TraceContext context{scene, shadows, options.depth};
  Totals totals(std::uint64_t(options.width) * options.height, options.progress);
  const std::uint32_t edge = (options.tile + block_edge - 1) / block_edge * block_edge;
  const Squares tiles({0, options.width, 0, options.height}, edge);
  const MoreThreads allowed(picture.threads);
  tbb::enumerable_thread_specific<VisibilityScratch> memory(options.shadow_samples);
  tbb::task_arena arena(static_cast<int>(picture.threads));
  arena.execute([&] {
    tbb::parallel_for(
        tbb::blocked_range<std::uint32_t>(0, tiles.count(), 1),
        [&](const tbb::blocked_range<std::uint32_t>& range) {
          for (std::uint32_t i = range.begin(); i < range.end(); ++i) {
            const Squares blocks(tiles[i], block_edge);
            for (std::uint32_t k = 0; k < blocks.count(); ++k)
              totals.add(
                  render_block(context, options, camera, blocks[k], memory.local(), picture.image),
                  blocks[k].pixels());
          }
        },
        tbb::simple_partitioner());
  });
  picture.counters = totals.counters;
  picture.seconds.shadow = totals.shadow_seconds / picture.threads;
  picture.seconds.render = now_seconds() - start;
  return picture;
}

}  // namespace penumbra
