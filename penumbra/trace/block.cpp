// SPDX-License-Identifier: MIT
#include "penumbra/trace/block.h"

#include "penumbra/trace/layers.h"
#include "penumbra/trace/z_order.h"

namespace penumbra {
namespace {

/// Blocks are counted row by row.
std::uint32_t number_of(Area block, std::uint32_t width) {
  const std::uint32_t across = (width + block_edge - 1) / block_edge;
  return block.y_begin / block_edge * across + block.x_begin / block_edge;
}

/// Samples of a block's pixels on their way into the picture, a wave at a time.
class BlockRenderer {
 public:
  BlockRenderer(const TraceContext& context, const RenderOptions& options, std::uint32_t block,
                VisibilityScratch& visibility, Image& image)
      : context_(context),
        options_(options),
        image_(image),
        scratch_(visibility, context.scene.lights.size()) {
    if (options.observe) scratch_.observe = &options.observe;
    scratch_.block = block;
  }

  void add_pixel(std::size_t pixel, const std::vector<CameraRay>& rays) {
    for (const CameraRay& ray : rays) {
      wave_.push_back(
          {ray.origin, ray.direction, ray.key, static_cast<std::uint32_t>(wave_.size())});
      pixel_of_.push_back(pixel);
      if (wave_.size() == most_rays) flush();
    }
  }

  /// Traces what is left; returns counters and times.
  TraceScratch finish() && {
    flush();
    store_pixel();
    return std::move(scratch_);
  }

 private:
  static constexpr std::size_t most_rays = block_edge * block_edge;

  void flush() {
    std::vector<RayNode> nodes;
    const bool wants_nodes = !options_.aovs.empty();
    const std::vector<TreeResult> trees =
        trace(context_, wave_, scratch_, wants_nodes ? &nodes : nullptr);
    for (std::size_t i = 0; i < trees.size(); ++i) {
      if (pixel_of_[i] != pixel_) store_pixel();
      pixel_ = pixel_of_[i];
      sum_ += Vec3d(trees[i].color);
      result_.shadow_rays += trees[i].shadow_rays;
      if (wants_nodes) result_.primary.push_back(std::move(nodes[i]));
    }
    wave_.clear(), pixel_of_.clear();
  }

  /// Its samples are done.
  void store_pixel() {
    if (pixel_ == no_pixel) return;
    result_.color = Color(sum_ / static_cast<double>(options_.samples_per_pixel));
    store(result_, options_.aovs, context_.scene, pixel_, image_);
    pixel_ = no_pixel, sum_ = {}, result_ = {};
  }

  static constexpr std::size_t no_pixel = SIZE_MAX;
  const TraceContext& context_;
  const RenderOptions& options_;
  Image& image_;
  std::vector<WaveRay> wave_;
  std::vector<std::size_t> pixel_of_;  // of each ray of the wave
  std::size_t pixel_ = no_pixel;       // whose samples are summed, in double and in order
  Vec3d sum_;
  PixelResult result_;
  TraceScratch scratch_;
};

}  // namespace

TraceScratch render_block(const TraceContext& context, const RenderOptions& options,
                          const CameraRays& camera, Area block, VisibilityScratch& visibility,
                          Image& image) {
  BlockRenderer renderer(context, options, number_of(block, options.width), visibility, image);
  std::vector<CameraRay> rays;
  for (const Pixel pixel : z_order(block)) {
    camera.of_pixel(pixel.x, pixel.y, rays);
    renderer.add_pixel(std::size_t(pixel.y) * options.width + pixel.x, rays);
  }
  return std::move(renderer).finish();
}

}  // namespace penumbra
