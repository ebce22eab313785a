// SPDX-License-Identifier: MIT
// The trees of rays behind the samples of pixels (Whitted 1980): camera rays, reflections,
// refractions. Trees of neighbouring pixels grow together, in waves: all rays of a wave stand at
// the same node of their trees, so that their questions of visibility can be answered together.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "penumbra/kernel/kernel.h"
#include "penumbra/scene/scene.h"
#include "penumbra/shadow/visibility.h"
#include "penumbra/trace/render.h"
#include "penumbra/trace/shading.h"

namespace penumbra {

/// What all rays of a picture share.
struct TraceContext {
  const Scene& scene;
  const ShadowScene& shadows;
  std::uint32_t depth;
};

/// What one thread owns while it works on a block of pixels.
struct TraceScratch {
  TraceScratch(VisibilityScratch& thread, std::size_t lights) : visibility(thread), cache(lights) {}
  VisibilityScratch& visibility;  // outlives the block
  OccluderCache cache;
  RenderCounters counters;
  double shadow_seconds = 0;
  const std::function<void(const AnsweredBatch&)>* observe = nullptr;  ///< may be null
  std::uint32_t block = 0;                                             ///< what it is told of
};

/// A ray of a wave.
struct WaveRay {
  Vec3d origin, direction;
  std::uint64_t sample_key;  ///< identifies pixel and sample
  std::uint32_t tree;        ///< which of the trees that grow together it belongs to
};

/// What a tree comes to.
struct TreeResult {
  Color color;
  std::uint64_t shadow_rays = 0;
};

/// A node of a ray tree, for those who want to look inside (`explain_pixel`, layers of the primary
/// hit).
struct RayNode {
  std::uint64_t path;  ///< 1: camera ray; 2 path: reflected from there; 2 path + 1: refracted
  std::optional<Hit> hit;
  ShadingPoint point;             ///< where there is a hit
  std::vector<Visibility> light;  ///< of each light
  std::vector<Color> unshadowed;  ///< U of each light
};

/// Traces the trees of camera rays; ray i has `tree` i. Neighbours in the wave should be neighbours
/// in the picture. Nodes are appended to `nodes` if it is not null: first those of the camera rays,
/// in their order, then wave by wave. Memory: linear in rays and depth.
std::vector<TreeResult> trace(const TraceContext& context, std::span<const WaveRay> camera_rays,
                              TraceScratch& scratch, std::vector<RayNode>* nodes);

}  // namespace penumbra
